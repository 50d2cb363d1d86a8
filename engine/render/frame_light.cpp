// What of the scene's light passes read: for water, and between the scene and its tone curve.
#include "engine/core/color.h"
#include "engine/render/renderer_impl.h"

#include <glad/gl.h>

#include <cmath>

namespace plumbline::render {

void Renderer::Impl::copy_behind_water() {
    if ((features & feature::kRefraction) == 0) return;
    Aabb seen;
    for (const DrawRun& run : translucent_draws.runs) {
        if ((scene.materials.features(run.material) & feature::kRefraction) == 0) continue;
        seen.include(run.bounds_world);
    }
    if (seen.empty()) return;
    const gl::PassTimers::Scope timed(timers, "refraction");
    if (refraction_pass.copy(scene_target, seen, block.clip_from_world)) {
        refraction_pass.bind();
    } else {
        features &= ~feature::kRefraction;
    }
    scene_target.bind();
}

SceneLight Renderer::Impl::finish_light() {
    if (scene_target.samples() > 1) {
        const gl::PassTimers::Scope timed(timers, "resolve");
        scene_target.resolve();
    }
    SceneLight light{.image = &scene_target.color(),
                     .depth = &scene_target.depth(),
                     .depth_line = screen_view.depth_line};
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    add_occlusion(light);
    add_shafts(light);
    add_focus(light);
    add_motion_blur(light);
    return light;
}

void Renderer::Impl::add_occlusion(SceneLight& light) {
    if (!has_occlusion()) return occlusion_pass.free();
    const gl::PassTimers::Scope timed(timers, "occlusion");
    light.occlusion =
        occlusion_pass.render(*frame->occlusion, screen_view, *light.depth, triangle, scene, stats);
    if (light.occlusion != nullptr) light.features |= feature::kOcclusion;
}

void Renderer::Impl::add_shafts(SceneLight& light) {
    if (!has_shafts() || !sun) return shaft_pass.free();
    const gl::PassTimers::Scope timed(timers, "shafts");
    const bool has_shadow = (features & feature::kSunShadow) != 0;
    light.shafts = shaft_pass.render(*frame->shafts,
                                     features,
                                     screen_view,
                                     *light.depth,
                                     has_shadow ? &sun_shadow.map() : nullptr,
                                     triangle,
                                     scene,
                                     stats);
    if (light.shafts != nullptr) light.features |= feature::kShafts;
}

void Renderer::Impl::add_focus(SceneLight& light) {
    if (!has_focus()) return focus_pass.free();
    const gl::PassTimers::Scope timed(timers, "focus");
    const gl::Texture* seen =
        focus_pass.render(*frame->depth_of_field, screen_view, light, triangle, scene, stats);
    if (seen == nullptr) return;
    light.image = seen;
    light.features = 0;
}

void Renderer::Impl::add_motion_blur(SceneLight& light) {
    if (!has_motion_blur()) return motion_blur_pass.free();
    const gl::PassTimers::Scope timed(timers, "motion_blur");
    const gl::Texture* seen =
        motion_blur_pass.render(*frame->motion_blur,
                                {.clip_from_world = block.clip_from_world,
                                 .clip_before_from_world = clip_before_from_world()},
                                light,
                                triangle,
                                scene,
                                stats);
    if (seen == nullptr) return;
    light.image = seen;
    light.features = 0;
}

Mat4f Renderer::Impl::clip_before_from_world() const {
    const Camera& camera = frame->camera;
    const MotionBlur& blur = *frame->motion_blur;
    const float aspect = screen_view.tan_half.x / screen_view.tan_half.y;
    return glm::perspective(camera.fov_y_rad, aspect, camera.near_m, camera.far_m) *
           glm::translate(glm::mat4_cast(glm::conjugate(blur.orientation_before)),
                          -blur.position_before_world);
}

void Renderer::Impl::adapt_exposure() {
    if (!frame->post || !frame->post->adapts || !limits.half_float_targets)
        return exposure_meter.free();
    const gl::PassTimers::Scope timed(timers, "post.exposure");
    const bool is_seen_live = target != PresentTarget::Offscreen;
    block.tone.x *= exposure_meter.measure(
        scene_target.color(),
        is_seen_live ? ExposureMeter::Reading::Later : ExposureMeter::Reading::Now,
        triangle,
        scene,
        stats);
    frame_buffer.upload(&block, sizeof(block));
}

Vec3f Renderer::Impl::clear_color() const {
    Vec3f light = frame->clear_color;
    if (frame->fog) {
        const float depth = frame->fog->density_per_m * frame->camera.far_m;
        light = glm::mix(frame->fog->color, light, std::exp(-depth * depth));
    }
    if (!draws_codes) return light;
    return {srgb_from_linear(light.x), srgb_from_linear(light.y), srgb_from_linear(light.z)};
}

}  // namespace plumbline::render
