// The joints of one island during one step: what both ways of solving them work on.
#pragma once

#include "engine/physics/dynamics/joint/joint_bounds.h"
#include "engine/physics/dynamics/joint/joint_rows.h"

namespace plumbline::physics {

/// The impulses that a joint has given to its body a in this step, world axes, up to the latest
/// refresh of the rows.
struct JointTotal {
    Vec3d impulse_Ns{0, 0, 0};
    Vec3d angular_impulse_Nms{0, 0, 0};
};

struct JointGroup {
    double substep_s{0};
    std::span<SolverJoint> joints;
    const JointTopology* topology{nullptr};
    std::vector<JointBody> bodies;  ///< as topology->bodies
    std::vector<JointRows> rows;    ///< as topology->nodes
    std::vector<Vec3d> impulses;    ///< along the rows, since the latest refresh
    /// Errors, m or rad, that rows have when the step begins. Bodies are held at them, and they are
    /// reduced slowly.
    std::vector<Vec3d> residual;
    bool any_residual{false};
    std::vector<JointBound> bounds;  ///< in the order of the rows
    std::vector<JointTotal> totals;  ///< by joint
    std::uint64_t row_solves{0};

    /// Bodies, rows and bounds of the topology at the start of a step.
    void start(std::span<SolverBody> island_bodies);
    void read_velocities() {
        for (JointBody& body : bodies) body.read_velocities();
    }
    void write_velocities() const {
        for (const JointBody& body : bodies) body.write_velocities();
    }
    /// Rows and bounds at the bodies' poses; what the old rows carried goes to the totals.
    void refresh();
    void collect_totals();
    /// Adds the bound's row to the solve, or removes it, as the bound's step asks for.
    void set_active(const JointBound& bound);
    std::span<JointBound> bounds_of(const JointComponent& component);
    /// Gives rows that have all of a constant impulse, or none of it, what they lack.
    void push_constant_bounds(std::span<JointBound> component_bounds);
    /// Whether a bound was on a wrong step and is on another now. In late rounds only the first wrong
    /// one changes, so that none chase each other.
    bool update_steps(std::span<JointBound> component_bounds, int round);
    /// Other joints, or a long lever, would make the slow push of a limit one of any force and of any
    /// speed elsewhere. It gives no more energy than it would give the joint's bodies alone. Whether
    /// one would have given more by these impulses, and is slower now.
    static bool ease_pushes(std::span<JointBound> component_bounds,
                            std::span<const Vec3d> more_impulses);
    /// Velocities without half of what steady forces change in a sub-step (1), or with it again (-1).
    void take_half_of_steady(double sign);
    /// The residual after a sub-step of correction: a bounded displacement nearer to nothing.
    static Vec3d reduced_residual(const Vec3d& residual, double substep_s);
};

}  // namespace plumbline::physics
