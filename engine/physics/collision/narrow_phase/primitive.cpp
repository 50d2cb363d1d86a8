#include "engine/physics/collision/narrow_phase/primitive.h"

#include "engine/physics/collision/narrow_phase/sphere_box.h"

#include <algorithm>
#include <limits>

namespace plumbline::physics {
namespace {

/// Points of boxes that moved less are the same, as a share of the smaller box's least half edge.
constexpr Real kSame = 0.2_r;
/// A capsule has a point between its ends where it is nearer than both by this share of its radius.
constexpr Real kNearer = 1e-3_r;

OrientedBox oriented(const PlacedPrimitive& box) {
    const Transform& at = box.world_from_shape;
    return {.center = at.position_m, .axes = at.rotation, .half_m = box.shape.half_m};
}

PrimitiveContact points_of_boxes(const OrientedBox& a, const OrientedBox& b, Real reach_m) {
    const BoxContact found = collide_boxes(a, b, reach_m);
    const Vec3 least = glm::min(a.half_m, b.half_m);
    PrimitiveContact contact{.count = static_cast<std::size_t>(found.count),
                             .same_m = kSame * std::min({least.x, least.y, least.z})};
    for (std::size_t i = 0; i < contact.count; ++i)
        contact.list[i] = {found.normal, found.on_b[i], found.distance_m[i]};
    return contact;
}

/// Centres of the spheres along a capsule's axis that may touch the box.
struct CapsuleCenters {
    std::array<Vec3, 3> list{};
    std::size_t count{2};
};

CapsuleCenters centers_of(const PlacedPrimitive& capsule, const OrientedBox& box) {
    const Vec3& middle = capsule.world_from_shape.position_m;
    const Vec3 half = capsule.world_from_shape.rotation[1] * capsule.shape.half_height_m;
    CapsuleCenters centers{.list = {middle - half, middle + half, middle}};
    auto& [low, high, nearest] = centers.list;
    nearest = middle + half * (2 * nearest_on_segment(low, high, box) - 1);
    const auto distance_m = [&box](const Vec3& center) {
        return collide_sphere_box(center, 0, box).distance_m;
    };
    // Nearer than both ends: an edge or a corner between them.
    const Real ends_m = std::min(distance_m(low), distance_m(high));
    if (distance_m(nearest) < ends_m - kNearer * capsule.shape.radius_m) centers.count = 3;
    return centers;
}

PrimitiveContact points_of_spheres(std::span<const Vec3> centers,
                                   Real radius_m,
                                   const OrientedBox& box,
                                   bool box_is_b,
                                   Real reach_m) {
    PrimitiveContact contact{.same_m = std::numeric_limits<Real>::infinity()};
    for (const Vec3& center : centers) {
        const SphereContact found = collide_sphere_box(center, radius_m, box);
        if (found.distance_m > reach_m) continue;
        // The box's point, or the sphere's lowest.
        contact.list[contact.count++] = {
            box_is_b ? found.normal : -found.normal,
            box_is_b ? found.on_box : found.on_box + found.normal * found.distance_m,
            found.distance_m};
    }
    return contact;
}

/// A new point each time: what it carries is all that the manifold carries.
PrimitiveContact point_of_spheres(const PlacedPrimitive& a,
                                  const PlacedPrimitive& b,
                                  Real reach_m) {
    PrimitiveContact contact;
    const Vec3& center_b = b.world_from_shape.position_m;
    const Vec3 apart = a.world_from_shape.position_m - center_b;
    const Real apart_m = glm::length(apart);
    const Real distance_m = apart_m - (a.shape.radius_m + b.shape.radius_m);
    if (distance_m > reach_m) return contact;
    // Spheres with one centre part along x.
    const bool has_direction = apart_m > std::numeric_limits<Real>::epsilon();
    const Vec3 normal = has_direction ? apart * (1 / apart_m) : Vec3{1, 0, 0};
    contact.list[contact.count++] = {normal, center_b + normal * b.shape.radius_m, distance_m};
    return contact;
}

bool are_spheres(const Primitive& a, const Primitive& b) {
    return a.kind == Primitive::Kind::Sphere && b.kind == Primitive::Kind::Sphere;
}

}  // namespace

bool can_collide(const Primitive& a, const Primitive& b) {
    using enum Primitive::Kind;
    const bool has_box = a.kind == Box || b.kind == Box;
    return a.kind != None && b.kind != None && (has_box || are_spheres(a, b));
}

PrimitiveContact collide_primitives(const PlacedPrimitive& a,
                                    const PlacedPrimitive& b,
                                    Real reach_m) {
    if (are_spheres(a.shape, b.shape)) return point_of_spheres(a, b, reach_m);
    const bool box_is_b = b.shape.kind == Primitive::Kind::Box;
    const PlacedPrimitive& other = box_is_b ? a : b;
    const OrientedBox box = oriented(box_is_b ? b : a);
    const Real radius_m = other.shape.radius_m;
    switch (other.shape.kind) {
        case Primitive::Kind::Box:
            return points_of_boxes(oriented(a), box, reach_m);
        case Primitive::Kind::Sphere:
            return points_of_spheres(
                {&other.world_from_shape.position_m, 1}, radius_m, box, box_is_b, reach_m);
        case Primitive::Kind::Capsule: {
            const CapsuleCenters centers = centers_of(other, box);
            return points_of_spheres(
                {centers.list.data(), centers.count}, radius_m, box, box_is_b, reach_m);
        }
        case Primitive::Kind::None:
            break;
    }
    return {};
}

Vec3 touching_center(const PlacedPrimitive& primitive,
                     const Vec3& on_surface,
                     const Vec3& outward) {
    const Vec3& middle = primitive.world_from_shape.position_m;
    if (primitive.shape.kind == Primitive::Kind::Sphere) return middle;
    if (primitive.shape.kind != Primitive::Kind::Capsule) return on_surface;
    const Vec3& axis = primitive.world_from_shape.rotation[1];
    const Vec3 near = on_surface - outward * primitive.shape.radius_m;
    return middle + axis * glm::dot(axis, near - middle);
}

}  // namespace plumbline::physics
