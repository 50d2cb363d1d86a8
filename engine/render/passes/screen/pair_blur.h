// Smooths images of something found in a pattern of four by four pixels, and of the distance.
#pragma once

#include "engine/render/passes/scene_resources.h"
#include "engine/render/passes/screen/pass_image.h"
#include "engine/render/passes/sky_pass.h"

namespace plumbline::render {

/// What a pass found, and an image of the same size to smooth it by.
struct PairImages {
    PassImage found;
    PassImage spare;

    /// False: the driver has no memory for them, and they are freed.
    bool resize(PixelSize size_px);
    std::size_t bytes() const { return found.image.bytes() + spare.image.bytes(); }
};

/// In place. Not across the edges of things.
void blur_pairs(const PairImages& images,
                const FullscreenTriangle& triangle,
                SceneResources& resources,
                FrameStats& stats);

}  // namespace plumbline::render
