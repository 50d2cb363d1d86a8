#include "engine/render/passes/screen/light_passes.h"

#include "engine/render/shader_blocks.h"

#include <glad/gl.h>
#include <glm/gtc/type_ptr.hpp>

namespace plumbline::render {
namespace {

// Of the image's height: near things would look up half of it.
constexpr float kMostReach = 0.12F;
// Of the image's height: more samples than there are would be seen one by one.
constexpr float kLargestRadius = 1.0F / 36.0F;
// Of the image's width: a streak's samples must stay close.
constexpr float kLongestStreak = 1.0F / 12.0F;

/// False, and the images are freed, where the driver has no memory for them.
bool resize(PairImages& images, const PixelSize& size_px) {
    const bool made = images.found.resize(gl::TargetFormat::Pair16F, size_px) &&
                      images.spare.resize(gl::TargetFormat::Pair16F, size_px);
    if (!made) images = {};
    return made;
}

/// Smooths what was found in a pattern of four by four pixels, in place; not across the edges of things.
void blur_pairs(const PairImages& images, PassContext context) {
    const gl::Program* blur = context.program(kPairBlurShader);
    if (blur == nullptr) return;
    blur->use();
    const auto along = [&](const PassImage& from, const PassImage& to, GLint x, GLint y) {
        to.bind();
        gl::bind_texture(kSourceUnit, from.image);
        glUniform2i(blur->location("axis"), x, y);
        context.draw_triangle();
    };
    along(images.found, images.spare, 1, 0);
    along(images.spare, images.found, 0, 1);
}

void bind_light_and_depth(const SceneLight& light, const gl::Program& program) {
    bind_scene_light(light, program);
    gl::bind_texture(kSourceUnit, *light.image);
    gl::bind_texture(kDepthUnit, *light.depth);
    glUniform2f(program.location("depth_line"), light.depth_line.x, light.depth_line.y);
}

/// Where the camera was as the shutter opened.
Mat4f clip_before_from_world(const FrameSetup& setup) {
    const Camera& camera = setup.frame->camera;
    const MotionBlur& blur = *setup.frame->motion_blur;
    const float aspect = setup.screen.tan_half.x / setup.screen.tan_half.y;
    return glm::perspective(camera.fov_y_rad, aspect, camera.near_m, camera.far_m) *
           glm::translate(glm::mat4_cast(glm::conjugate(blur.orientation_before)),
                          -blur.position_before_world);
}

}  // namespace

const gl::Texture* find_occlusion(const FrameSetup& setup,
                                  const gl::Texture& depth,
                                  PairImages& images,
                                  PassContext context) {
    const AmbientOcclusion& occlusion = *setup.frame->occlusion;
    const ScreenView& view = setup.screen;
    const gl::Program* find = context.program(kOcclusionShader);
    if (find == nullptr) return nullptr;
    if (!resize(images, {(depth.width() + 1) / 2, (depth.height() + 1) / 2})) return nullptr;
    images.found.bind();
    find->use();
    gl::bind_texture(kDepthUnit, depth);
    glUniform2f(find->location("depth_line"), view.depth_line.x, view.depth_line.y);
    glUniform2f(find->location("tan_half"), view.tan_half.x, view.tan_half.y);
    glUniform4f(find->location("reach"),
                occlusion.radius_m,
                occlusion.radius_m * view.pixels_at_1m,
                kMostReach * static_cast<float>(depth.height()),
                occlusion.strength);
    glUniform2i(find->location("counts"),
                static_cast<GLint>(occlusion.slices),
                static_cast<GLint>(occlusion.steps));
    context.draw_triangle();
    blur_pairs(images, context);
    return &images.found.image;
}

const gl::Texture* find_shafts(const FrameSetup& setup,
                               const gl::Texture& depth,
                               const gl::Texture* sun_shadow_map,
                               PairImages& images,
                               PassContext context) {
    const SunShafts& shafts = *setup.frame->shafts;
    const ScreenView& view = setup.screen;
    const bool has_shadows = sun_shadow_map != nullptr;
    const bool has_cascades = has_shadows && setup.sun.shadow_views.size() > 1;
    const gl::Program* find = context.program(
        kShaftsShader,
        shaft_feature::kSunShadow.when(has_shadows) | shaft_feature::kCascades.when(has_cascades));
    if (find == nullptr) return nullptr;
    if (!resize(images, {(depth.width() + 3) / 4, (depth.height() + 3) / 4})) return nullptr;
    find->use();
    images.found.bind();
    gl::bind_texture(kDepthUnit, depth);
    if (has_shadows) gl::bind_texture(kSunShadowUnit, *sun_shadow_map);
    glUniform2f(find->location("depth_line"), view.depth_line.x, view.depth_line.y);
    glUniform3f(find->location("air"),
                shafts.density_per_m,
                shafts.distance_m,
                static_cast<float>(shafts.steps));
    context.draw_triangle();
    blur_pairs(images, context);
    return &images.found.image;
}

const gl::Texture* see_through_lens(const FrameSetup& setup,
                                    const SceneLight& light,
                                    FocusImages& images,
                                    PassContext context) {
    const DepthOfField& lens = *setup.frame->depth_of_field;
    const gl::Program* down = context.program(kFocusDownShader, light.features);
    const gl::Program* gather = context.program(kFocusGatherShader);
    const gl::Program* join = context.program(kFocusJoinShader, light.features);
    if (down == nullptr || gather == nullptr || join == nullptr) return nullptr;
    const PixelSize full_px{light.image->width(), light.image->height()};
    const PixelSize half_px{(full_px.width + 1) / 2, (full_px.height + 1) / 2};
    if (!images.half.resize(gl::TargetFormat::HdrColor, half_px) ||
        !images.blurred.resize(gl::TargetFormat::HdrColor, half_px) ||
        !images.joined.resize(gl::TargetFormat::HdrColor, full_px)) {
        images = {};
        return nullptr;
    }
    // The disc of a point at distance z has the radius aperture / 2 * pixels_at_1m * |1/focus - 1/z|.
    const float by_distance = 0.5F * lens.aperture_m * setup.screen.pixels_at_1m;
    const float far_px = by_distance / lens.focus_m;
    const float largest_px = kLargestRadius * static_cast<float>(full_px.height);
    const auto set_lens = [&](const gl::Program& program) {
        bind_light_and_depth(light, program);
        glUniform4f(program.location("lens"), far_px, by_distance, largest_px, 0.0F);
    };
    images.half.bind();
    down->use();
    set_lens(*down);
    context.draw_triangle();
    images.blurred.bind();
    gather->use();
    gl::bind_texture(kSourceUnit, images.half.image);
    glUniform2f(gather->location("disc"), 0.5F * largest_px, static_cast<float>(lens.samples));
    context.draw_triangle();
    images.joined.bind();
    join->use();
    set_lens(*join);
    gl::bind_texture(kBlurredUnit, images.blurred.image);
    context.draw_triangle();
    return &images.joined.image;
}

const gl::Texture* blur_motion(const FrameSetup& setup,
                               const SceneLight& light,
                               MotionBlurImages& images,
                               PassContext context) {
    const MotionBlur& blur = *setup.frame->motion_blur;
    const ShutterView view{.clip_from_world = setup.block.clip_from_world,
                           .clip_before_from_world = clip_before_from_world(setup)};
    const gl::Texture* ways = images.motion_vectors.render(blur, view, *light.depth, context);
    const gl::Program* program = context.program(
        kMotionBlurShader, light.features | screen_feature::kMoved.when(ways != nullptr));
    if (program == nullptr) return nullptr;
    const PixelSize size_px{light.image->width(), light.image->height()};
    if (!images.blurred.resize(gl::TargetFormat::HdrColor, size_px)) {
        images = {};
        return nullptr;
    }
    images.blurred.bind();
    program->use();
    bind_light_and_depth(light, *program);
    if (ways != nullptr) gl::bind_texture(kBlurredUnit, *ways);
    glUniformMatrix4fv(program->location("clip_before_from_world"),
                       1,
                       GL_FALSE,
                       glm::value_ptr(view.clip_before_from_world));
    glUniform2f(program->location("streak"),
                kLongestStreak * static_cast<float>(size_px.width),
                static_cast<float>(blur.samples));
    context.draw_triangle();
    return &images.blurred.image;
}

}  // namespace plumbline::render
