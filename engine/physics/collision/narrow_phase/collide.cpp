#include "engine/physics/collision/narrow_phase/collide.h"

#include "engine/physics/collision/narrow_phase/box_box.h"
#include "engine/physics/collision/narrow_phase/convex_convex.h"
#include "engine/physics/collision/narrow_phase/sphere_box.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumbline::physics {
namespace {

using Kind = ConvexShape::Kind;

/// Points of boxes that moved less are the same, as a share of the smaller box's least half edge.
constexpr Real kSameShare = 0.2_r;
/// A capsule has a point between its ends where it is nearer than both by this share of its radius.
constexpr Real kNearer = 1e-3_r;
/// A cylinder's side is round only where it is touched across its axis.
constexpr Real kAcrossAxis = 0.15_r;

OrientedBox oriented(const PlacedShape& box) {
    const Transform& at = box.world_from_shape;
    return {.center = at.position_m, .axes = at.rotation, .half_m = box.shape.half_m};
}

ConvexContact box_box(const PlacedShape& a, const PlacedShape& b, Real reach_m) {
    const BoxContact found = collide_boxes(oriented(a), oriented(b), reach_m);
    const Vec3 least = glm::min(a.shape.half_m, b.shape.half_m);
    ConvexContact contact{.count = static_cast<std::size_t>(found.count),
                          .same_m = kSameShare * std::min({least.x, least.y, least.z})};
    for (std::size_t i = 0; i < contact.count; ++i)
        contact.list[i] = {found.normal, found.on_b[i], found.distance_m[i]};
    return contact;
}

ConvexContact spheres_box(std::span<const Vec3> centers,
                          Real radius_m,
                          const OrientedBox& box,
                          Real reach_m) {
    ConvexContact contact{.same_m = std::numeric_limits<Real>::infinity()};
    for (const Vec3& center : centers) {
        const SphereContact found = collide_sphere_box(center, radius_m, box);
        if (found.distance_m > reach_m) continue;
        contact.list[contact.count++] = {found.normal, found.on_box, found.distance_m};
    }
    return contact;
}

ConvexContact sphere_box(const PlacedShape& a, const PlacedShape& b, Real reach_m) {
    return spheres_box({&a.world_from_shape.position_m, 1}, a.shape.radius_m, oriented(b), reach_m);
}

/// The ends of what of the capsule's axis lies over a face and, where an edge or a corner is nearer than both, between them. Beyond the
/// face's edge the line on which the capsule lies is not held, and would be pushed aside there.
ConvexContact capsule_box(const PlacedShape& capsule, const PlacedShape& b, Real reach_m) {
    const OrientedBox box = oriented(b);
    const Vec3& middle = capsule.world_from_shape.position_m;
    const Vec3 half = capsule.world_from_shape.rotation[1] * capsule.shape.half_height_m;
    const auto at = [&](Real share) { return middle + half * (2 * share - 1); };
    const auto distance_m = [&box](const Vec3& center) {
        return collide_sphere_box(center, 0, box).distance_m;
    };
    const Real nearest = nearest_on_segment(at(0), at(1), box);
    const SegmentPart part = part_over_face(at(0), at(1), nearest, box);
    const std::array<Vec3, 3> centers{at(part.from), at(part.to), at(nearest)};
    const Real ends_m = std::min(distance_m(centers[0]), distance_m(centers[1]));
    const bool has_middle = distance_m(centers[2]) < ends_m - kNearer * capsule.shape.radius_m;
    return spheres_box(
        {centers.data(), has_middle ? 3U : 2U}, capsule.shape.radius_m, box, reach_m);
}

/// A new point each time: what it carries is all that the manifold carries.
ConvexContact sphere_sphere(const PlacedShape& a, const PlacedShape& b, Real reach_m) {
    ConvexContact contact;
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

ConvexContact any_any(const PlacedShape& a, const PlacedShape& b, Real reach_m) {
    ConvexContact contact;
    const Vec3d origin{b.world_from_shape.position_m};
    const PlacedConvex first = placed_convex(a, origin);
    const PlacedConvex second = placed_convex(b, origin);
    const auto reach = static_cast<double>(reach_m);
    const std::optional<ConvexPair> pair = contact_of(first, second, reach);
    if (!pair) return contact;
    const SurfaceContact& found = pair->contact;
    const Vec3 normal{pair->separation.normal};
    for (std::size_t i = 0; i < found.count; ++i) {
        const RegionPoint& point = found.points[i];
        contact.list[contact.count++] = {
            normal, Vec3(point.on_b + origin), static_cast<Real>(point.distance_m)};
    }
    const bool rolls = first.radius_m > 0 || second.radius_m > 0;
    contact.same_m =
        rolls ? std::numeric_limits<Real>::infinity()
              : kSameShare / 2 * static_cast<Real>(std::min(size_of(first), size_of(second)));
    return contact;
}

using Collide = ConvexContact (*)(const PlacedShape& a, const PlacedShape& b, Real reach_m);

/// The pair function with its shapes exchanged.
template <Collide kCollide>
ConvexContact swapped(const PlacedShape& a, const PlacedShape& b, Real reach_m) {
    ConvexContact contact = kCollide(b, a, reach_m);
    for (std::size_t i = 0; i < contact.count; ++i) {
        ConvexPoint& point = contact.list[i];
        point.on_b += point.normal * point.distance_m;
        point.normal = -point.normal;
    }
    return contact;
}

constexpr std::size_t kKinds = 7;
constexpr std::size_t at(Kind kind) {
    return static_cast<std::size_t>(kind);
}

constexpr std::array<std::array<Collide, kKinds>, kKinds> make_table() {
    std::array<std::array<Collide, kKinds>, kKinds> table{};
    for (auto& row : table) row.fill(any_any);
    table[at(Kind::Sphere)][at(Kind::Sphere)] = sphere_sphere;
    table[at(Kind::Box)][at(Kind::Box)] = box_box;
    table[at(Kind::Sphere)][at(Kind::Box)] = sphere_box;
    table[at(Kind::Box)][at(Kind::Sphere)] = swapped<sphere_box>;
    table[at(Kind::Capsule)][at(Kind::Box)] = capsule_box;
    table[at(Kind::Box)][at(Kind::Capsule)] = swapped<capsule_box>;
    return table;
}

constexpr auto kTable = make_table();

}  // namespace

ConvexContact collide(const PlacedShape& a, const PlacedShape& b, Real reach_m) {
    return kTable[at(a.shape.kind)][at(b.shape.kind)](a, b, reach_m);
}

RoundSide round_side(const PlacedShape& placed, const Vec3& on_surface, const Vec3& outward) {
    const ConvexShape& shape = placed.shape;
    const Vec3& middle = placed.world_from_shape.position_m;
    const Vec3& axis = placed.world_from_shape.rotation[1];
    if (shape.kind == Kind::Sphere) return {shape.radius_m, middle};
    const bool on_side =
        shape.kind == Kind::Cylinder && std::abs(glm::dot(axis, outward)) < kAcrossAxis;
    if (shape.kind != Kind::Capsule && !on_side) return {.center = on_surface};
    const Vec3 near = on_surface - outward * shape.radius_m;
    return {shape.radius_m, middle + axis * glm::dot(axis, near - middle)};
}

}  // namespace plumbline::physics
