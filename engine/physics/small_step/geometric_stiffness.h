// Keeps bodies that joints pull hard from turning faster than a sub-step can follow.
//
// A force f at an arm r turns a body back with the stiffness f r: a light link in a chain that
// carries tonnes swings about its own centre at hundreds of hertz. Impulses found at one pose are
// explicit for that motion and blow it up once sub-step^2 * stiffness passes 4 times the inertia.
// Such bodies get, for what joints do to them, as much inertia as makes the motion just slow enough
// (Tournier et al., Stable Constrained Dynamics, 2015; Andrews et al., Geometric Stiffness for
// Real-time Constrained Multibody Dynamics, 2017), and lose spin in proportion when they get it:
// implicit Euler for what can't be resolved anyway. Everything slower is left exactly as it is.
#pragma once

#include "engine/physics/small_step/joint_group.h"

namespace plumbline::physics {

class GeometricStiffness {
public:
    void start(const JointGroup& group);
    /// In view of the impulses of the sub-step so far and of position corrections (impulse times
    /// the sub-step) about to be made. Whether any body changed: then the rows' responses did.
    bool raise(JointGroup& group, std::span<const Vec3d> corrections);
    /// Gives the inertia back that the impulses of the sub-step do not ask for.
    void lower(JointGroup& group);

private:
    /// A node whose force pulls at arms, and how far from each of the bodies' axes it does.
    struct Pull {
        std::uint32_t node{0};
        Vec3d lever_a_m{0, 0, 0};
        Vec3d lever_b_m{0, 0, 0};
    };

    bool find_stiffness(const JointGroup& group, std::span<const Vec3d> corrections);
    bool is_too_fast() const;
    void find_pivots(const JointGroup& group);
    /// What the body needs about one of its axes.
    double wanted_moment(const JointGroup& group, std::size_t body, int axis) const;

    std::vector<Pull> pulls_;
    std::vector<Vec3d> stiffness_Nm_;  // by body, about its axes
    std::vector<Vec3d> limit_Nm_;      // what a sub-step can follow
    std::vector<double> pivot_kgm2_;   // by body: what turning it moves besides itself
    std::vector<std::uint32_t> joints_at_;
    bool raised_{false};  // some body has more inertia than its own
};

}  // namespace plumbline::physics
