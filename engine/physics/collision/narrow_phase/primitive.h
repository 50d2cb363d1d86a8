// Shapes whose contact points we find ourselves.
#pragma once

#include "engine/physics/collision/narrow_phase/box_box.h"
#include "engine/physics/dynamics/transform.h"

#include <cstdint>
#include <span>

namespace plumbline::physics {

/// A shape in its own frame: its centre at the origin, a capsule along +Y.
struct Primitive {
    enum class Kind : std::uint8_t { None, Box, Sphere, Capsule };

    Kind kind{Kind::None};  ///< None: some other shape
    Vec3 half_m{0, 0, 0};   ///< of a box
    Real radius_m{0};       ///< of a sphere or a capsule
    Real half_height_m{0};  ///< of a capsule, up to the centres of its caps
};

/// A primitive and where it is; for the length of a call.
struct PlacedPrimitive {
    const Primitive& shape;
    const Transform& world_from_shape;
};

struct PrimitivePoint {
    Vec3 normal{0, 1, 0};  ///< unit, from b to a
    Vec3 on_b{0, 0, 0};
    Real distance_m{0};  ///< negative: penetration
};

/// What two primitives have between them.
struct PrimitiveContact {
    std::array<PrimitivePoint, 4> list{};
    std::size_t count{0};
    Real same_m{0};  ///< a point that moved less on either body since the step before is the same

    std::span<const PrimitivePoint> points() const { return {list.data(), count}; }
};

/// Whether collide_primitives() knows the two: a box with a box, a sphere or a capsule, or two spheres.
bool can_collide(const Primitive& a, const Primitive& b);

/// The points nearer than `reach_m`, always in the same order: those of two boxes, the one of two spheres,
/// or of a box and spheres along a capsule's axis: its ends and, where an edge or a corner is nearer,
/// between them.
PrimitiveContact collide_primitives(const PlacedPrimitive& a,
                                    const PlacedPrimitive& b,
                                    Real reach_m);

/// What a contact point moves with: the centre of the sphere that touches there, or the point itself
/// on a shape that is not round. The centre is put on the shape's own centre or axis: contact points
/// are known to a few micrometres only, and a sphere pressed beside its centre turns.
Vec3 touching_center(const PlacedPrimitive& primitive, const Vec3& on_surface, const Vec3& outward);

}  // namespace plumbline::physics
