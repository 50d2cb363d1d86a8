// A joint's rows: what the bodies' velocities mean along them, and what impulses along them do.
//
// A row's speed is J v. Rows with bounds are the rate of the joint's position (JointState); the
// others that of its error, of b against a. An impulse along a row pushes its speed up.
#pragma once

#include "engine/physics/small_step/block3.h"
#include "engine/physics/small_step/joint_topology.h"

namespace plumbline::physics {

/// A body in double precision while its joints are solved.
struct JointBody {
    Vec3d velocity_mps{0, 0, 0};
    Vec3d spin_radps{0, 0, 0};
    double inverse_mass{0};
    Symmetric3 inverse_inertia{};  ///< world axes
    Vec3d position_m{0, 0, 0};
    Block3 axes{};  ///< rotation matrix, world from body
    Quatd orientation{1, 0, 0, 0};

    // Impulses times the sub-step that positions are corrected with.
    Vec3d pushed_kgm{0, 0, 0};
    Vec3d twisted_kgm2{0, 0, 0};
    Vec3d twisted_in_all_kgm2{0, 0, 0};

    Vec3d moments{0, 0, 0};          ///< body axes
    Vec3d inverse_moments{0, 0, 0};  ///< of what joints feel: geometric_stiffness.h
    bool round{true};
    bool movable{false};
    SolverBody* body{nullptr};

    /// Masses. The pose and the velocities are read by the functions below.
    static JointBody of(SolverBody& body);
    void read_velocities();
    void write_velocities() const;
    void read_pose();
    void write_pose() const;
    /// The world inertia at the pose.
    void update_inertia();
    /// Leaves these shares of the spin about the body's axes, in the way since `duration_s` too.
    void slow_down(const Vec3d& kept, double duration_s);
    /// Moves by what pushed and twisted say.
    void displace();
    Vec3d velocity_at(const Vec3d& arm) const { return velocity_mps + glm::cross(spin_radps, arm); }
};

struct JointRows {
    NodeKind kind{NodeKind::None};
    std::uint8_t active{0};   ///< rows that are solved, by bits; the others stay at zero
    std::uint8_t bounded{0};  ///< rows that only are while they are at a bound
    std::uint32_t a{0};
    std::uint32_t b{0};

    // At the latest refresh, world axes.
    Vec3d arm_a{0, 0, 0};
    Vec3d arm_b{0, 0, 0};
    Block3 response_a{};  ///< what an impulse along the rows does to a's spin
    Block3 response_b{};
    Vec3d anchor_in_a{0, 0, 0};
    Vec3d anchor_in_b{0, 0, 0};
    // Of kinds other than Point: J by its parts. Linear acts on b and, negated, on a.
    Block3 linear{};
    Block3 angular_a{};
    Block3 angular_b{};

    Vec3d axis_in_a{1, 0, 0};
    Block3 frame_in_b{};  ///< the frame's axes by rows
    Quatd turn_in_a{1, 0, 0, 0};
    Quatd turn_in_b{1, 0, 0, 0};
    double rest_m{0};
    double near_rad{0};       ///< the twist about the axis is the one nearest to it
    bool fixed_swing{false};  ///< cone without any opening: Align's two rows hold

    static JointRows of(const JointNode& node, const SolverJoint& joint);
    /// Arms, J and responses at the bodies' poses.
    void refresh(std::span<const JointBody> bodies);
    /// What impulses do to the spins, after the bodies' inertia changed.
    void update_responses(std::span<const JointBody> bodies);
    /// Errors of the rows at the bodies' poses; of bounded rows, the position.
    Vec3d errors(std::span<const JointBody> bodies) const;
    /// J v, of all rows whether active or not.
    Vec3d speeds(std::span<const JointBody> bodies) const;
    /// Velocities changed by impulses along the rows.
    void push(std::span<JointBody> bodies, const Vec3d& impulse) const;
    /// Adds the impulses to what the bodies will be displaced by.
    void displace(std::span<JointBody> bodies, const Vec3d& impulse) const;
    /// What impulses along the rows give to a: force and pure torque.
    Vec3d force_on_a(const Vec3d& impulse) const;
    Vec3d torque_on_a(const Vec3d& impulse) const;
    bool is_active(int row) const { return ((active >> row) & 1) != 0; }

private:
    void refresh_across(const JointBody& a, const JointBody& b);
    void refresh_length(const JointBody& a, const JointBody& b);
    void refresh_align(const JointBody& a, const JointBody& b);
    void refresh_lock();
    void refresh_swing(const JointBody& a, const JointBody& b);
    Vec3d align_errors(const JointBody& a, const JointBody& b) const;
    Vec3d swing_errors(const JointBody& a, const JointBody& b) const;
    double twist(const JointBody& a, const JointBody& b) const;
};

/// Block (row, column) of A, by what `body` ties together; the diagonal's is both bodies' share.
Block3 coupling(const JointRows& row,
                bool row_is_b,
                const JointRows& column,
                bool column_is_b,
                const JointBody& body);
Symmetric3 own_coupling(const JointRows& rows, std::span<const JointBody> bodies);

}  // namespace plumbline::physics
