// The sky behind all that is opaque, and the fog between the eye and both.
#pragma once

#include "engine/render/passes/pass_context.h"
#include "engine/render/passes/scene_target.h"
#include "engine/render/setup/frame_setup.h"

namespace plumbline::render {

/// At the far plane, where nothing was drawn. `writes_codes`: the target holds sRGB codes.
void render_sky(bool writes_codes, PassContext context);

/// Blends the fog's colour over the scene's light by its depth. What blends is drawn afterwards and has
/// fog in its own shader.
void render_fog(const FrameSetup& setup, SceneTarget& scene, PassContext context);

}  // namespace plumbline::render
