// From a RenderFrame to the numbers that its passes read.
#include "engine/core/log.h"
#include "engine/render/culling/frustum.h"
#include "engine/render/culling/occlusion_culling.h"
#include "engine/render/light/shadow_fit.h"
#include "engine/render/renderer_impl.h"

#include <fmt/format.h>
#include <glad/gl.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace plumbline::render {
namespace {

/// Clip volume of OpenGL (-1…1) to texture coordinates and depth (0…1).
const Mat4f kTextureFromClip{Vec4f{0.5F, 0.0F, 0.0F, 0.0F},
                             Vec4f{0.0F, 0.5F, 0.0F, 0.0F},
                             Vec4f{0.0F, 0.0F, 0.5F, 0.0F},
                             Vec4f{0.5F, 0.5F, 0.5F, 1.0F}};

// Lights are given in physical units; shaders want what a matt white surface sends out.
constexpr float kPerPi = glm::one_over_pi<float>();

/// A light this near to the eye lights all that the eye sees: its shadows are narrower than any pixel.
constexpr float kAtEye_m = 1e-5F;

Vec3f forward_of(const Camera& camera) {
    return camera.orientation * Vec3f{0.0F, 0.0F, -1.0F};
}

std::uint32_t scaled_px(std::uint32_t side_px, float scale, std::uint32_t largest_px) {
    const float scaled = std::round(static_cast<float>(side_px) * scale);
    return std::clamp(static_cast<std::uint32_t>(scaled), 1U, largest_px);
}

/// The light that throws shadows, as it reaches the ground: of a computed sky its sun or its moon,
/// none while neither shines.
std::optional<DirectionalLight> sun_of(const RenderFrame& frame, const ComputedSky* sky) {
    if (sky == nullptr) return frame.sun;
    const ComputedSky::KeyLight& light = sky->key_light();
    if (light.irradiance == Vec3f{0.0F}) return {};
    return DirectionalLight{.direction_world = -light.to_light_world, .radiance = light.irradiance};
}

}  // namespace

FeatureSet frame_features_of(const RenderFrame& frame) {
    FeatureSet features = 0;
    if (frame.sun) features |= feature::kSun;
    if (frame.sun && frame.sun_shadow) features |= feature::kSunShadow;
    if (frame.flashlight) features |= feature::kFlashlight;
    if (!frame.lights.empty()) features |= feature::kLocalLights;
    if (frame.fog) features |= feature::kFog;
    if (frame.sky) features |= feature::kSkyLight;
    if (frame.wind) features |= feature::kWind;
    return features;
}

void Renderer::Impl::choose_features(const RenderFrame& new_frame) {
    features = frame_features_of(new_frame);
    if (has_occlusion()) features |= feature::kOcclusion;
    if (has_refraction()) {
        features |= feature::kRefraction;
        if (new_frame.refraction->caustics) features |= feature::kCaustics;
    }
    if (scene_target.samples() > 1) features |= feature::kCoverage;
    if (draws_codes) features |= feature::kCodes;
    if (!sun) features &= ~(feature::kSun | feature::kSunShadow | feature::kCaustics);
    if (sun) features |= feature::kSun;
}

void Renderer::Impl::choose_shadow_filter() {
    if ((features & kShadowFeatures) != 0) {
        if (!quality.shadow_filter) {
            features |= feature::kHardShadows;
        } else if (!is_software_gl) {
            features |= feature::kSoftShadows;
        }
    }
}

