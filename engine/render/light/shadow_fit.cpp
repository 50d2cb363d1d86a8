#include "engine/render/light/shadow_fit.h"

#include <glm/gtc/matrix_access.hpp>

#include <algorithm>
#include <cmath>

namespace plumbline::render {
namespace {

constexpr float kStepsAcross = 8.0F;
constexpr float kSpotNear_m = 0.1F;
// What is nearer than this need not be finer: the ratios start here. In scenes of a few metres at that
// share of the distance.
constexpr float kSplitNear_m = 4.0F;
constexpr float kSplitNearShare = 0.03F;
constexpr float kSplitByRatio = 0.85F;
// Room for the filter's taps at the rim of the cone.
constexpr float kSpotMargin_rad = 0.02F;

/// Any frame with this z axis; the same for the same direction.
Mat3f frame_along(const Vec3f& z_axis) {
    const Vec3f helper =
        std::abs(z_axis.y) < 0.9F ? Vec3f{0.0F, 1.0F, 0.0F} : Vec3f{1.0F, 0.0F, 0.0F};
    const Vec3f x_axis = glm::normalize(glm::cross(helper, z_axis));
    return {x_axis, glm::cross(z_axis, x_axis), z_axis};
}

struct Ball {
    float along_view_m;
    float radius_m;
};

/// The smallest ball around the part of a cone (the view's corners lie on it) within distance_m.
Ball ball_around_view(float fov_y_rad, float aspect, float distance_m) {
    const float tan_y = std::tan(fov_y_rad * 0.5F);
    const float half_angle_rad = std::atan(tan_y * std::sqrt(1.0F + aspect * aspect));
    const float cosine = std::cos(half_angle_rad);
    if (half_angle_rad < glm::quarter_pi<float>()) {
        const float radius_m = distance_m / (2.0F * cosine);
        return {.along_view_m = radius_m, .radius_m = radius_m};
    }
    return {.along_view_m = distance_m * cosine, .radius_m = distance_m * std::sin(half_angle_rad)};
}

}  // namespace

SunShadowFit fit_sun_shadow(const ViewShape& view,
                            const Vec3f& light_direction_world,
                            float distance_m,
                            std::uint32_t size_px) {
    const Ball ball = ball_around_view(view.fov_y_rad, view.aspect, distance_m);
    // A step of an eighth of the width shifts the ball by at most half of that off the centre.
    const float half_m = ball.radius_m * kStepsAcross / (kStepsAcross - 1.0F);
    const float half_depth_m = half_m * kSunMapDepth;
    const float size = static_cast<float>(size_px);
    const float texel_m = 2.0F * half_m / size;
    const float step_m = std::max(std::floor(size / kStepsAcross), 1.0F) * texel_m;
    // What is left of the depth beside the ball lets it go on for long before all depths change.
    const Vec3f steps_m{step_m, step_m, 1.98F * (half_depth_m - ball.radius_m)};

    const Mat3f world_from_light = frame_along(-light_direction_world);
    const Mat3f light_from_world = glm::transpose(world_from_light);
    const Vec3f center_world = view.position_world + view.forward_world * ball.along_view_m;
    const Vec3f center_light = glm::round(light_from_world * center_world / steps_m) * steps_m;

    // x and y to -1…1; z, which points at the light, so that near the light is -1.
    const Vec3f scale = 1.0F / Vec3f{half_m, half_m, -half_depth_m};
    const Mat4f clip_from_light = glm::translate(glm::scale(Mat4f{1.0F}, scale), -center_light);
    return {.clip_from_world = clip_from_light * Mat4f{light_from_world}, .texel_m = texel_m};
}

float cascade_end_m(std::uint32_t i, std::uint32_t count, float distance_m) {
    if (i + 1 >= count) return distance_m;
    const float near_m = std::min(kSplitNear_m, kSplitNearShare * distance_m);
    const float share = static_cast<float>(i + 1) / static_cast<float>(count);
    const float by_ratio_m = near_m * std::pow(distance_m / near_m, share);
    const float by_length_m = glm::mix(near_m, distance_m, share);
    return glm::mix(by_length_m, by_ratio_m, kSplitByRatio);
}

Vec4f cascade_from_first(const SunShadowFit& first, const SunShadowFit& other) {
    // Both look the same way, so only width and centre differ.
    const float scale = glm::length(Vec3f{glm::row(other.clip_from_world, 0)}) /
                        glm::length(Vec3f{glm::row(first.clip_from_world, 0)});
    const Vec3f origin_first = Vec3f{first.clip_from_world[3]} * 0.5F + 0.5F;
    const Vec3f origin_other = Vec3f{other.clip_from_world[3]} * 0.5F + 0.5F;
    return {origin_other - origin_first * scale, scale};
}

Mat4f fit_spot_shadow(const Vec3f& position_world,
                      const Vec3f& direction_world,
                      float outer_rad,
                      float radius_m) {
    const Mat3f world_from_light = frame_along(-direction_world);
    Mat4f light_from_world{glm::transpose(world_from_light)};
    light_from_world[3] = Vec4f{-(glm::transpose(world_from_light) * position_world), 1.0F};
    const float fov_rad = std::min(2.0F * (outer_rad + kSpotMargin_rad), 3.0F);
    return glm::perspective(fov_rad, 1.0F, kSpotNear_m, std::max(radius_m, 2.0F * kSpotNear_m)) *
           light_from_world;
}

}  // namespace plumbline::render
