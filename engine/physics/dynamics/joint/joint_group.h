// The joints of one island during one step: what both ways of solving them work on.
#pragma once

#include "engine/physics/dynamics/joint/block/block_ldlt.h"
#include "engine/physics/dynamics/joint/joint_bounds.h"
#include "engine/physics/dynamics/joint/joint_rows.h"

namespace plumbline::physics {

/// The impulses that a joint has given to its body a in this step, world axes, up to the latest
/// refresh of the rows.
struct JointTotal {
    Vec3d impulse_Ns{0, 0, 0};
    Vec3d angular_impulse_Nms{0, 0, 0};
};

struct BodyVelocities {
    Vec3d velocity_mps{0, 0, 0};
    Vec3d spin_radps{0, 0, 0};
};
/// What acts all through the sub-step changes of a body's velocities.
inline BodyVelocities steady_change_of(const JointBody& body) {
    return {Vec3d(body.body->velocity_increment_mps), Vec3d(body.body->spin_increment_radps)};
}
/// The body's velocities as it moves: without half of that.
inline BodyVelocities mean_motion_of(const JointBody& body) {
    const BodyVelocities steady = steady_change_of(body);
    return {body.velocity_mps - 0.5 * steady.velocity_mps,
            body.spin_radps - 0.5 * steady.spin_radps};
}

/// Where an impulse acts: on a, and the opposite on b. Indices in the island; arms from the centres of mass, world axes.
struct ImpulseLine {
    std::uint32_t a{0};
    std::uint32_t b{0};
    Vec3 arm_a{0, 0, 0};
    Vec3 arm_b{0, 0, 0};
    Vec3 direction{0, 1, 0};  ///< unit
};

struct JointGroup {
    static constexpr std::uint32_t kNoPiece = ~std::uint32_t{0};

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
    std::span<const JointBound> bounds_of(const JointComponent& component) const;
    /// Gives rows that have all of a constant impulse, or none of it, what they lack.
    void push_constant_bounds(std::span<JointBound> component_bounds);
    /// Within with_motion(): what motors that push with all they have change all through the sub-step; nothing is counted.
    void push_constants();
    /// Whether such a motor pushes, or one that gives way, or what acts steadily would take a row off its limit further than a position step comes back.
    bool pushes_steadily();
    /// Whether a bound was on a wrong step and is on another now. In late rounds only the first wrong
    /// one changes, so that none chase each other.
    bool update_steps(std::span<JointBound> component_bounds, int round);
    /// Other joints, or a long lever, would make the slow push of a limit one of any force and of any
    /// speed elsewhere. It gives no more energy than it would give the joint's bodies alone. Whether
    /// one would have given more by these impulses, and is slower now.
    static bool ease_pushes(std::span<JointBound> component_bounds,
                            std::span<const Vec3d> more_impulses);
    /// Solves with the velocities `of` bodies in place of their own.
    template <typename Of, typename Solve>
    void with_motion(Of of, Solve solve) {
        own_.clear();
        for (JointBody& body : bodies) {
            own_.push_back({body.velocity_mps, body.spin_radps});
            const BodyVelocities other = of(body);
            body.velocity_mps = other.velocity_mps;
            body.spin_radps = other.spin_radps;
        }
        solve();
        for (std::size_t i = 0; i < own_.size(); ++i) {
            bodies[i].velocity_mps = own_[i].velocity_mps;
            bodies[i].spin_radps = own_[i].spin_radps;
        }
    }
    /// Within with_motion(): the velocities as the bodies' steady changes.
    void keep_as_steady_changes() const {
        for (const JointBody& body : bodies) {
            body.body->velocity_increment_mps = Vec3(body.velocity_mps);
            body.body->spin_increment_radps = Vec3(body.spin_radps);
        }
    }
    /// Velocities that the rows held now allow, as a linear map: no bound takes hold or lets go, nothing is counted.
    /// `factor`: of these rows; `x`: room for as many.
    void hold_rows(const BlockLdlt& factor, const JointComponent& component, std::span<Vec3d> x);
    /// The number of the component that a body of the island, by its index there, is part of: bodies of one piece move
    /// together. kNoPiece: no joint holds it but springs, or it is immovable.
    std::uint32_t piece_of(std::uint32_t body) const { return sides_[body].piece; }
    /// By how much a unit impulse along one line changes the velocity of a against b along each of the others, 1/kg, with all
    /// rows held that are held now, whose factor this is. The lines' bodies are of two pieces, or the same bodies alone.
    /// Leaves the velocities as they come.
    void respond(const BlockLdlt& factor,
                 const ImpulseLine& pushed,
                 std::span<const ImpulseLine> lines,
                 std::span<double> changes);
    /// The residual after a sub-step of correction: a bounded displacement nearer to nothing.
    static Vec3d reduced_residual(const Vec3d& residual, double substep_s);

private:
    struct Side {
        std::uint32_t piece{kNoPiece};
        std::uint32_t member{0};  ///< in `bodies`
    };

    void find_pieces();
    void stop_piece(std::uint32_t piece);

    std::span<const SolverBody> island_;
    std::vector<Side> sides_;          // by body of the island
    std::vector<Vec3d> held_;          // room for respond()
    std::vector<BodyVelocities> own_;  // room for with_motion()
};

}  // namespace plumbline::physics
