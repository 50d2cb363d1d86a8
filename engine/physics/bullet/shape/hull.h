// Convex hulls of points, ready for collision: few corners, known mass, never flat.
//
//
#pragma once

#include "engine/physics/collision/shape/mass.h"

#include <string>
#include <vector>

namespace plumbline::physics {

/// More corners cost time in every contact and gain nothing one can see.
inline constexpr std::size_t kMaxHullCorners = 64;

/// A closed convex surface, counter-clockwise from outside.
struct HullSurface {
    std::vector<Vec3d> corners_m;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::size_t dropped{0};  ///< corners left out
    double width_m{0};       ///< smallest distance between two parallel planes around it
};

/// A box that stands for points too flat to have a hull.
struct FlatBox {
    Vec3d size_m{0, 0, 0};
    Vec3d center_m{0, 0, 0};
    Quatd orientation{1, 0, 0, 0};
};

/// The hull of the points; corners beyond kMaxHullCorners are dropped where they matter least. No
/// corners when the points have no volume.
HullSurface hull_of(const std::vector<Vec3>& points_m);

/// Whether the hull is so thin that contacts on it would be noise.
bool too_flat(const HullSurface& hull, double largest_extent_m);

/// The tightest box around flat points, at least as thick as collisions need.
FlatBox flat_box_around(const std::vector<Vec3>& points_m);

}  // namespace plumbline::physics
