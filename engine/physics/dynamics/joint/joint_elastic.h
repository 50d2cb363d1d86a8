// Elastic joints: springs along three rows at once. A rod is a chain of them.
//
// They follow the implicit midpoint rule with their damping, solved together with the joints: without damping it keeps the energy.
// Half of their push comes before the motion and half after, at the poses there, so that both together leave the angular momentum
// as it is. Those that swing faster than a sub-step shows have their force's place a little further on, by an amount in proportion to
// the sub-step: fast swings die away, and what is slow is of second order still (theta method: Hairer and Wanner, Solving Ordinary
// Differential Equations II, IV.3).
#pragma once

#include "engine/physics/dynamics/joint/joint_group.h"

namespace plumbline::physics {

/// The rows of one node. Stretch in N, m and N s; bending in N m, rad and N m s.
struct ElasticBlock {
    std::uint32_t node{0};
    double stiffness{0};       ///< > 0
    double damping{0};         ///< force per speed
    Vec3d kept{0, 0, 0};       ///< the part of the sub-step's push before the motion
    Vec3d ahead{0, 0, 0};      ///< of the part after it: pushed before all the same
    Vec3d before{0, 0, 0};     ///< the whole push of the sub-step before
    Vec3d extension{0, 0, 0};  ///< when the motion began
    double share{
        0.5};  ///< of the push that is before the motion; so far into it is the force's place

    Vec3d after() const { return kept * ((1 - share) / share); }
};

/// With A the rows' inverse mass, the impulse x satisfies A x + compliance x = -(speed + bias).
struct BlockRow {
    Vec3d bias{0, 0, 0};
    double compliance{0};
};

/// Those of the group, with their latest push from the joints' mean loads.
void list_elastic_blocks(JointGroup& group, std::vector<ElasticBlock>& blocks);
void begin_push(ElasticBlock& block, const JointGroup& group);
BlockRow push_row(const ElasticBlock& block, double substep_s);
/// More of the part before the motion; what hardly changed since the sub-step before is ahead, as with springs.
void push_steadily(ElasticBlock& block, const Vec3d& impulse, JointGroup& group);
void take_back_ahead(ElasticBlock& block, JointGroup& group);
/// The part after the motion, at the poses reached.
void push_rest(ElasticBlock& block, JointGroup& group);
/// A block by itself, for the iterative method: its push before the motion, in view of what contacts changed since.
void adjust_block(ElasticBlock& block, JointGroup& group);

}  // namespace plumbline::physics
