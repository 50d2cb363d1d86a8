// Contact points of two convex shapes: a table of pair functions, kind by kind.
//
// All are pure: two shapes, where they are, how far points are searched. The world's axes are the frame
// of all vectors.
#pragma once

#include "engine/physics/collision/narrow_phase/point_choice.h"
#include "engine/physics/collision/shape/convex_shape.h"

#include <array>
#include <cstddef>
#include <span>

namespace plumbline::physics {

struct ConvexPoint {
    Vec3 normal{0, 1, 0};  ///< unit, from b to a
    Vec3 on_b{0, 0, 0};
    Real distance_m{0};  ///< negative: penetration
};

/// What two convex shapes have between them.
struct ConvexContact {
    std::array<ConvexPoint, PointChoice::kMost> list{};
    std::size_t count{0};
    Real same_m{0};  ///< a point that moved less on either body since the step before is the same

    std::span<const ConvexPoint> points() const { return {list.data(), count}; }
};

/// The points nearer than `reach_m`, always in the same order. Neither shape's kind is None.
ConvexContact collide(const PlacedShape& a, const PlacedShape& b, Real reach_m);

/// How a side of a contact point is curved: the sphere that touches there.
struct RoundSide {
    Real radius_m{0};      ///< 0: not round
    Vec3 center{0, 0, 0};  ///< of the sphere; the point itself where the side is not round
};
/// Spheres, capsules and the sides of cylinders. The centre is put on the shape's own centre or axis: contact
/// points are known to a few micrometres only, and a sphere pressed beside its centre turns.
RoundSide round_side(const PlacedShape& placed, const Vec3& on_surface, const Vec3& outward);

}  // namespace plumbline::physics