void Renderer::Impl::set_up(const RenderFrame& new_frame) {
    frame = &new_frame;
    width_px = new_frame.width_px;
    height_px = new_frame.height_px;
    nothing_to_draw = width_px == 0 || height_px == 0;
    if (nothing_to_draw) return;

    size_targets();
    if (nothing_to_draw) return;
    if (quality.lod_error_px > 0.0F) scene.meshes.make_lods();
    scene.sky.want(new_frame.sky ? &*new_frame.sky : nullptr, new_frame.sun);
    sun.reset();
    if (new_frame.sun_reaches_ground) sun = sun_of(new_frame, scene.sky.computed());
    scene.materials.update({.shading = new_frame.shading,
                            .textures = new_frame.textures,
                            .surface_maps = quality.surface_maps,
                            .parallax = quality.parallax != Drawn::Never});
    choose_features(new_frame);
    const Camera& camera = new_frame.camera;
    const float aspect = static_cast<float>(width_px) / static_cast<float>(height_px);
    const Mat4f world_from_view = glm::mat4_cast(camera.orientation);
    const Mat4f view_from_world =
        glm::translate(glm::transpose(world_from_view), -camera.position_world);
    block = {};
    block.clip_from_world =
        glm::perspective(camera.fov_y_rad, aspect, camera.near_m, camera.far_m) * view_from_world;
    const float tan_y = std::tan(camera.fov_y_rad * 0.5F);
    const Mat4f view_from_ray = glm::scale(Mat4f{1.0F}, Vec3f{tan_y * aspect, tan_y, -1.0F});
    screen_view = {.tan_half = {tan_y * aspect, tan_y},
                   .depth_line = {1.0F / camera.near_m, 1.0F / camera.far_m - 1.0F / camera.near_m},
                   .pixels_at_1m = 0.5F * static_cast<float>(post_view.scene_px.height) / tan_y};
    block.world_from_ray = world_from_view * view_from_ray;
    block.camera_world = Vec4f{camera.position_world, 0.0F};
    block.ambient = Vec4f{new_frame.ambient, 0.0F};
    if (new_frame.fog) block.fog = Vec4f{new_frame.fog->color, new_frame.fog->density_per_m};
    block.wind.z = new_frame.time_s;
    if (new_frame.wind) set_up_wind(*new_frame.wind);
    if (new_frame.post) {
        block.tone.x = new_frame.post->exposure;
        block.tone.y = new_frame.post->bloom;
    }
    if (scene.sky.ready()) set_up_sky();
    block.clusters.x = PL_CLUSTERS_X / static_cast<float>(post_view.scene_px.width);
    block.clusters.y = PL_CLUSTERS_Y / static_cast<float>(post_view.scene_px.height);
    set_up_light();
    choose_light_shadows();
    choose_shadow_filter();
    beam.reset();
    flashlight_view.reset();
    if (new_frame.flashlight) set_up_flashlight(*new_frame.flashlight);
    frame_buffer.upload(&block, sizeof(block));
    if (new_frame.lights.empty()) {
        lights.free();
    } else {
        lights.upload(
            lights_in_order,
            light_shadow_numbers,
            {.view_from_world = view_from_world, .tan_x = tan_y * aspect, .tan_y = tan_y});
    }
}

void Renderer::Impl::size_own_target() {
    if (target != PresentTarget::Offscreen) return;
    // An image of one's own cannot be larger than the driver allows; a window can.
    width_px = std::min(width_px, limits.texture_px);
    height_px = std::min(height_px, limits.texture_px);
    if (color_image.width() == width_px && color_image.height() == height_px) return;
    own_framebuffer = {};
    color_image =
        gl::Texture::target(gl::TargetFormat::Rgba8, width_px, height_px, gl::Filter::Nearest);
    depth_image =
        gl::Texture::target(gl::TargetFormat::Depth24, width_px, height_px, gl::Filter::Nearest);
    own_framebuffer = gl::Framebuffer{&color_image, &depth_image};
}

void Renderer::Impl::size_targets() {
    size_own_target();
    if (asked_px_ != PixelSize{width_px, height_px}) {
        asked_px_ = {width_px, height_px};
        given_up_ = 0;
    }
    for (;; ++given_up_) {
        quality = is_software_gl ? without_gpu(frame->quality) : frame->quality;
        if (given_up_ >= 1 && quality.anti_aliasing != AntiAliasing::Fxaa)
            quality.anti_aliasing = AntiAliasing::Off;
        if (given_up_ == 1) quality.render_scale *= 0.5F;
        if (given_up_ == 2) {
            quality = quality_of(QualityLevel::Low);
            quality.render_scale = kSmallestRenderScale;
        }
        const Result<Done> sized = try_scene_targets();
        if (sized) return;
        if (given_up_ == 2) {
            log_error("nothing can be drawn: {}", sized.error().message);
            nothing_to_draw = true;
            return;
        }
        log_warning(
            "{}: {}",
            sized.error().message,
            given_up_ == 0 ? "half the render scale is tried" : "the lowest image level is tried");
    }
}

