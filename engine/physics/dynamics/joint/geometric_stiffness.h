// Keeps bodies that joints pull hard from turning faster than a sub-step can follow.
//
// A force f at an arm r turns a body back with the stiffness f r: a light link in a chain that
// carries tonnes swings about its own centre at hundreds of hertz. Impulses found at one pose are
// explicit for that motion and blow it up once sub-step^2 * stiffness passes 4 times the inertia.
// Such bodies get, for what joints do to them, as much inertia as makes the motion just slow enough
// (Tournier et al., Stable Constrained Dynamics, 2015; Andrews et al., Geometric Stiffness for
// Real-time Constrained Multibody Dynamics, 2017), and lose spin in proportion when they get it:
// implicit Euler for what can't be resolved anyway. Everything slower is left exactly as it is.
// The same goes for the mass of bodies between rods (Distance): there the stiffness is f / length.
#pragma once

#include "engine/physics/dynamics/joint/joint_group.h"

namespace plumbline::physics {

class GeometricStiffness {
public:
    /// Raises masses by the forces of the step before (SolverJoint::mean_load). No body loses speed
    /// by it: it was as heavy when that step ended.
    void start(JointGroup& group);
    /// Raises masses by the impulses of the sub-step so far and by the position corrections (impulse
    /// times the sub-step) about to be made. Returns whether a body changed: the rows' responses then
    /// changed too.
    bool raise(JointGroup& group, std::span<const Vec3d> corrections);
    /// Gives back what the impulses of the sub-step do not ask for.
    void lower(JointGroup& group);
    /// As JointWork.
    double unresolved() const { return unresolved_; }

private:
    /// A node whose force pulls at arms, and how far from each of the bodies' axes it does.
    struct Pull {
        std::uint32_t node{0};
        Vec3d lever_a_m{0, 0, 0};
        Vec3d lever_b_m{0, 0, 0};
        Vec3d force_N{0, 0, 0};  ///< on b
    };
    /// A body's stiffness by what pulls at it, and what a sub-step can follow.
    struct Load {
        Vec3d turning_Nm{0, 0, 0};  ///< about its axes
        double across_Npm{0};       ///< across rods and ropes
        Vec3d turning_limit_Nm{0, 0, 0};
        double across_limit_Npm{0};
        double pivot_kgm2{0};  ///< what turning it moves besides itself
        std::uint32_t joints{0};
    };

    void list_pulls(const JointGroup& group);
    void find_pivots(const JointGroup& group);
    bool find_stiffness(const JointGroup& group);
    bool is_too_fast() const;
    /// What the body needs about one of its axes; what mass.
    double wanted_moment(const JointGroup& group, std::size_t body, int axis) const;
    double wanted_mass(const JointGroup& group, std::size_t body) const;
    bool raise_moments(JointGroup& group, std::size_t body, bool slow_down);
    bool raise_mass(JointGroup& group, std::size_t body, bool slow_down);
    /// The velocity of what a body is tied to across, weighed by how hard.
    Vec3d velocity_around(const JointGroup& group, std::size_t body) const;
    /// How many times too long the sub-step is for the fastest of these.
    static double times_too_long(std::span<const Load> loads);

    std::vector<Pull> pulls_;
    std::vector<Load> loads_;  // by body
    bool raised_{false};       // some body is more than itself
    double unresolved_{0};
};

}  // namespace plumbline::physics
