// How near a point is to a triangle or to an edge of it.
#pragma once

#include "engine/core/math.h"

#include <array>
#include <cstddef>

namespace plumbline::physics {

/// The point of a triangle that is nearest to a place.
struct NearestPoint {
    Vec3d at{0, 0, 0};
    bool is_face{true};
    std::size_t from{0};  ///< else of an edge, or a corner where both are one
    std::size_t to{0};
};

/// As in Ericson 2005, "Real-Time Collision Detection", 5.1.5. The corners are counter-clockwise round the unit
/// `normal`.
NearestPoint nearest_to(const Vec3d& place,
                        const std::array<Vec3d, 3>& corners,
                        const Vec3d& normal);

/// Shares of the corners in the point that is nearest to a place; those of corners that it is not between are 0. Likewise.
std::array<double, 3> nearest_shares(const Vec3d& place, const std::array<Vec3d, 3>& corners);

/// Squares of distances, m^2.
double away_from_triangle2(const Vec3d& place, const std::array<Vec3d, 3>& corners);
double away_from_line2(const Vec3d& place, const Vec3d& from, const Vec3d& to);

}  // namespace plumbline::physics
