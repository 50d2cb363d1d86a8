// Smooths images of something found in a pattern of four by four pixels, and of the distance.
#pragma once

#include "engine/render/passes/scene_resources.h"
#include "engine/render/passes/screen/pass_image.h"
#include "engine/render/passes/sky_pass.h"

namespace plumbline::render {

/// In place; `spare` has the same size. Not across the edges of things.
void blur_pairs(const PassImage& found,
                const PassImage& spare,
                const FullscreenTriangle& triangle,
                SceneResources& resources,
                FrameStats& stats);

}  // namespace plumbline::render
