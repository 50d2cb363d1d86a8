// Elastic joints: springs along three rows at once. A rod is a chain of them.
//
// They follow the implicit midpoint rule with their damping, solved together with the joints: without damping it keeps the energy.
// Half of their push comes before the motion and half after, at the poses there, so that both together leave the angular momentum
// as it is. Those that swing faster than a sub-step shows also push against what the speed of their extension changed by since the
// sub-step before. With w the angular frequency and h the sub-step, swings of w h = 3 to 10 lose 11 to 29 % of their amplitude in
// each, slow ones the share kLate h^3 w^4 / 4 a second.
#pragma once

#include "engine/physics/dynamics/joint/joint_group.h"

namespace plumbline::physics {

/// The rows of one node. Stretch in N, m and N s; bending in N m, rad and N m s.
struct ElasticBlock {
    std::uint32_t node{0};
    double stiffness{0};       ///< > 0
    double damping{0};         ///< force per speed
    Vec3d kept{0, 0, 0};       ///< half of the sub-step's push: before the motion
    Vec3d ahead{0, 0, 0};      ///< of the half after it: pushed before all the same
    Vec3d before{0, 0, 0};     ///< the whole push of the sub-step before
    Vec3d extension{0, 0, 0};  ///< when the motion began
    Vec3d speed{0, 0, 0};      ///< of the extension, mean of the sub-step before
    bool fast{false};          ///< swings faster than a sub-step shows
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
/// More of the half before the motion; what hardly changed since the sub-step before is ahead, as with springs.
void push_steadily(ElasticBlock& block, const Vec3d& impulse, JointGroup& group);
void take_back_ahead(ElasticBlock& block, JointGroup& group);
/// The other half of the push, after the motion, at the poses reached.
void push_rest(ElasticBlock& block, JointGroup& group);
/// What the next step needs of the latest sub-step (SolverJoint::elastic_speed).
void keep_speed(const ElasticBlock& block, JointGroup& group);
/// A block by itself, for the iterative method: its push before the motion, in view of what contacts changed since.
void adjust_block(ElasticBlock& block, JointGroup& group);

}  // namespace plumbline::physics
