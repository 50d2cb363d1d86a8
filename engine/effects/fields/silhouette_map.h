// Silhouettes of one body over all directions, worked out once.
#pragma once

#include "engine/core/math.h"

#include <functional>
#include <vector>

namespace plumbline::effects {

/// A silhouette of several parts is dear, and is asked for in every sub-step. Directions lie on a square (octahedral map: Meyer et
/// al., On floating-point normal vectors, 2010), in cells of some 2 degrees; corners are worked out when they are first asked
/// for, and what lies between four of them is blended. Depends on nothing but the direction: the same after a saved game.
class SilhouetteMap {
public:
    using Silhouette = std::function<double(const Vec3d& direction)>;

    /// m2. `direction` is unit; `exact` is asked for the corners.
    double at(const Vec3d& direction, const Silhouette& exact);

private:
    static constexpr int kCells = 64;

    double corner(int u, int v, const Silhouette& exact);

    std::vector<double> corners_m2_;  ///< below 0: not yet
};

}  // namespace plumbline::effects
