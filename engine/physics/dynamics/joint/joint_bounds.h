// Limits and motors: rows that only count while they are at a bound.
//
// A row's impulse as a function of its speed rises in steps: at the lower limit as much as it
// takes, below the motor's speed all the motor has, at that speed as much as it takes, above it
// all against it, at the upper limit as much as it takes. A row is on one of those steps. Of a motor with stiffness or
// damping the middle step slopes: its impulse falls as its speed rises.
#pragma once

#include "engine/physics/dynamics/joint/joint_topology.h"

#include <limits>

namespace plumbline::physics {

struct JointRows;

/// The fastest that a position error is pushed back, m/s or rad/s.
inline constexpr double kPush_mps = 3.0;

enum class BoundStep : std::uint8_t {
    Lower,    ///< held at the lower limit, or coming to it within the sub-step
    Forward,  ///< slower than the motor's speed: its whole impulse; without a motor none
    Driven,   ///< at the motor's speed
    Backward,
    Upper,
    Locked,  ///< both limits are the same
};

struct JointBound {
    std::uint32_t joint_index{0};
    std::uint32_t node{0};
    std::uint8_t row{0};         ///< of the node
    std::uint8_t lower_slot{0};  ///< in SolverJoint::bound_load
    std::uint8_t upper_slot{1};
    BoundStep step{BoundStep::Forward};
    double lower{-std::numeric_limits<double>::infinity()};  ///< m or rad
    double upper{std::numeric_limits<double>::infinity()};
    double motor_speed{std::numeric_limits<double>::infinity()};  ///< infinite: no motor
    double motor_impulse{0};                                      ///< at most, in a sub-step
    JointMotor spring{};  ///< the motor, if it has stiffness or damping
    double slope{0};      ///< of that motor: how much slower than motor_speed it is, by impulse
    double driven{
        1};  ///< of one by mass: what the axis moves with all else of the joint held, kg or kg m2

    double mass{0};      ///< impulse by speed, of the row by itself
    double position{0};  ///< at the latest refresh
    double slowest{0};   ///< speed that keeps it above the lower limit
    double fastest{0};
    double impulse{0};  ///< so far in this sub-step
    bool eased{false};  ///< ease_push() slowed it down in this sub-step

    bool at_bound() const { return step != BoundStep::Forward && step != BoundStep::Backward; }
    /// A motor that gives all it has.
    bool drives() const { return !at_bound() && motor_impulse > 0; }
    bool at_limit() const { return step == BoundStep::Lower || step == BoundStep::Upper; }
    /// The speed to solve for when at_bound().
    double wanted_speed() const;
    /// Whether it is a row that gives way.
    bool is_soft() const { return step == BoundStep::Driven && slope > 0; }
    /// The impulse when not.
    double constant_impulse() const;
    /// Where the row is to be after the sub-step's motion, when at_bound().
    double wanted_position(double substep_s) const;
    /// The part of a deviation from it, m or rad, that one sub-step corrects.
    static double bounded_correction(double deviation, double substep_s);

    /// Puts the row between its limits: its position is undefined at the bodies' poses.
    void release();
    /// What a motor with stiffness or damping aims at in the sub-step that begins, from its position.
    void aim(double substep_s);
    /// Sets the speeds for the sub-step's motion: passed limits are approached at a bounded speed.
    void before_motion(double substep_s);
    /// Sets the speeds after the motion: what is past a limit only has to stop.
    void after_motion(double substep_s);
    /// A motor that the row by itself, at this speed, is out of reach of begins with all it has. What it drives may be far heavier.
    void start_motor(double speed);
    /// Slows down what brings a passed limit back, once in a sub-step, if the impulse beside
    /// `impulse` that it takes would give too much energy. Whether it did.
    bool ease_push(double more);
    /// Moves to the step to which this speed and `impulse` belong. Returns whether that is another.
    bool update_step(double speed);
    /// Stores the mean load, N or N m, with which the next step starts.
    void store_load(SolverJoint& joint, double substep_s) const;
};

/// The bounds of a joint's node, one or two or none, appended. `rows` learns which of its are.
void add_bounds(std::uint32_t node_index,
                const JointNode& node,
                const SolverJoint& joint,
                double substep_s,
                JointRows& rows,
                std::vector<JointBound>& bounds);

}  // namespace plumbline::physics
