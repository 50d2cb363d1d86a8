// Passes of a frame as functions of its setup and of the images of the passes before. A pass writes into
// its own images only.
#pragma once

#include "engine/render/passes/light_shadow_pass.h"
#include "engine/render/passes/refraction_pass.h"
#include "engine/render/passes/screen/exposure_meter.h"
#include "engine/render/passes/screen/light_passes.h"
#include "engine/render/passes/shadow_pass.h"
#include "engine/render/resources/samplers.h"
#include "engine/render/setup/frame_setup.h"

#include <optional>

namespace plumbline::render {

struct ShadowPasses {
    ShadowPass sun;
    ShadowPass flashlight;
    LightShadowPass lamps;
};

/// Null: there is no such map in the frame.
struct ShadowMaps {
    const gl::Texture* sun{nullptr};
    const gl::Texture* flashlight{nullptr};
    const gl::Texture* lamps{nullptr};
};

/// What the passes that read the scene's light draw into, in their order.
struct LightPasses {
    PairImages occlusion;
    PairImages shafts;
    FocusImages focus;
    MotionBlurImages motion_blur;
    ExposureMeter exposure;
};

/// Frees the maps that the frame has no use for.
ShadowMaps draw_shadow_maps(const FrameSetup& setup, ShadowPasses& passes, PassContext context);

/// Binds what the mesh shader reads of light: shadow maps and what mirrors show of the sky.
void bind_light_images(const FrameSetup& setup,
                       const ShadowMaps& maps,
                       const SceneResources& resources,
                       Samplers& samplers);

/// Of the finished image's height, as much as the scene's image has.
float share_of_height(const ImagePlan& image);

/// The background, as the image holds it.
Vec3f background_of(const FrameSetup& setup);

/// The part of the scene that lies behind water, copied and bound for the water to show; nothing where no
/// water shows it, or the driver has no memory.
std::optional<PixelPart> copy_behind_water(const FrameSetup& setup,
                                           const SceneTarget& scene,
                                           RefractionPass& pass,
                                           PassContext context);

/// Runs the passes between the scene and bloom; frees those that the frame does not ask for.
SceneLight finish_light(const FrameSetup& setup,
                        const SceneTarget& scene,
                        const ShadowMaps& maps,
                        LightPasses& passes,
                        PassContext context);

/// What to multiply the frame's exposure with; nothing: it does not adapt.
std::optional<float> measured_exposure(const FrameSetup& setup,
                                       const Device& device,
                                       const SceneTarget& scene,
                                       LightPasses& passes,
                                       PassContext context);

}  // namespace plumbline::render
