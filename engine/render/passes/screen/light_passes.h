// Passes over the whole image between the scene and bloom. Each has its images only while frames ask for
// it; null says that the driver has no memory for them, or that a shader does not compile.
#pragma once

#include "engine/render/passes/pass_context.h"
#include "engine/render/passes/scene_light.h"
#include "engine/render/passes/screen/motion_vectors.h"
#include "engine/render/passes/screen/pass_image.h"
#include "engine/render/setup/frame_setup.h"

#include <cstddef>

namespace plumbline::render {

/// What a pass found, and an image of the same size to smooth it by.
struct PairImages {
    PassImage found;
    PassImage spare;
    std::size_t bytes() const { return found.image.bytes() + spare.image.bytes(); }
};

/// Which share of the light from everywhere reaches each place of the image, from its depth image: half as
/// wide and as high, visibility 0…1 and metres along the line of sight.
const gl::Texture* find_occlusion(const FrameSetup& setup,
                                  const gl::Texture& depth,
                                  PairImages& images,
                                  PassContext context);

/// Which share of the sun's light the air sends to each place of the image: a quarter as wide and as high,
/// the share and metres along the line of sight. `sun_shadow_map` is null without shadows.
const gl::Texture* find_shafts(const FrameSetup& setup,
                               const gl::Texture& depth,
                               const gl::Texture* sun_shadow_map,
                               PairImages& images,
                               PassContext context);

struct FocusImages {
    PassImage half;
    PassImage blurred;
    PassImage joined;
    std::size_t bytes() const {
        return half.image.bytes() + blurred.image.bytes() + joined.image.bytes();
    }
};

/// The light through a lens, sharp at one distance; as large as the scene's image.
const gl::Texture* see_through_lens(const FrameSetup& setup,
                                    const SceneLight& light,
                                    FocusImages& images,
                                    PassContext context);

struct MotionBlurImages {
    PassImage blurred;
    MotionVectors motion_vectors;
    std::size_t bytes() const { return blurred.image.bytes() + motion_vectors.bytes(); }
};

/// The light as a shutter sees it that stays open while the camera moves; as large as the scene's image.
const gl::Texture* blur_motion(const FrameSetup& setup,
                               const SceneLight& light,
                               MotionBlurImages& images,
                               PassContext context);

}  // namespace plumbline::render
