// How deep boxes and balls sit in each other, from their poses alone, so that every engine is judged
// by the same arithmetic.
#pragma once

#include "tests/benchmarks/peer_scenes_world.h"

#include <vector>

namespace plumbline::bench {

struct Overlaps {
    double deepest_m{0};
    double sum_m{0};
    double sum_of_squares_m2{0};
    std::size_t pairs{0};  ///< that overlap
};

/// Least distance that parts two boxes (half sizes) along any of the 15 axes of the separating-axis
/// test; <= 0 when they are apart.
double box_box_depth_m(const BodyView& a,
                       const Vec3d& half_a_m,
                       const BodyView& b,
                       const Vec3d& half_b_m);
double ball_box_depth_m(const Vec3d& center,
                        double radius_m,
                        const BodyView& box,
                        const Vec3d& half_m);

/// Over all pairs of which one is dynamic. Hulls are left out.
Overlaps overlaps_of(const PeerScene& scene, const std::vector<BodyView>& views);

}  // namespace plumbline::bench
