// A joint's rows: what the bodies' velocities mean along them, and what impulses along them do.
//
// A row's speed is J v. Rows with bounds are the rate of the joint's position (JointState); the
// others that of its error, of b against a. An impulse along a row pushes its speed up.
#pragma once

#include "engine/physics/dynamics/joint/block/block3.h"
#include "engine/physics/dynamics/joint/joint_topology.h"

namespace plumbline::physics {

/// Anchors nearer to each other than this have no direction between them.
inline constexpr double kNoLength_m = 1e-9;

/// A body in double precision while its joints are solved.
struct JointBody {
    Vec3d velocity_mps{0, 0, 0};
    Vec3d spin_radps{0, 0, 0};
    double inverse_mass{0};        ///< what joints feel: geometric_stiffness.h
    Symmetric3 inverse_inertia{};  ///< world axes
    Vec3d position_m{0, 0, 0};
    Block3 axes{};  ///< rotation matrix, world from body
    Quatd orientation{1, 0, 0, 0};

    // Impulses times the sub-step that positions are corrected with.
    Vec3d pushed_kgm{0, 0, 0};
    Vec3d twisted_kgm2{0, 0, 0};
    Vec3d twisted_in_all_kgm2{0, 0, 0};
    Vec3d momentum_Nms{0, 0, 0};

    double own_inverse_mass{0};
    Vec3d moments{0, 0, 0};            ///< body axes
    Vec3d effective_inertia{0, 0, 0};  ///< what joints feel: geometric_stiffness.h
    Vec3d inverse_moments{0, 0, 0};    ///< of effective_inertia; 0 where they are 0
    bool round{true};
    bool of_rod{
        false};  ///< an elastic joint holds it: contacts feel the inertia that joints feel, also where it is round
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
    void set_effective_inertia(const Vec3d& felt);
    /// Leaves these shares of the spin about the body's axes, in the way since `duration_s` too.
    void slow_down(const Vec3d& kept, double duration_s);
    /// Notes the angular momentum that goes with the spin at the pose; set_spin() at a later pose
    /// finds the spin that goes with it and with what the corrections twisted.
    void note_momentum();
    void set_spin(double substep_s);
    /// Moves by what pushed and twisted say.
    void displace();
    Vec3d velocity_at(const Vec3d& arm) const { return velocity_mps + glm::cross(spin_radps, arm); }
};

/// The joint's frame in both bodies, as it was made.
struct JointFrames {
    Vec3d axis_in_a{1, 0, 0};
    Block3 axes_in_b{};  ///< by rows
    Quatd turn_in_a{1, 0, 0, 0};
    Quatd turn_in_b{1, 0, 0, 0};
};

struct JointRows {
    NodeKind kind{NodeKind::None};
    std::uint8_t active{0};   ///< rows that are solved, by bits; the others stay at zero
    std::uint8_t bounded{0};  ///< rows that only are while they are at a bound
    bool elastic{false};      ///< all three are springs, active only while these are solved
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

    JointFrames frames{};
    double rest_m{0};
    double length_m{0};       ///< Length: at the latest refresh
    double near_rad{0};       ///< the twist about the axis is the one nearest to it
    bool fixed_swing{false};  ///< cone without any opening: Align's two rows hold