Result<Done> Renderer::Impl::try_scene_targets() {
    // Both sides by one factor: what is too wide for the driver keeps its shape.
    const auto longer_px = static_cast<float>(std::max(width_px, height_px));
    const float scale = std::min(std::clamp(quality.render_scale, 0.1F, 1.0F),
                                 static_cast<float>(limits.texture_px) / longer_px);
    const PixelSize image_px{scaled_px(width_px, scale, limits.texture_px),
                             scaled_px(height_px, scale, limits.texture_px)};
    const std::uint32_t samples =
        std::clamp(limits.texture_px / std::max(image_px.width, image_px.height),
                   1U,
                   quality.anti_aliasing == AntiAliasing::Ssaa4 ? 2U : 1U);
    post_view = {.scene_px = {image_px.width * samples, image_px.height * samples},
                 .image_px = image_px,
                 .present_px = {width_px, height_px},
                 .bloom = frame->post && frame->post->bloom > 0.0F && limits.half_float_targets,
                 .tone_curve = frame->post.has_value(),
                 .fxaa = quality.anti_aliasing == AntiAliasing::Fxaa,
                 .samples = samples_of(quality.anti_aliasing),
                 .keeps_depth = !frame->lines.vertices.empty(),
                 .adds_light = has_occlusion() || has_shafts() || has_focus() ||
                               has_motion_blur() || has_refraction()};
    stats.scene_width_px = post_view.scene_px.width;
    stats.scene_height_px = post_view.scene_px.height;
    draws_codes = target == PresentTarget::Offscreen && post_view.has_no_steps() &&
                  !mixes_colors(*frame, scene.library);
    if (draws_codes) {
        scene_target = {};
        return post.resize(post_view);
    }
    const PixelSize& size_px = post_view.scene_px;
    if (limits.target_bytes > 0 &&
        SceneTarget::bytes_for(size_px, light_format(), post_view.samples) > limits.target_bytes) {
        return Error{fmt::format(
            "the driver has no memory for an image of {} x {}", size_px.width, size_px.height)};
    }
    const Result<Done> sized = scene_target.resize(size_px, light_format(), post_view.samples);
    return sized ? post.resize(post_view) : sized;
}

void Renderer::Impl::set_up_wind(const Wind& wind) {
    block.wind.x = wind.mean_mps.x;
    block.wind.y = wind.mean_mps.y;
    for (std::size_t i = 0; i < kGustWaves; ++i) {
        const Wind::Wave& wave = wind.gusts[i];
        const float length = glm::length(wave.number_radpm);
        block.gusts[i] = Vec4f{
            wave.number_radpm, wave.phase_rad, length > 0.0F ? wave.speed_mps / length : 0.0F};
    }
}

void Renderer::Impl::set_up_sky() {
    const GpuSky& sky = scene.sky;
    block.tone.z = static_cast<float>(sky.reflection_levels() - 1);
    if (const ComputedSky* computed = sky.computed(); computed != nullptr) {
        for (std::size_t i = 0; i < kSkyCoefficients; ++i)
            block.sky_light[i] = Vec4f{sky.light()[i], 0.0F};
        block.tone.w = 1.0F;
        if (const float visibility_m = frame->sky->model->visibility_m; visibility_m > 0.0F) {
            features |= feature::kAerial;
            const std::array<Vec3f, 3> horizon = computed->horizon();
            const Vec2f way = computed->light_heading();
            // Koschmieder: a fiftieth of the contrast is left there.
            block.aerial = {Vec4f{horizon[0], 3.912F / visibility_m},
                            Vec4f{horizon[1], way.x},
                            Vec4f{horizon[2], way.y}};
        }
        // Fog is as light as what falls into it.
        block.fog = Vec4f{Vec3f{block.fog} * computed->irradiance() * kPerPi, block.fog.w};
        return;
    }
    for (std::size_t i = 0; i < kSkyCoefficients; ++i)
        block.sky_light[i] = Vec4f{sky.light()[i] * frame->ambient, 0.0F};
    block.tone.w = sky.exposure() * frame->sky->brightness;
}

