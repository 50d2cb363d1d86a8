#include "engine/physics/collision/narrow_phase/sphere_box.h"

#include "engine/physics/transform.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

/// Less far beyond an edge, as a share of the height over the face, is over the face.
constexpr Real kOverFace = 1e-3_r;

}  // namespace

SphereContact collide_sphere_box(const Vec3& center, Real radius_m, const OrientedBox& box) {
    const Vec3 local = glm::transpose(box.axes) * (center - box.center);
    Vec3 nearest = glm::clamp(local, -box.half_m, box.half_m);
    const Vec3 away = local - nearest;
    const Real away_m = glm::length(away);
    if (away_m > 0) {
        return {.normal = box.axes * (away / away_m),
                .on_box = box.center + box.axes * nearest,
                .distance_m = away_m - radius_m};
    }
    const Vec3 depth = box.half_m - magnitudes_of(local);
    int k = 0;
    if (depth.y < depth[k]) k = 1;
    if (depth.z < depth[k]) k = 2;
    const Real side = local[k] < 0 ? -1 : 1;
    nearest[k] = side * box.half_m[k];
    return {.normal = box.axes[k] * side,
            .on_box = box.center + box.axes * nearest,
            .distance_m = -depth[k] - radius_m};
}

Real nearest_on_segment(const Vec3& from, const Vec3& to, const OrientedBox& box) {
    constexpr Real kGolden = 0.618034_r;
    constexpr int kCuts = 24;  // to 1e-5 of the length
    const auto distance_m = [&](Real at) {
        return collide_sphere_box(from + (to - from) * at, 0, box).distance_m;
    };
    Real low = 0;
    Real high = 1;
    Real left = 1 - kGolden;
    Real right = kGolden;
    Real left_m = distance_m(left);
    Real right_m = distance_m(right);
    for (int i = 0; i < kCuts; ++i) {
        if (left_m < right_m) {
            high = right;
            right = left;
            right_m = left_m;
            left = high - kGolden * (high - low);
            left_m = distance_m(left);
        } else {
            low = left;
            left = right;
            left_m = right_m;
            right = low + kGolden * (high - low);
            right_m = distance_m(right);
        }
    }
    return (low + high) / 2;
}

SegmentPart part_over_face(const Vec3& from, const Vec3& to, Real nearest, const OrientedBox& box) {
    const Vec3 begin = glm::transpose(box.axes) * (from - box.center);
    const Vec3 along = glm::transpose(box.axes) * (to - from);
    const Vec3 outside = magnitudes_of(begin + along * nearest) - box.half_m;
    int face = outside.y > outside.x ? 1 : 0;
    if (outside.z > outside[face]) face = 2;
    SegmentPart part;
    for (int k = 0; k < 3; ++k) {
        if (k == face) continue;
        if (outside[k] > kOverFace * outside[face]) return {};
        if (along[k] == 0) continue;
        const Real low = (-box.half_m[k] - begin[k]) / along[k];
        const Real high = (box.half_m[k] - begin[k]) / along[k];
        part.from = std::max(part.from, std::min(low, high));
        part.to = std::min(part.to, std::max(low, high));
    }
    return part.from < part.to ? part : SegmentPart{};
}

}  // namespace plumbline::physics
