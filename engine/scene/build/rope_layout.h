// Where the pieces of a rope are at the start.
#pragma once

#include "engine/core/math.h"
#include "engine/core/pose.h"
#include "engine/scene/environment/rope_description.h"

#include <vector>

namespace plumbline::scene {

struct RopeLayout {
    /// One more than pieces: where they meet. Of a rope that stretches, in the middle between the two.
    std::vector<Vec3d> points_m;
    double piece_m{0};  ///< length of each, unstretched

    /// Of their middles, the y axis along the rope; from each to the next by the shortest turn.
    std::vector<Pose> pieces() const;
};

/// A rope of so many pieces along its path; without one, straight, or as it hangs at rest where it is longer
/// than its anchors are apart: links of one length in equilibrium under their weight.
RopeLayout lay_rope(const RopeDescription& rope, int pieces, const Vec3d& gravity_mps2);

}  // namespace plumbline::scene
