#include "engine/physics/collision/manifold.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {

ManifoldPoint* nearest_point(std::span<ManifoldPoint> points,
                             const ManifoldPoint& point,
                             Real near_m) {
    constexpr Real kSameWay = 0.7_r;  // cosine
    ManifoldPoint* found = nullptr;
    Real least = near_m * near_m;
    for (ManifoldPoint& other : points) {
        const Vec3 on_a = other.a.local_m - point.a.local_m;
        const Vec3 on_b = other.b.local_m - point.b.local_m;
        const Real away2 = std::min(glm::dot(on_a, on_a), glm::dot(on_b, on_b));
        if (away2 >= least || glm::dot(other.normal_world, point.normal_world) < kSameWay) continue;
        least = away2;
        found = &other;
    }
    return found;
}

namespace {

Real by_rule(CombineRule rule, Real a, Real b, Real usual) {
    switch (rule) {
        case CombineRule::Multiply:
            return a * b;
        case CombineRule::Maximum:
            return std::max(a, b);
        case CombineRule::Minimum:
            return std::min(a, b);
        case CombineRule::Average:
            return (a + b) / 2;
        case CombineRule::Usual:
            break;
    }
    return usual;
}

}  // namespace

Material combined(const Material& a, const Material& b) {
    const CombineRule friction = std::max(a.friction_rule, b.friction_rule);
    const CombineRule restitution = std::max(a.restitution_rule, b.restitution_rule);
    // A sphere's own resistance to rolling holds on any ground, so one side's coefficient is enough.
    return {
        .friction = by_rule(friction, a.friction, b.friction, std::sqrt(a.friction * b.friction)),
        .restitution = by_rule(
            restitution, a.restitution, b.restitution, std::max(a.restitution, b.restitution)),
        .rolling_m = std::max(a.rolling_m, b.rolling_m),
        .spinning_m = std::max(a.spinning_m, b.spinning_m)};
}

void remove_point(Manifold& manifold, std::size_t index) {
    manifold.points[index] = manifold.points.back();
    manifold.points.pop_back();
}

void forget_loads(Manifold& manifold) {
    for (ManifoldPoint& point : manifold.points) {
        point.load = {};
        point.normal_Ns = 0;
    }
    manifold.load = {};
}

std::array<Vec3, 2> tangents_of(const Vec3& normal) {
    constexpr Real kHalfRoot = 0.7071067811865475_r;
    // Across the plane in which the normal has most of its length.
    if (std::abs(normal.z) > kHalfRoot) {
        const Real square = normal.y * normal.y + normal.z * normal.z;
        const Real inverse = 1 / std::sqrt(square);
        const Vec3 first{0, -normal.z * inverse, normal.y * inverse};
        return {first, {square * inverse, -normal.x * first.z, normal.x * first.y}};
    }
    const Real square = normal.x * normal.x + normal.y * normal.y;
    const Real inverse = 1 / std::sqrt(square);
    const Vec3 first{-normal.y * inverse, normal.x * inverse, 0};
    return {first, {-normal.z * first.y, normal.z * first.x, square * inverse}};
}

}  // namespace plumbline::physics
