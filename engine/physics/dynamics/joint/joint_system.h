// The joints of one island, solved directly. Knows nothing of Bullet.
//
// J is the joints' Jacobian, A = J M^-1 J^T. A is block-sparse along the joint graph; it is factored
// once per sub-step (L D L^T) and integrated by RATTLE (docs/PHYSICS.md), so chains neither stretch
// nor lose energy. Limits and motors are rows with bounds in the same system: an active set decides
// which of them hold, and the system is factored anew when it changes (joint_bounds.h).
#pragma once

#include "engine/physics/dynamics/solver_body.h"
#include "engine/physics/joint.h"

#include <memory>
#include <span>
#include <vector>

namespace plumbline::physics {

/// A joint during one step: bodies by their index in the island's array.
///
/// The frames' x axis is the joint's axis; both frames coincide at creation. Frame and anchor are
/// in mass frames (at the centre of mass, along the principal axes) and in double precision.
struct SolverJoint {
    JointKind kind{JointKind::BallAndSocket};
    std::uint32_t a{kWorldBody};
    std::uint32_t b{kWorldBody};
    std::uint64_t key{0};  ///< the same joint has the same key in every step
    Vec3d anchor_in_a{0, 0, 0};
    Vec3d anchor_in_b{0, 0, 0};
    Quatd frame_in_a{1, 0, 0, 0};
    Quatd frame_in_b{1, 0, 0, 0};
    std::optional<std::array<Real, 2>> limits{};
    std::optional<std::array<Real, 2>> twist_limits{};
    std::optional<JointMotor> motor{};
    Real stiffness_Npm{0};
    Real damping_Nspm{0};
    Real rest_length_m{0};
    Real bend_Nmprad{0};
    Real damping_s{0};
    Real pressed_decay_per_s{0};

    // Kept by the caller from step to step, in N and N m: mean loads of sub-steps, which fit sub-steps
    // of any length.
    /// Warm start of limits and motor; of a spring its latest push, what damping took of it, and its speed in m/s.
    std::array<Real, 3> bound_load{0, 0, 0};
    /// Force and torque: warm start of the iterative method; with the direct one those on b, by which
    /// the next step knows how hard bodies are pulled.
    std::array<Real, 6> mean_load{0, 0, 0, 0, 0, 0};
    /// Of an elastic one: how fast its extension and its bend changed in the latest sub-step, m/s and rad/s.
    std::array<Real, 6> elastic_speed{0, 0, 0, 0, 0, 0};

    // Left by finish().
    Vec3d total_impulse_Ns{0, 0, 0};  ///< on a, over the step
    Vec3d total_angular_impulse_Nms{0, 0, 0};
    double error_m{0};   ///< as JointState
    double position{0};  ///< as JointState
};

/// Whether it stores energy.
inline bool is_elastic(const SolverJoint& joint) {
    return joint.kind == JointKind::Spring || joint.kind == JointKind::Elastic;
}

/// Work and condition of the latest step.
struct JointWork {
    std::uint64_t row_solves{0};
    double max_error_m{0};
    /// How many times too long a sub-step was for the fastest swinging of light bodies that joints
    /// pull hard: such bodies were slowed down and lost energy. 0: nothing was too fast.
    double unresolved{0};
    /// Direct becomes Iterative where the factor would fill in too much: nets of thousands.
    JointMethod method{JointMethod::Direct};
};

struct ImpulseLine;

/// One island's joints through the sub-steps of one step. Reused from step to step: what depends
/// only on which joint holds which bodies is kept while it does not change.
///
/// Order of a sub-step of h seconds, all of it even without a single spring or limit:
///     the bodies' accelerations change the velocities for h, by the caller, who notes the change in
///     velocity_increment_mps and spin_increment_radps
///     push_springs(h/2); solve_velocities(), which contact sweeps may alternate with
///     begin_motion()
///     bodies move by their velocity less half of the steady change, by the caller
///     correct_positions(); push_springs(h/2); refresh()
///     solve_velocities(), which relax sweeps may alternate with
/// The same without steady changes, which must then be zero at the start: accelerations for h/2 at the start, and for h/2
/// again before the last solve. Both are second order.
class JointSystem {
public:
    JointSystem();
    ~JointSystem();
    JointSystem(JointSystem&&) noexcept;
    JointSystem& operator=(JointSystem&&) noexcept;

    /// The spans must stay where they are until finish(). `substep_s` is h.
    void start(std::span<SolverBody> bodies,
               std::span<SolverJoint> joints,
               double substep_s,
               JointMethod method);
    /// Springs and their damping, as velocity changes over `duration_s`, half a sub-step. The first
    /// of the two begins the sub-step.
    void push_springs(double duration_s);
    /// Before the first push of a sub-step. The number of the piece of bodies that joints hold together; kNoPiece with the
    /// iterative method.
    std::uint32_t piece_of(std::uint32_t body) const;
    /// As JointGroup::respond().
    void respond(const ImpulseLine& pushed,
                 std::span<const ImpulseLine> lines,
                 std::span<double> changes);
    /// Velocities that the joints of one piece allow.
    void solve_piece(std::uint32_t piece);
    /// The joints' impulses are given back, later, as they are now: what was solved since was a try.
    void note_impulses();
    void return_impulses();
    /// After impacts: what they took of the joints is no force that lasts, and springs push as if they had not pushed before.
    void end_impacts();
    /// Velocities that the joints allow: limits and motors swept, then all rows exactly.
    void solve_velocities();
    /// Takes back what springs pushed ahead. `hold_steady_changes`: takes out of the bodies' steady changes what joints take out
    /// of their velocities, so that where forces, contacts and joints balance none is left to take half of the way for.
    void begin_motion(bool hold_steady_changes);
    /// Puts the bodies back on the joints after they moved; the velocities get what that took.
    void correct_positions();
    /// Jacobians, world inertias and factor at the present poses; and what of begin_motion() acts there.
    void refresh();
    /// Impulse totals, errors and warm-start numbers into the joints.
    void finish();
    /// Whether velocities must be solved before the bodies move in an island that touches nothing.
    /// If not, correct_positions() finds the same impulses, and the solve may be left out.
    bool solves_before_motion() const;

    /// How fast what joints hold changes, the largest of their rows, m/s or rad/s; infinite with the iterative method, which never
    /// holds all. From start() on.
    double most_speed() const;
    /// Springs that sub-steps do not follow explicitly. From start() on.
    bool has_stiff_springs() const;
    const JointWork& work() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace plumbline::physics
