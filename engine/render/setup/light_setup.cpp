// Lights of a frame: the sun or the moon, the flashlight, lamps, and where their shadow maps look.
#include "engine/render/culling/frustum.h"
#include "engine/render/light/shadow_fit.h"
#include "engine/render/setup/frame_setup.h"

#include <algorithm>
#include <cmath>

namespace plumbline::render {
namespace {

/// Clip volume of OpenGL (-1…1) to texture coordinates and depth (0…1).
const Mat4f kTextureFromClip{Vec4f{0.5F, 0.0F, 0.0F, 0.0F},
                             Vec4f{0.0F, 0.5F, 0.0F, 0.0F},
                             Vec4f{0.0F, 0.0F, 0.5F, 0.0F},
                             Vec4f{0.5F, 0.5F, 0.5F, 1.0F}};

/// A light this near to the eye lights all that the eye sees: its shadows are narrower than any pixel.
constexpr float kAtEye_m = 1e-5F;

/// The sun as it reaches the ground: a computed sky's sun or moon, none while neither shines.
std::optional<DirectionalLight> sun_of(const RenderFrame& frame, const ComputedSky* sky) {
    if (!frame.sun_reaches_ground) return {};
    if (sky == nullptr) return frame.sun;
    const ComputedSky::KeyLight& light = sky->key_light();
    if (light.irradiance == Vec3f{0.0F}) return {};
    return DirectionalLight{.direction_world = -light.to_light_world, .radiance = light.irradiance};
}

/// The cascades of a sun's shadow map.
struct Cascades {
    std::uint32_t by_scene{1};
    std::uint32_t count{1};  ///< one more where shadows go on to the camera's far plane
    float by_scene_m{0.0F};
    float distance_m{0.0F};
    std::uint32_t size_px{0};

