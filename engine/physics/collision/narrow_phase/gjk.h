// The closest points of two convex cores, also of cores that overlap.
#pragma once

#include "engine/physics/collision/narrow_phase/placed_convex.h"

#include <array>
#include <cstddef>

namespace plumbline::physics {

/// A corner of the Minkowski difference a - b, and the two points that it is the difference of.
/// Not initialised: there are arrays of them.
struct Vertex {
    Vec3d at;
    Vec3d on_a;
    Vec3d on_b;
};

/// Up to four corners of the difference, and the weights that make of them its point nearest to the origin.
struct Simplex {
    std::array<Vertex, 4> corners;
    std::array<double, 4> weights;
    std::size_t count{0};
};

struct Closest {
    double distance_m{0};  ///< of the cores; 0: they overlap
    Vec3d on_a{0, 0, 0};
    Vec3d on_b{0, 0, 0};
    Simplex simplex;
};

Vertex support_vertex(const PlacedConvex& a, const PlacedConvex& b, const Vec3d& direction);

/// The distance of two cores (Gilbert, Johnson and Keerthi 1988; the sub-simplices as in Ericson 2005, "Real-Time
/// Collision Detection", 5.1 and 9.5). It is within a billionth of the cores' size. Cores farther apart than
/// `reach_m` may get any distance beyond that.
Closest closest_points(const PlacedConvex& a, const PlacedConvex& b, double reach_m);

}  // namespace plumbline::physics