void Renderer::Impl::set_up_light() {
    sun_shadow_margin_m = 0.0F;
    if (!sun) return;
    const Vec3f direction = normalize_or(sun->direction_world, Vec3f{0.0F, -1.0F, 0.0F});
    block.to_sun_world = Vec4f{-direction, 0.0F};
    block.sun_radiance = Vec4f{sun->radiance * kPerPi, 0.0F};
    if ((features & feature::kSunShadow) == 0) return;
    const SunShadow& shadow = *frame->sun_shadow;
    const ViewShape view{.position_world = frame->camera.position_world,
                         .forward_world = forward_of(frame->camera),
                         .fov_y_rad = frame->camera.fov_y_rad,
                         .aspect = static_cast<float>(width_px) / static_cast<float>(height_px)};
    const auto by_scene = std::clamp<std::uint32_t>(shadow.cascades, 1, kMaxCascades);
    const float by_scene_m = std::max(shadow.distance_m, 1e-4F);
    const bool goes_on =
        quality.far_shadows && by_scene < kMaxCascades && frame->camera.far_m > by_scene_m;
    const std::uint32_t count = goes_on ? by_scene + 1 : by_scene;
    const float distance_m = goes_on ? frame->camera.far_m : by_scene_m;
    if (count > 1) features |= feature::kCascades;
    const std::uint32_t size_px =
        scaled_px(shadow.size_px, quality.shadow_detail, limits.texture_px / count);
    SunShadowFit first{};
    float coarsest_m = 0.0F;
    sun_views.clear();
    for (std::uint32_t i = 0; i < count; ++i) {
        const float end_m = i < by_scene ? cascade_end_m(i, by_scene, by_scene_m) : distance_m;
        const SunShadowFit fit = fit_sun_shadow(view, direction, end_m, size_px);
        if (i == 0) first = fit;
        coarsest_m = fit.texel_m;
        if (i + 1 < count) block.cascade_ends[static_cast<int>(i)] = end_m;
        block.cascades[i] = cascade_from_first(first, fit);
        // Half a texel of the map cannot be seen in it.
        const bool is_coarse = quality.lod_error_px > 0.0F;
        sun_views.push_back({.clip_from_world = fit.clip_from_world,
                             .eye_world = frame->camera.position_world - direction * 1e4F,
                             .size_px = size_px,
                             .bias_units = kShadowBias_units / kSunMapDepth,
                             .error_m = is_coarse ? 0.5F * fit.texel_m : 0.0F});
    }
    // Unused ends lie beyond all: nothing is in a cascade that there is not.
    for (std::uint32_t i = count - 1; i < kMaxCascades; ++i) {
        block.cascade_ends[static_cast<int>(i)] = 1e9F;
    }
    if (quality.contact_hardening != Drawn::Never && shadow.angular_size_rad > 0.0F) {
        features |= feature::kContactHardening;
        block.cascade_ends.w = kSunMapDepth * std::tan(0.5F * shadow.angular_size_rad);
    }
    // Filters and the way off the surface are a few texels; what the wind bends leaves its bounds.
    const bool is_sharp = (features & feature::kContactHardening) == 0;
    if (is_sharp) sun_shadow_margin_m = 4.0F * coarsest_m + (frame->wind ? 1.0F : 0.0F);
    block.sun_shadow_from_world = kTextureFromClip * first.clip_from_world;
    block.camera_world.w = first.texel_m;
    block.to_sun_world.w = 1.0F / distance_m;
    block.sun_radiance.w = 1.0F / static_cast<float>(size_px);
    block.clusters.z = 1.0F / static_cast<float>(count);
    block.clusters.w = 1.5F / (kSunMapDepth * static_cast<float>(size_px));
}

