#include "engine/render/light/light_shadows.h"

#include "engine/core/color.h"

#include <algorithm>
#include <cmath>

namespace plumbline::render {
namespace {

constexpr float kKeepsUntil = 1.5F;
// A light that goes further than this between two frames is another.
constexpr float kLongestWay_m = 0.5F;
// From the middle of a face to its corner.
constexpr float kHalfDiagonal_rad = 0.9553F;

/// Of the map's width that a quarter of a turn takes.
float width_share(std::uint32_t size_px) {
    return 1.0F - 2.0F * PL_LIGHT_SHADOW_MARGIN_PX / static_cast<float>(size_px);
}

float far_of(const LocalLight& light) {
    return std::max(light.radius_m, 2.0F * PL_LIGHT_SHADOW_NEAR_M);
}

Vec3f axis_of(std::uint32_t number) {
    Vec3f axis{0.0F};
    axis[static_cast<int>(number % 3)] = 1.0F;
    return axis;
}

Vec3f forward_of_face(std::uint32_t face) {
    return axis_of(face / 2) * (face % 2 == 0 ? 1.0F : -1.0F);
}

float brightness_at(const LocalLight& light, const Vec3f& eye_world) {
    const Vec3f way = light.position_world - eye_world;
    return luminance(light.intensity) / std::max(glm::dot(way, way), 1.0F);
}

}  // namespace

std::vector<LightShadowChoice::Candidate> LightShadowChoice::candidates(
    std::span<const LocalLight> lights, const Frustum& sight, const Vec3f& eye_world) {
    std::vector<Candidate> found;
    std::array<bool, PL_MAX_SHADOWED_LIGHTS> taken{};
    for (std::uint32_t i = 0; i < lights.size() && i < PL_MAX_LIGHTS; ++i) {
        const LocalLight& light = lights[i];
        if (!light.casts_shadow) continue;
        if (!sight.may_touch(
                {light.position_world - light.radius_m, light.position_world + light.radius_m}))
            continue;
        Candidate candidate{.light = i, .brightness = brightness_at(light, eye_world)};
        float nearest_m = kLongestWay_m;
        for (std::uint32_t row = 0; row < places_world_.size(); ++row) {
            if (taken[row] || !places_world_[row]) continue;
            const float path_m = glm::distance(*places_world_[row], light.position_world);
            if (path_m >= nearest_m) continue;
            nearest_m = path_m;
            candidate.row = row;
        }
        if (candidate.row) {
            taken[*candidate.row] = true;
            candidate.brightness *= kKeepsUntil;
        }
        found.push_back(candidate);
    }
    return found;
}

void LightShadowChoice::choose(std::span<const LocalLight> lights,
                               const Frustum& sight,
                               const Vec3f& eye_world,
                               std::uint32_t most) {
    std::vector<Candidate> all = candidates(lights, sight, eye_world);
    std::ranges::stable_sort(
        all, [](const Candidate& a, const Candidate& b) { return a.brightness > b.brightness; });
    const std::size_t count =
        std::min<std::size_t>({all.size(), most, std::size_t{PL_MAX_SHADOWED_LIGHTS}});
    left_out_ = static_cast<std::uint32_t>(all.size() - count);
    all.resize(count);
    chosen_.clear();
    const auto before = places_world_;
    places_world_ = {};
    for (const Candidate& kept : all) {
        if (kept.row) places_world_[*kept.row] = lights[kept.light].position_world;
    }
    for (const Candidate& candidate : all) {
        const Vec3f& place = lights[candidate.light].position_world;
        std::uint32_t row = candidate.row.value_or(0);
        if (!candidate.row) {
            while (places_world_[row]) ++row;
            places_world_[row] = place;
        }
        chosen_.push_back({.light = candidate.light,
                           .row = row,
                           .moved = candidate.row && *before[row] != place});
    }
}

Mat4f clip_from_world(const LocalLight& light, std::uint32_t face, std::uint32_t size_px) {
    const float far_m = far_of(light);
    const float depth_m = far_m - PL_LIGHT_SHADOW_NEAR_M;
    const float share = width_share(size_px);
    const Vec3f forward = forward_of_face(face);
    // Right, up and back make a right-handed frame, so that front faces stay in front.
    const Vec3f right = axis_of(face / 2 + 1) * (face % 2 == 0 ? -share : share);
    const Vec3f up = axis_of(face / 2 + 2) * share;
    const Vec3f along = forward * ((far_m + PL_LIGHT_SHADOW_NEAR_M) / depth_m);
    const auto row = [&](const Vec3f& axis, float offset) {
        return Vec4f{axis, offset - glm::dot(axis, light.position_world)};
    };
    const float offset = -2.0F * far_m * PL_LIGHT_SHADOW_NEAR_M / depth_m;
    return glm::transpose(
        Mat4f{row(right, 0.0F), row(up, 0.0F), row(along, offset), row(forward, 0.0F)});
}

bool shines_into(const LocalLight& light, std::uint32_t face) {
    if (!light.is_spot) return true;
    const float off_axis_rad =
        std::acos(std::clamp(glm::dot(light.direction_world, forward_of_face(face)), -1.0F, 1.0F));
    return off_axis_rad < std::acos(std::clamp(light.outer_cos, -1.0F, 1.0F)) + kHalfDiagonal_rad;
}

Vec4f shadow_numbers(const LocalLight& light, std::uint32_t row, std::uint32_t size_px) {
    const float far_m = far_of(light);
    const float depth_m = far_m - PL_LIGHT_SHADOW_NEAR_M;
    return {static_cast<float>(row),
            far_m / depth_m,
            far_m * PL_LIGHT_SHADOW_NEAR_M / depth_m,
            2.0F / (width_share(size_px) * static_cast<float>(size_px))};
}

}  // namespace plumbline::render