    float end_m(std::uint32_t i) const {
        return i < by_scene ? cascade_end_m(i, by_scene, by_scene_m) : distance_m;
    }
};

Cascades cascades_of(const RenderFrame& frame, const Quality& quality, std::uint32_t texture_px) {
    const SunShadow& shadow = *frame.sun_shadow;
    Cascades cascades{.by_scene = std::clamp<std::uint32_t>(shadow.cascades, 1, kMaxCascades),
                      .by_scene_m = std::max(shadow.distance_m, 1e-4F)};
    const bool goes_on = quality.far_shadows && cascades.by_scene < kMaxCascades &&
                         frame.camera.far_m > cascades.by_scene_m;
    cascades.count = goes_on ? cascades.by_scene + 1 : cascades.by_scene;
    cascades.distance_m = goes_on ? frame.camera.far_m : cascades.by_scene_m;
    const float scaled_px = std::round(static_cast<float>(shadow.size_px) * quality.shadow_detail);
    cascades.size_px =
        std::clamp(static_cast<std::uint32_t>(scaled_px), 1U, texture_px / cascades.count);
    return cascades;
}

/// The fits of all cascades, near to far; their places go into the block.
std::vector<SunShadowFit> fit_cascades(const Cascades& cascades,
                                       const ViewShape& view,
                                       const Vec3f& direction_world,
                                       FrameBlock& block) {
    std::vector<SunShadowFit> fits;
    // Unused ends lie beyond all: nothing is in a cascade that there is not.
    for (int i = 0; i + 1 < static_cast<int>(kMaxCascades); ++i) block.cascade_ends[i] = 1e9F;
    for (std::uint32_t i = 0; i < cascades.count; ++i) {
        fits.push_back(fit_sun_shadow(view, direction_world, cascades.end_m(i), cascades.size_px));
        if (i + 1 < cascades.count) block.cascade_ends[static_cast<int>(i)] = cascades.end_m(i);
        block.cascades[i] = cascade_from_first(fits.front(), fits.back());
    }
    block.sun_shadow_from_world = kTextureFromClip * fits.front().clip_from_world;
    block.camera_world.w = fits.front().texel_m;
    block.to_sun_world.w = 1.0F / cascades.distance_m;
    block.sun_radiance.w = 1.0F / static_cast<float>(cascades.size_px);
    block.clusters.z = 1.0F / static_cast<float>(cascades.count);
    block.clusters.w = 1.5F / (kSunMapDepth * static_cast<float>(cascades.size_px));
    return fits;
}

void set_up_sun_shadow(const RenderFrame& frame,
                       const ImagePlan& image,
                       const Device& device,
                       const Vec3f& direction_world,
                       SunSetup& sun,
                       FrameBlock& block) {
    const Camera& camera = frame.camera;
    const Quality& quality = image.quality;
    const Cascades cascades = cascades_of(frame, quality, device.limits.texture_px);
    const ViewShape view{.position_world = camera.position_world,
                         .forward_world = camera.orientation * Vec3f{0.0F, 0.0F, -1.0F},
                         .fov_y_rad = camera.fov_y_rad,
                         .aspect = image.aspect()};
    const std::vector<SunShadowFit> fits = fit_cascades(cascades, view, direction_world, block);
    // Half a texel of the map cannot be seen in it.
    const bool is_coarse = quality.lod_error_px > 0.0F;
    for (const SunShadowFit& fit : fits) {
        sun.shadow_views.push_back({.clip_from_world = fit.clip_from_world,
                                    .eye_world = camera.position_world - direction_world * 1e4F,
                                    .size_px = cascades.size_px,
                                    .bias_units = kShadowBias_units / kSunMapDepth,
                                    .error_m = is_coarse ? 0.5F * fit.texel_m : 0.0F});
    }
    const float angular_size_rad = frame.sun_shadow->angular_size_rad;
    sun.hardens_contacts = quality.contact_hardening != Drawn::Never && angular_size_rad > 0.0F;
    if (sun.hardens_contacts) {
        block.cascade_ends.w = kSunMapDepth * std::tan(0.5F * angular_size_rad);
    } else {
        // Filters and the way off the surface are a few texels; what the wind bends leaves its bounds.
        sun.shadow_margin_m = 4.0F * fits.back().texel_m + (frame.wind ? 1.0F : 0.0F);
    }
}

std::uint32_t lamp_shadow_px(const RenderFrame& frame,
                             const Quality& quality,
                             const GpuLimits& limits) {
    const bool wanted = frame.light_shadows && quality.shadowed_lights > 0 &&
                        std::ranges::any_of(frame.lights, &LocalLight::casts_shadow);
    if (!wanted) return 0;
    const float size_px = static_cast<float>(frame.light_shadows->size_px) * quality.shadow_detail;
    return std::clamp(static_cast<std::uint32_t>(size_px), 32U, limits.texture_px / kLightFaces);
}

}  // namespace

SunSetup set_up_sun(const RenderFrame& frame,
                    const ImagePlan& image,
                    const SetupInputs& inputs,
                    FrameBlock& block) {
    SunSetup sun{.light = sun_of(frame, inputs.sky.computed())};
    if (!sun.light) return sun;
    const Vec3f direction_world =
        normalize_or(sun.light->direction_world, Vec3f{0.0F, -1.0F, 0.0F});
    block.to_sun_world = Vec4f{-direction_world, 0.0F};
    block.sun_radiance = Vec4f{sun.light->radiance * kPerPi, 0.0F};
    if (frame.sun && frame.sun_shadow)
        set_up_sun_shadow(frame, image, inputs.device, direction_world, sun, block);
    return sun;
}

FlashlightSetup set_up_flashlight(const RenderFrame& frame, FrameBlock& block) {
    if (!frame.flashlight) return {};
    const Flashlight& light = *frame.flashlight;
    const Vec3f direction = normalize_or(light.direction_world, Vec3f{0.0F, 0.0F, -1.0F});
    const float outer_cos = std::cos(light.outer_rad);
    const float width = std::max(std::cos(light.inner_rad) - outer_cos, 1e-3F);
    const Mat4f clip_from_world =
        fit_spot_shadow(light.position_world, direction, light.outer_rad, light.radius_m);
    block.flashlight_shadow_from_world = kTextureFromClip * clip_from_world;
    block.flashlight_position = Vec4f{light.position_world, 1.0F / std::max(light.radius_m, 1e-3F)};
    block.flashlight_direction = Vec4f{direction, outer_cos};
    block.flashlight_intensity = Vec4f{light.intensity * kPerPi, 1.0F / width};
    block.ambient.w = 1.0F / static_cast<float>(light.shadow_size_px);
    FlashlightSetup setup{.beam = ConvexVolume::cone(
                              light.position_world, direction, light.outer_rad, light.radius_m)};
    if (glm::distance(light.position_world, frame.camera.position_world) >= kAtEye_m) {
        setup.shadow = {.clip_from_world = clip_from_world,
                        .eye_world = light.position_world,
                        .size_px = light.shadow_size_px};
    }
    return setup;
}

LampSetup set_up_lamps(const RenderFrame& frame,
                       const ImagePlan& image,
                       const SetupInputs& inputs,
                       FrameBlock& block) {
    LampSetup lamps{.choice = inputs.lamps_before,
                    .shadow_px = lamp_shadow_px(frame, image.quality, inputs.device.limits)};
    lamps.choice.choose(
        lamps.shadow_px > 0 ? std::span{frame.lights} : std::span<const LocalLight>{},
        Frustum{block.clip_from_world},
        frame.camera.position_world,
        image.quality.shadowed_lights);
    std::vector<bool> is_chosen(frame.lights.size());
    for (const ShadowedLight& one : lamps.choice.chosen()) {
        const LocalLight& light = frame.lights[one.light];
        lamps.lights.push_back(light);
        lamps.shadow_places.push_back(shadow_numbers(light, one.row, lamps.shadow_px));
        is_chosen[one.light] = true;
    }
    for (std::size_t i = 0; i < frame.lights.size(); ++i) {
        if (!is_chosen[i]) lamps.lights.push_back(frame.lights[i]);
    }
    // Bits for the first ones, as many as cast.
    block.wind.w = static_cast<float>((1U << lamps.shadow_places.size()) - 1U);
    return lamps;
}

}  // namespace plumbline::render
