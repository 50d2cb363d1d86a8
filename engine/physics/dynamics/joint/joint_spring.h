// Springs with damping between two anchors.
//
// Soft ones (a sub-step is a small part of their period) push explicitly, by half of the force before the bodies move and
// half of that after, with a force that makes the period of two free bodies right; their damping
// is the exact decay between those pushes. Of the half of after, what hardly changed since the sub-step
// before is pushed ahead until the bodies move: what rests on a spring is pushed by all of it when contacts are solved. Stiff ones follow the implicit midpoint rule, solved
// together with the joints: it keeps the energy. Their damping comes before it and only ever takes
// energy. Springs that swing more than three times within a sub-step follow implicit Euler, which
// takes that swing away: what a turn of bodies stretches them by in a sub-step would swing on. Overdamped stiff ones are one row for spring
// and damping: what creeps does so at the speed at which they balance all else.
#pragma once

#include "engine/physics/dynamics/joint/joint_group.h"

namespace plumbline::physics {

struct JointSpring {
    std::uint32_t joint{0};
    std::uint32_t node{0};  ///< its row, if it is stiff
    JointBody* a{nullptr};
    JointBody* b{nullptr};
    Vec3d anchor_in_a{0, 0, 0};
    Vec3d anchor_in_b{0, 0, 0};
    double stiffness_Npm{0};
    double damping_Nspm{0};
    double rest_m{0};
    double kept_Ns{0};       ///< half of the sub-step's push
    double ahead_Ns{0};      ///< of the other half: before the motion
    double before_Ns{0};     ///< half of the push of the sub-step before
    double damped_Ns{0};     ///< soft: what damping took after the motion of the sub-step before
    double before_mps{0};    ///< overdamped: its speed as the sub-step before began
    double extension_m{0};   ///< stiff: when the motion began
    bool turns{false};       ///< stiff: solved at the end of the motion
    bool overdamped{false};  ///< stiff: one row for spring and damping, all of it before the motion
    bool unresolved{false};  ///< stiff: all of its push comes before the motion
};

/// A spring at its bodies' poses: its direction and what the bodies are along it.
struct SpringLine {
    Vec3d direction{1, 0, 0};  ///< from a's anchor to b's
    Vec3d arm_a{0, 0, 0};
    Vec3d arm_b{0, 0, 0};
    Vec3d response_a{0, 0, 0};  ///< spin of a by an impulse along the line
    Vec3d response_b{0, 0, 0};
    double length_m{0};
    double inverse_mass{0};

    explicit SpringLine(const JointSpring& spring);
    double speed(const JointSpring& spring) const;
    /// The speed without half of what steady forces change in the sub-step: that of the motion.
    double mean_speed(const JointSpring& spring) const;
    double start_speed(const JointSpring& spring, double substep_s) const;
    void push(const JointSpring& spring, double impulse_Ns) const;
    /// More of the half before the motion, and of the other half what hardly changed since the sub-step before, as a steady
    /// change: what a swinging spring pushes ahead of an impact would give energy. Of one that is unresolved nothing is ahead.
    void push_steadily(JointSpring& spring, double impulse_Ns) const;
    /// Takes what was pushed ahead back: it is pushed when the bodies have moved.
    void take_back_ahead(JointSpring& spring) const;
    void set_ahead(JointSpring& spring, double ahead_Ns) const;
    /// What acts on the bodies all through the sub-step.
    void add_steady_change(const JointSpring& spring, double impulse_Ns) const;
};

/// Whether the spring turns its bodies so much within a sub-step that its line at the start says too
/// little: it is solved where the motion ends. By masses and anchors alone.
bool turns_bodies(const SolverJoint& spring, std::span<const SolverBody> bodies, double substep_s);
/// Whether the spring swings its bodies too fast for the sub-step to show. By masses and anchors alone.
bool is_unresolved(const SolverJoint& spring, std::span<const SolverBody> bodies, double substep_s);
/// Which joints are springs that a sub-step of this length can't follow explicitly. By masses and
/// anchors alone, so that it does not change while they move. `by_body` is room to work in.
void find_stiff_springs(std::span<const SolverBody> bodies,
                        std::span<const SolverJoint> joints,
                        double substep_s,
                        std::vector<double>& by_body,
                        std::vector<bool>& stiff);

/// The explicit push of a soft spring, with its damping over half a sub-step: the push first
/// before the bodies move, the damping first after.
void push_soft_spring(
    JointSpring& spring, double substep_s, double duration_s, bool after_motion, JointGroup& group);
/// A stiff spring as a row. With m the row's mass, its impulse J satisfies
/// J / m + compliance * J = -(speed + bias).
struct StiffRow {
    double bias_mps{0};
    double compliance{0};  ///< 1/kg
};
/// Its push and damping before the motion (implicit midpoint); `speed` is the mean one, of the motion. `duration_s`: half a sub-step.
StiffRow push_row(const JointSpring& spring, const SpringLine& line, double duration_s);
/// Whether damping wins: bodies creep, at the speed at which it is as strong as what else acts.
bool is_overdamped(const JointSpring& spring, const SpringLine& line);
/// All that an overdamped spring does in a whole sub-step (implicit Euler), for the present speed: with what steady forces
/// and the impulses of before changed already, so that a light body that is pressed on a damper moves as fast as the load
/// asks for.
StiffRow overdamped_row(const JointSpring& spring, const SpringLine& line, double substep_s);
/// Counts what of that push acts all through the sub-step as a steady change: all but what damps a speed that was another in
/// the sub-step before. Before it is pushed.
void keep_as_steady(JointSpring& spring, double impulse_Ns, double substep_s);

/// A stiff spring by itself: an overdamped one's whole push, another's half before the motion.
void push_overdamped_spring(JointSpring& spring, JointGroup& group);
void push_stiff_spring(JointSpring& spring, double duration_s, JointGroup& group);
/// What contacts changed since the half push before the motion, the push takes in view.
void adjust_stiff_spring(JointSpring& spring, double duration_s, JointGroup& group);
/// The half push after the motion.
void push_second_half(JointSpring& spring, JointGroup& group);

}  // namespace plumbline::physics
