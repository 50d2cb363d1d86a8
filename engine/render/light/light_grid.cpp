#include "engine/render/light/light_grid.h"

#include "engine/core/color.h"

#include <algorithm>
#include <cmath>

namespace plumbline::render {
namespace {

constexpr std::uint32_t kDirections = 256;
constexpr int kBounces = 4;
/// Of a point's rays; where more end on backs of surfaces, it lies within something.
constexpr std::uint32_t kMostBacks = kDirections / 4;
/// Of grass and paths, which are outside the box.
constexpr Vec3f kGroundAlbedo{0.22F, 0.22F, 0.17F};
/// Of a cell: how far off a surface its light is looked up.
constexpr float kOffSurface = 0.5F;

/// Evenly over the sphere: a Fibonacci spiral.
std::vector<Vec3f> even_directions() {
    constexpr float kGoldenAngle_rad = 2.3999632F;
    std::vector<Vec3f> directions;
    for (std::uint32_t i = 0; i < kDirections; ++i) {
        const float y = 1.0F - (2.0F * static_cast<float>(i) + 1.0F) / kDirections;
        const float r = std::sqrt(1.0F - y * y);
        const float turn_rad = kGoldenAngle_rad * static_cast<float>(i);
        directions.push_back({r * std::cos(turn_rad), y, r * std::sin(turn_rad)});
    }
    return directions;
}

Vec3f radiance_from(const OutsideLight& outside, const Vec3f& direction) {
    const Vec3f middle = 0.282095F * outside.sky[0];
    if (direction.y < 0.0F)
        return kGroundAlbedo *
               (middle + outside.sun_radiance * std::max(outside.to_sun_world.y, 0.0F));
    return glm::max(
        middle + 0.488603F * (outside.sky[1] * direction.y + outside.sky[2] * direction.z +
                              outside.sky[3] * direction.x),
        Vec3f{0.0F});
}

}  // namespace

LightGrid::LightGrid(const IndirectLight& box, const RayScene& rays)
    : box_(box), directions_(even_directions()) {
    std::uint32_t points = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const float cells = (box.max_world[axis] - box.min_world[axis]) / box.spacing_m;
        counts_[static_cast<std::size_t>(axis)] =
            static_cast<std::uint32_t>(std::max(std::ceil(cells), 1.0F));
        points *= counts_[static_cast<std::size_t>(axis)];
    }
    is_closed_.resize(points);
    means_.assign(points, Vec4f{0.0F});
    slopes_.assign(points, Vec4f{0.0F});
    for (std::uint32_t point = 0; point < points; ++point) cast_from(point, rays);
}

Vec3f LightGrid::place_of(std::uint32_t point) const {
    const Vec3f index{
        point % counts_[0], point / counts_[0] % counts_[1], point / counts_[0] / counts_[1]};
    const Vec3f counts{counts_[0], counts_[1], counts_[2]};
    return box_.min_world + (index + 0.5F) / counts * (box_.max_world - box_.min_world);
}

void LightGrid::cast_from(std::uint32_t point, const RayScene& rays) {
    const Vec3f place = place_of(point);
    std::uint32_t backs = 0;
    for (std::uint32_t i = 0; i < kDirections; ++i) {
        const auto hit = rays.first_hit(place, directions_[i], Backs::Seen);
        const bool is_within =
            hit &&
            glm::all(glm::greaterThan(hit->position_world, box_.min_world - box_.spacing_m)) &&
            glm::all(glm::lessThan(hit->position_world, box_.max_world + box_.spacing_m));
        if (!is_within) {
            escapes_.push_back(point * kDirections + i);
        } else if (hit->from_behind) {
            ++backs;
        } else {
            samples_.push_back({.place_world = hit->position_world,
                                .ray = point * kDirections + i,
                                .normal = glm::packSnorm4x8(
                                    Vec4f{hit->normal_world, hit->two_sided ? 1.0F : 0.0F}),
                                .albedo = glm::packUnorm4x8(Vec4f{hit->albedo, 0.0F})});
        }
    }
    is_closed_[point] = backs > kMostBacks;
}

