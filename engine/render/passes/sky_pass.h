// The sky behind all that is opaque.
#pragma once

#include "engine/render/passes/pass_context.h"

namespace plumbline::render {

/// At the far plane, where nothing was drawn. `writes_codes`: the target holds sRGB codes.
void render_sky(bool writes_codes, PassContext context);

}  // namespace plumbline::render