    static JointRows of(const JointNode& node, const SolverJoint& joint);
    /// Arms, J and responses at the bodies' poses.
    void refresh(std::span<const JointBody> bodies) {
        if (kind == NodeKind::Point) {
            arm_a = bodies[a].axes * anchor_in_a;
            arm_b = bodies[b].axes * anchor_in_b;
        } else {
            refresh_others(bodies);
        }
        update_responses(bodies);
    }
    /// What impulses do to the spins, after the bodies' inertia changed.
    void update_responses(std::span<const JointBody> bodies);
    /// Errors of the rows at the bodies' poses; of bounded rows, the position.
    Vec3d errors(std::span<const JointBody> bodies) const {
        return kind == NodeKind::Point ? gap(bodies) : other_errors(bodies);
    }
    /// Whether a bounded row means anything: a twist does not where the axes are nearly opposite.
    bool has_position(int row, std::span<const JointBody> bodies) const;
    /// J v, of all rows whether active or not.
    Vec3d speeds(std::span<const JointBody> bodies) const {
        const JointBody& body_a = bodies[a];
        const JointBody& body_b = bodies[b];
        if (kind == NodeKind::Point) return body_b.velocity_at(arm_b) - body_a.velocity_at(arm_a);
        return linear * (body_b.velocity_mps - body_a.velocity_mps) +
               angular_a * body_a.spin_radps + angular_b * body_b.spin_radps;
    }
    /// Velocities changed by impulses along the rows.
    void push(std::span<JointBody> bodies, const Vec3d& impulse) const {
        JointBody& body_a = bodies[a];
        JointBody& body_b = bodies[b];
        const Vec3d force = kind == NodeKind::Point ? impulse : linear.transposed_times(impulse);
        body_a.velocity_mps -= force * body_a.inverse_mass;
        body_b.velocity_mps += force * body_b.inverse_mass;
        body_a.spin_radps += response_a * impulse;
        body_b.spin_radps += response_b * impulse;
    }
    /// Adds the impulses to what the bodies will be displaced by.
    void displace(std::span<JointBody> bodies, const Vec3d& impulse) const {
        JointBody& body_a = bodies[a];
        JointBody& body_b = bodies[b];
        const bool point = kind == NodeKind::Point;
        const Vec3d force = point ? impulse : linear.transposed_times(impulse);
        body_a.pushed_kgm -= force;
        body_b.pushed_kgm += force;
        body_a.twisted_kgm2 +=
            point ? glm::cross(impulse, arm_a) : angular_a.transposed_times(impulse);
        body_b.twisted_kgm2 +=
            point ? glm::cross(arm_b, impulse) : angular_b.transposed_times(impulse);
    }
    /// From a's anchor to b's.
    Vec3d gap(std::span<const JointBody> bodies) const {
        const JointBody& body_a = bodies[a];
        const JointBody& body_b = bodies[b];
        return (body_b.position_m - body_a.position_m) +
               (body_b.axes * anchor_in_b - body_a.axes * anchor_in_a);
    }
    /// What impulses along the rows give to a: force and pure torque.
    Vec3d force_on_a(const Vec3d& impulse) const;
    Vec3d torque_on_a(const Vec3d& impulse) const;
    bool is_active(int row) const { return ((active >> row) & 1) != 0; }

private:
    void refresh_others(std::span<const JointBody> bodies);
    void refresh_across(const JointBody& a, const JointBody& b);
    void refresh_length(std::span<const JointBody> bodies);
    void refresh_align(const JointBody& a, const JointBody& b);
    void refresh_swing(const JointBody& a, const JointBody& b);
    Vec3d other_errors(std::span<const JointBody> bodies) const;
    Vec3d align_errors(const JointBody& a, const JointBody& b) const;
    Vec3d swing_errors(const JointBody& a, const JointBody& b) const;
    double twist(const JointBody& a, const JointBody& b) const;
};

/// The product of the matrix that takes a spin to `spin x arm` and m.
inline Block3 spin_times(const Vec3d& arm, const Block3& m) {
    return {{arm.z * m.row[1] - arm.y * m.row[2],
             arm.x * m.row[2] - arm.z * m.row[0],
             arm.y * m.row[0] - arm.x * m.row[1]}};
}

/// Block (row, column) of A, by the body that both hold.
Block3 coupling_of_others(const JointRows& row,
                          bool row_is_b,
                          const JointRows& column,
                          bool column_is_b,
                          double inverse_mass);
inline Block3 coupling(const JointRows& row,
                       bool row_is_b,
                       const JointRows& column,
                       bool column_is_b,
                       double inverse_mass) {
    const double mass = row_is_b == column_is_b ? inverse_mass : -inverse_mass;
    if (row.kind != NodeKind::Point || column.kind != NodeKind::Point) {
        return coupling_of_others(row, row_is_b, column, column_is_b, mass);
    }
    const Block3& response = column_is_b ? column.response_b : column.response_a;
    Block3 block = spin_times(row_is_b ? row.arm_b : -row.arm_a, response);
    block.row[0].x += mass;
    block.row[1].y += mass;
    block.row[2].z += mass;
    return block;
}

/// The diagonal's block, by both bodies.
Symmetric3 own_coupling_of_others(const JointRows& rows, std::span<const JointBody> bodies);
inline Symmetric3 own_coupling(const JointRows& rows, std::span<const JointBody> bodies) {
    if (rows.kind != NodeKind::Point) return own_coupling_of_others(rows, bodies);
    const double mass = bodies[rows.a].inverse_mass + bodies[rows.b].inverse_mass;
    const Vec3d& r = rows.arm_b;
    const Vec3d& s = rows.arm_a;
    const auto& p = rows.response_b.row;
    const auto& q = rows.response_a.row;
    return {mass + (r.z * p[1].x - r.y * p[2].x) - (s.z * q[1].x - s.y * q[2].x),
            (r.z * p[1].y - r.y * p[2].y) - (s.z * q[1].y - s.y * q[2].y),
            (r.z * p[1].z - r.y * p[2].z) - (s.z * q[1].z - s.y * q[2].z),
            mass + (r.x * p[2].y - r.z * p[0].y) - (s.x * q[2].y - s.z * q[0].y),
            (r.x * p[2].z - r.z * p[0].z) - (s.x * q[2].z - s.z * q[0].z),
            mass + (r.y * p[0].z - r.x * p[1].z) - (s.y * q[0].z - s.x * q[1].z)};
}

}  // namespace plumbline::physics
