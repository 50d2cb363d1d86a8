// Joints solved one block after the other, again and again: soft, warm-started, first order.
#pragma once

#include "engine/physics/dynamics/joint/joint_group.h"

namespace plumbline::physics {

class IterativeJoints {
public:
    /// Impulses of the step before are taken from the joints.
    void start(JointGroup& group);
    /// Effective masses at the rows' latest refresh.
    void refresh(const JointGroup& group);
    /// Applies the impulses of the sub-step before. Bodies on joints lose their steady change.
    void warm_start(JointGroup& group);
    /// One sweep. With bias before the bodies move, without it ("relax") after.
    void sweep(JointGroup& group, bool with_bias);
    /// Impulses into the joints.
    void finish(const JointGroup& group) const;

private:
    void solve_bound(JointGroup& group, JointBound& bound);

    std::vector<Symmetric3> mass_;    // of a node's rows
    std::vector<Vec3d> error_;        // at the latest refresh
    std::vector<Vec3d> accumulated_;  // impulses along the rows, in this sub-step
    std::vector<bool> places_;        // whether the node is its joint's first
};

}  // namespace plumbline::physics