Vec3f LightGrid::diffuse_at(const Vec3f& place_world, const Vec3f& normal_world) const {
    const Vec3f counts{counts_[0], counts_[1], counts_[2]};
    const Vec3f at = glm::clamp(
        (place_world - box_.min_world) / (box_.max_world - box_.min_world) * counts - 0.5F,
        Vec3f{0.0F},
        counts - 1.0F);
    const Vec3f low = glm::min(glm::floor(at), glm::max(counts - 2.0F, 0.0F));
    const Vec3f share = at - low;
    Vec3f mean{0.0F};
    Vec3f slope{0.0F};
    for (std::uint32_t corner = 0; corner < 8; ++corner) {
        float weight = 1.0F;
        std::uint32_t index = 0;
        std::uint32_t stride = 1;
        for (int axis = 0; axis < 3; ++axis) {
            const bool is_high = (corner >> static_cast<std::uint32_t>(axis) & 1U) != 0;
            weight *= is_high ? share[axis] : 1.0F - share[axis];
            const std::uint32_t count = counts_[static_cast<std::size_t>(axis)];
            index += stride * std::min(static_cast<std::uint32_t>(low[axis]) + (is_high ? 1U : 0U),
                                       count - 1);
            stride *= count;
        }
        mean += weight * Vec3f{means_[index]};
        slope += weight * Vec3f{slopes_[index]};
    }
    return mean * std::max(1.0F + 0.6666667F * glm::dot(slope, normal_world), 0.0F);
}

void LightGrid::find_sun(const OutsideLight& outside, const RayScene& rays) {
    const bool has_sun = outside.to_sun_world.y > 0.0F && outside.sun_radiance != Vec3f{0.0F};
    for (Sample& sample : samples_) {
        const Vec4f packed = glm::unpackSnorm4x8(sample.normal);
        const RayHit place{.position_world = sample.place_world,
                           .normal_world = Vec3f{packed},
                           .two_sided = packed.w > 0.0F};
        const float cosine = glm::dot(place.normal_world, outside.to_sun_world);
        const bool is_lit =
            has_sun && cosine > 0.0F && !rays.is_shaded(place, outside.to_sun_world);
        sample.sun = is_lit ? cosine : 0.0F;
    }
}

void LightGrid::light(const OutsideLight& outside, const RayScene& rays) {
    find_sun(outside, rays);
    std::ranges::fill(means_, Vec4f{0.0F});
    std::ranges::fill(slopes_, Vec4f{0.0F});
    for (int bounce = 0; bounce < kBounces; ++bounce) {
        gather(outside);
        fill_closed_points();
    }
}

void LightGrid::gather(const OutsideLight& outside) {
    std::vector<Vec4f> means(means_.size(), Vec4f{0.0F});
    std::vector<Vec3f> moments(means_.size(), Vec3f{0.0F});  // of luminance
    const auto receive = [&](std::uint32_t ray, const Vec3f& radiance) {
        const std::uint32_t point = ray / kDirections;
        means[point] += Vec4f{radiance, 0.0F} / static_cast<float>(kDirections);
        moments[point] += directions_[ray % kDirections] * luminance(radiance);
    };
    for (const std::uint32_t ray : escapes_)
        receive(ray, radiance_from(outside, directions_[ray % kDirections]));
    for (const Sample& sample : samples_) {
        const Vec3f normal{glm::unpackSnorm4x8(sample.normal)};
        const Vec3f off = normal * (kOffSurface * box_.spacing_m);
        receive(
            sample.ray,
            Vec3f{glm::unpackUnorm4x8(sample.albedo)} *
                (sample.sun * outside.sun_radiance + diffuse_at(sample.place_world + off, normal)));
    }
    for (std::size_t point = 0; point < means.size(); ++point) {
        const float total = luminance(Vec3f{means[point]}) * kDirections;
        slopes_[point] = Vec4f{moments[point] * (3.0F / std::max(total, 1e-12F)), 0.0F};
    }
    means_ = std::move(means);
}

/// Points within walls get the mean of their open neighbours, so that nothing dark leaks out.
void LightGrid::fill_closed_points() {
    const std::array<std::uint32_t, 3> stride{1, counts_[0], counts_[0] * counts_[1]};
    for (std::uint32_t point = 0; point < means_.size(); ++point) {
        if (!is_closed_[point]) continue;
        Vec4f mean{0.0F};
        Vec4f slope{0.0F};
        float open = 0.0F;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::uint32_t along = point / stride[axis] % counts_[axis];
            const auto add = [&](std::uint32_t neighbour) {
                if (is_closed_[neighbour]) return;
                mean += means_[neighbour];
                slope += slopes_[neighbour];
                open += 1.0F;
            };
            if (along > 0) add(point - stride[axis]);
            if (along + 1 < counts_[axis]) add(point + stride[axis]);
        }
        means_[point] = open > 0.0F ? mean / open : Vec4f{0.0F};
        slopes_[point] = open > 0.0F ? slope / open : Vec4f{0.0F};
    }
}

}  // namespace plumbline::render