void Renderer::Impl::set_up_flashlight(const Flashlight& flashlight) {
    const Vec3f direction = normalize_or(flashlight.direction_world, Vec3f{0.0F, 0.0F, -1.0F});
    const float outer_cos = std::cos(flashlight.outer_rad);
    const float width = std::max(std::cos(flashlight.inner_rad) - outer_cos, 1e-3F);
    beam = ConvexVolume::cone(
        flashlight.position_world, direction, flashlight.outer_rad, flashlight.radius_m);
    const Mat4f clip_from_world = fit_spot_shadow(
        flashlight.position_world, direction, flashlight.outer_rad, flashlight.radius_m);
    block.flashlight_shadow_from_world = kTextureFromClip * clip_from_world;
    block.flashlight_position =
        Vec4f{flashlight.position_world, 1.0F / std::max(flashlight.radius_m, 1e-3F)};
    block.flashlight_direction = Vec4f{direction, outer_cos};
    block.flashlight_intensity = Vec4f{flashlight.intensity * kPerPi, 1.0F / width};
    block.ambient.w = 1.0F / static_cast<float>(flashlight.shadow_size_px);
    if (glm::distance(flashlight.position_world, frame->camera.position_world) < kAtEye_m) {
        features |= feature::kFlashlightAtEye;
        return;
    }
    flashlight_view = {.clip_from_world = clip_from_world,
                       .eye_world = flashlight.position_world,
                       .size_px = flashlight.shadow_size_px};
}

void Renderer::Impl::build_draw_lists() {
    opaque_draws.clear();
    translucent_draws.clear();
    // What is new is uploaded now: its materials are known here.
    for (const DrawItem& item : frame->items) {
        if (quality.lod_error_px > 0.0F && item.mesh.value != 0)
            scene.meshes.get(item.mesh, materials_of(*frame, item));
    }
    // However few pixels there are, a roof must not lose its tiles: no coarser than at six tenths.
    const float lines = std::max(static_cast<float>(post_view.scene_px.height),
                                 0.6F * static_cast<float>(post_view.present_px.height));
    const float pixel_rad = 2.0F * std::tan(frame->camera.fov_y_rad * 0.5F) / lines;
    visible = cull(*frame,
                   scene.library,
                   {.frustum = Frustum{block.clip_from_world},
                    .eye_world = frame->camera.position_world,
                    .lods = quality.lod_error_px > 0.0F ? &scene.meshes.lods() : nullptr,
                    .error_rad = quality.lod_error_px * pixel_rad,
                    .smallest_rad = quality.smallest_px * pixel_rad,
                    .sorts_foliage = true,
                    .beam = beam ? &*beam : nullptr});
    leave_out_hidden();
    build_draws(visible, scene.library, opaque_kind(), opaque_draws);
    build_draws(visible, scene.library, DrawKind::Translucent, translucent_draws);
}

void Renderer::Impl::leave_out_hidden() {
    if (opaque_kind() != DrawKind::Opaque || frame->fill_mode != FillMode::Filled) return;
    const OcclusionView view{
        .clip_from_world = block.clip_from_world,
        .width_px = post_view.scene_px.width,
        .height_px = post_view.scene_px.height,
        .reach_px = post_view.samples > 1 ? kSamplesReach_px : kCenterReach_px};
    remove_hidden(visible, scene.library, view);
    if (sun_shadow_margin_m == 0.0F) return;
    shadow_sight = {.view = view,
                    .visible = visible,
                    .light_direction_world = -Vec3f{block.to_sun_world},
                    .margin_m = sun_shadow_margin_m};
    sun_views.front().sight = &shadow_sight;
}

unsigned int Renderer::Impl::present_framebuffer() const {
    return target == PresentTarget::Offscreen ? own_framebuffer.name() : 0U;
}

void Renderer::Impl::bind_present_target() const {
    glBindFramebuffer(GL_FRAMEBUFFER, present_framebuffer());
    glViewport(0, 0, static_cast<GLsizei>(width_px), static_cast<GLsizei>(height_px));
}

}  // namespace plumbline::render
