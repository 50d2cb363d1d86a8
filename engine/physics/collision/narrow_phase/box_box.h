// Contact points of two boxes, also of boxes that do not touch yet.
#pragma once

#include "engine/core/math.h"

#include <array>

namespace plumbline::physics {

struct OrientedBox {
    Vec3 center{0, 0, 0};
    Mat3 axes{1};  ///< columns, unit
    Vec3 half_m{0.5_r, 0.5_r, 0.5_r};
};

/// Up to four points with one normal.
struct BoxContact {
    Vec3 normal{0, 1, 0};  ///< unit, from b to a
    int count{0};
    std::array<Vec3, 4> on_b{};
    std::array<Real, 4> distance_m{};  ///< negative: penetration
};

/// Separating axes over the 15 directions of two boxes, then the face that meets the other box's
/// most is clipped against it (Gottschalk et al. 1996, "OBBTree", section 5; Ericson 2005,
/// "Real-Time Collision Detection", 4.4.1 and 8.3.4). Points farther apart than `reach_m` are left
/// out; count is 0 where none are nearer. Of more than four, those that span most are kept, the
/// deepest first.
BoxContact collide_boxes(const OrientedBox& a, const OrientedBox& b, Real reach_m);

}  // namespace plumbline::physics
