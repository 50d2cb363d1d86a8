// The contact point of a sphere and a box.
#pragma once

#include "engine/physics/collision/narrow_phase/box_box.h"

namespace plumbline::physics {

struct SphereContact {
    Vec3 normal{0, 1, 0};  ///< unit, from the box to the sphere
    Vec3 on_box{0, 0, 0};
    Real distance_m{0};  ///< negative: penetration
};

/// The box's point nearest to the sphere's centre; for a centre inside the box, on its nearest face.
/// Exact to rounding at any distance.
SphereContact collide_sphere_box(const Vec3& center, Real radius_m, const OrientedBox& box);

/// Where along the segment between two points a sphere would be nearest to the box: 0 at `from`, 1 at
/// `to`. Distance to a convex thing is convex along a line: found by golden section.
Real nearest_on_segment(const Vec3& from, const Vec3& to, const OrientedBox& box);

/// The part of a segment that lies over the face of the box that its point at `nearest` (a share of it) lies over, as shares; all of
/// it where that point lies over an edge or a corner.
struct SegmentPart {
    Real from{0};
    Real to{1};
};
SegmentPart part_over_face(const Vec3& from, const Vec3& to, Real nearest, const OrientedBox& box);

}  // namespace plumbline::physics
