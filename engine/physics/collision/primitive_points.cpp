#include "engine/physics/collision/primitive_points.h"

#include "engine/physics/world/body_record.h"

#include <algorithm>
#include <utility>

namespace plumbline::physics {
namespace {

ContactSide side_of(const BodyRecord& body, const Vec3& on_surface, const Vec3& outward) {
    const Primitive& shape = body.traits.primitive;
    const Transform& at = body.motion->at;
    return {.radius_m = shape.radius_m,
            .offset_m = touching_center({shape, at}, on_surface, outward) - at.position_m,
            .surface_m = on_surface,
            .local_m = unrotated(on_surface - at.position_m, at.rotation)};
}

ManifoldPoint point_on(const Manifold& manifold, const PrimitivePoint& found) {
    const Vec3 on_a = found.on_b + found.normal * found.distance_m;
    return {.a = side_of(*manifold.a, on_a, -found.normal),
            .b = side_of(*manifold.b, found.on_b, found.normal),
            .normal_world = found.normal,
            .distance_m = found.distance_m};
}

/// Adds the point to those from `first` on, or puts it in the place of the one that it is to be one with.
void put(const ManifoldPoint& point,
         std::vector<ManifoldPoint>& points,
         std::size_t first,
         Real merge_m) {
    std::size_t place = points.size();
    Real least = merge_m * merge_m;
    for (std::size_t i = first; i < points.size(); ++i) {
        const Vec3 away = points[i].a.local_m - point.a.local_m;
        const Real away2 = glm::dot(away, away);
        if (away2 >= least) continue;
        least = away2;
        place = i;
    }
    if (place == points.size())
        points.push_back(point);
    else
        points[place] = point;
}

PlacedPrimitive placed(const BodyRecord& body) {
    return {body.traits.primitive, body.motion->at};
}

}  // namespace

void collide_primitives(const Pair& pair, Manifold& manifold, const CollideStep& step) {
    const PrimitiveContact found =
        collide_primitives(placed(*pair.a), placed(*pair.b), pair.reach_m);
    renew_points(manifold, found, pair.base_m);
    const Real always_m = near_m(pair);
    if (pair.reach_m <= always_m) return;
    for (std::size_t i = manifold.points.size(); i-- > 0;) {
        if (!is_reachable(manifold, manifold.points[i], always_m, step)) remove_point(manifold, i);
    }
}

void renew_points(Manifold& manifold, const PrimitiveContact& found, Real merge_m) {
    std::vector<ManifoldPoint>& points = manifold.points;
    const std::size_t old_count = points.size();
    points.reserve(old_count + found.count);
    for (const PrimitivePoint& point : found.points())
        put(point_on(manifold, point), points, old_count, merge_m);

    const auto old = std::span(points).first(old_count);
    for (ManifoldPoint& point : std::span(points).subspan(old_count)) {
        ManifoldPoint* const before = nearest_point(old, point, found.same_m);
        if (before != nullptr) {
            point.age_steps = before->age_steps + 1;
            point.load = before->load;
            // One that is found twice is a new point the second time.
            point.feature = std::exchange(before->feature, 0);
        }
        if (point.feature == 0) point.feature = ++manifold.features_made;
    }
    points.erase(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(old_count));
}

}  // namespace plumbline::physics
