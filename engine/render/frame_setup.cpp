// From a RenderFrame to the numbers that its passes read.
#include "engine/core/log.h"
#include "engine/render/frustum.h"
#include "engine/render/renderer_impl.h"
#include "engine/render/shadow_fit.h"

#include <glad/gl.h>

#include <algorithm>
#include <cmath>

namespace plumbline::render {
namespace {

/// Clip volume of OpenGL (-1…1) to texture coordinates and depth (0…1).
const Mat4f kTextureFromClip{Vec4f{0.5F, 0.0F, 0.0F, 0.0F},
                             Vec4f{0.0F, 0.5F, 0.0F, 0.0F},
                             Vec4f{0.0F, 0.0F, 0.5F, 0.0F},
                             Vec4f{0.5F, 0.5F, 0.5F, 1.0F}};

// Lights are given in physical units; shaders want what a matt white surface sends out.
constexpr float kPerPi = glm::one_over_pi<float>();

Vec3f forward_of(const Camera& camera) {
    return camera.orientation * Vec3f{0.0F, 0.0F, -1.0F};
}

bool wants_hdr(const RenderFrame& frame) {
    return frame.post && frame.post->bloom > 0.0F;
}

}  // namespace

FeatureSet frame_features_of(const RenderFrame& frame, bool hdr) {
    FeatureSet features = 0;
    if (frame.sun) features |= feature::kSun;
    if (frame.sun && frame.sun_shadow) features |= feature::kSunShadow;
    if (frame.flashlight) features |= feature::kFlashlight;
    if (!frame.lights.empty()) features |= feature::kLocalLights;
    if (frame.fog) features |= feature::kFog;
    if (frame.sky) features |= feature::kSkyLight;
    if (hdr) return features;
    if (frame.post) features |= feature::kToneMap;
    return features | feature::kEncode;
}

void Renderer::Impl::set_up(const RenderFrame& new_frame) {
    frame = &new_frame;
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    width_px = std::min(new_frame.width_px, static_cast<std::uint32_t>(largest));
    height_px = std::min(new_frame.height_px, static_cast<std::uint32_t>(largest));
    nothing_to_draw = width_px == 0 || height_px == 0;
    if (nothing_to_draw) return;

    size_targets();
    scene.sky.want(new_frame.sky ? new_frame.sky->folder : std::filesystem::path{});
    scene.materials.update(new_frame.shading);
    features = frame_features_of(new_frame, post.ready());
    const FeatureSet shadowed = feature::kSunShadow | feature::kFlashlight;
    if (!is_software_gl && (features & shadowed) != 0) features |= feature::kSoftShadows;

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
    block.world_from_ray = world_from_view * view_from_ray;
    block.camera_world = Vec4f{camera.position_world, 0.0F};
    block.ambient = Vec4f{new_frame.ambient, 0.0F};
    if (new_frame.fog) block.fog = Vec4f{new_frame.fog->color, new_frame.fog->density_per_m};
    if (new_frame.post) {
        block.tone.x = new_frame.post->exposure;
        block.tone.y = new_frame.post->bloom;
    }
    if (scene.sky.ready()) {
        block.tone.z = static_cast<float>(scene.sky.reflection_levels() - 1);
        for (std::size_t i = 0; i < kSkyCoefficients; ++i) {
            block.sky_light[i] = Vec4f{scene.sky.light()[i] * new_frame.ambient, 0.0F};
        }
        block.tone.w = scene.sky.exposure() * new_frame.sky->brightness;
    }
    set_up_light();
    if (new_frame.flashlight) set_up_flashlight(*new_frame.flashlight);
    frame_buffer.upload(&block, sizeof(block));
    if (!new_frame.lights.empty()) upload_local_lights(lights_buffer, new_frame.lights);
}

void Renderer::Impl::size_targets() {
    if (target == PresentTarget::Offscreen &&
        (color_image.width() != width_px || color_image.height() != height_px)) {
        own_framebuffer = {};
        color_image =
            gl::Texture::target(gl::TargetFormat::Rgba8, width_px, height_px, gl::Filter::Nearest);
        depth_image = gl::Texture::target(
            gl::TargetFormat::Depth24, width_px, height_px, gl::Filter::Nearest);
        own_framebuffer = gl::Framebuffer{&color_image, &depth_image};
    }
    if (!wants_hdr(*frame)) {
        post.free();
        return;
    }
    const auto sized = post.resize(width_px, height_px);
    if (!sized) log_warning("drawing without bloom: {}", sized.error().message);
}

void Renderer::Impl::set_up_light() {
    if (!frame->sun) return;
    const DirectionalLight& sun = *frame->sun;
    const Vec3f direction = normalize_or(sun.direction_world, Vec3f{0.0F, -1.0F, 0.0F});
    block.to_sun_world = Vec4f{-direction, 0.0F};
    block.sun_radiance = Vec4f{sun.radiance * kPerPi, 0.0F};
    if (!frame->sun_shadow) return;
    const SunShadow& shadow = *frame->sun_shadow;
    const ViewShape view{.position_world = frame->camera.position_world,
                         .forward_world = forward_of(frame->camera),
                         .fov_y_rad = frame->camera.fov_y_rad,
                         .aspect = static_cast<float>(width_px) / static_cast<float>(height_px)};
    const SunShadowFit fit =
        fit_sun_shadow(view, direction, std::max(shadow.distance_m, 1.0F), shadow.size_px);
    block.sun_shadow_from_world = kTextureFromClip * fit.clip_from_world;
    block.camera_world.w = fit.texel_m;
    block.to_sun_world.w = 1.0F / std::max(shadow.distance_m, 1.0F);
    block.sun_radiance.w = 1.0F / static_cast<float>(shadow.size_px);
    sun_view = {.clip_from_world = fit.clip_from_world,
                .eye_world = frame->camera.position_world - direction * 1e4F,
                .size_px = shadow.size_px};
}

void Renderer::Impl::set_up_flashlight(const Flashlight& flashlight) {
    const Vec3f direction = normalize_or(flashlight.direction_world, Vec3f{0.0F, 0.0F, -1.0F});
    const float outer_cos = std::cos(flashlight.outer_rad);
    const float width = std::max(std::cos(flashlight.inner_rad) - outer_cos, 1e-3F);
    const Mat4f clip_from_world = fit_spot_shadow(
        flashlight.position_world, direction, flashlight.outer_rad, flashlight.radius_m);
    block.flashlight_shadow_from_world = kTextureFromClip * clip_from_world;
    block.flashlight_position =
        Vec4f{flashlight.position_world, 1.0F / std::max(flashlight.radius_m, 1e-3F)};
    block.flashlight_direction = Vec4f{direction, outer_cos};
    block.flashlight_intensity = Vec4f{flashlight.intensity * kPerPi, 1.0F / width};
    block.ambient.w = 1.0F / static_cast<float>(flashlight.shadow_size_px);
    flashlight_view = {.clip_from_world = clip_from_world,
                       .eye_world = flashlight.position_world,
                       .size_px = flashlight.shadow_size_px};
}

void Renderer::Impl::build_draw_lists() {
    opaque_draws.clear();
    translucent_draws.clear();
    std::vector<VisibleItem> visible =
        cull(*frame, scene.library, Frustum{block.clip_from_world}, frame->camera.position_world);
    build_draws(visible, scene.library, DrawKind::Opaque, opaque_draws);
    build_draws(std::move(visible), scene.library, DrawKind::Translucent, translucent_draws);
}

void Renderer::Impl::bind_present_target() const {
    glBindFramebuffer(GL_FRAMEBUFFER,
                      target == PresentTarget::Offscreen ? own_framebuffer.name() : 0U);
    glViewport(0, 0, static_cast<GLsizei>(width_px), static_cast<GLsizei>(height_px));
}

void Renderer::Impl::bind_scene_target() const {
    if (!post.ready()) {
        bind_present_target();
        return;
    }
    glBindFramebuffer(GL_FRAMEBUFFER, post.hdr_framebuffer().name());
    glViewport(0, 0, static_cast<GLsizei>(width_px), static_cast<GLsizei>(height_px));
}

}  // namespace plumbline::render
