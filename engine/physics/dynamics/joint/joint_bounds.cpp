#include "engine/physics/dynamics/joint/joint_bounds.h"

#include "engine/physics/dynamics/joint/joint_rows.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

/// Limits nearer to each other than this, m or rad, are one.
constexpr double kNoRoom = 1e-9;
/// Speeds nearer to each other than this, m/s or rad/s, are the same.
constexpr double kSameSpeed = 1e-7;
/// More than any machine gives: stands for "unlimited" without spoiling the digits of sums.
constexpr double kMostImpulse = 1e12;

void set_limits(JointBound& bound, const std::array<Real, 2>& limits) {
    bound.lower = static_cast<double>(std::min(limits[0], limits[1]));
    bound.upper = static_cast<double>(std::max(limits[0], limits[1]));
    if (bound.upper - bound.lower < kNoRoom) bound.step = BoundStep::Locked;
}

void set_motor(JointBound& bound, const JointMotor& motor, double substep_s) {
    if (!(motor.max > 0)) return;
    bound.motor_speed = static_cast<double>(motor.target);
    bound.motor_impulse = std::min(static_cast<double>(motor.max) * substep_s, kMostImpulse);
    if (motor.stiffness > 0 || motor.damping > 0) bound.spring = motor;
}

/// The step that the impulses of the step before speak for.
void recall(JointBound& bound, const SolverJoint& joint) {
    if (bound.step == BoundStep::Locked) return;
    const auto kept = [&](std::uint8_t slot) {
        return static_cast<double>(joint.bound_load[slot]);
    };
    const bool has_lower = std::isfinite(bound.lower);
    const bool has_upper = std::isfinite(bound.upper);
    if (std::isfinite(bound.motor_speed)) bound.step = BoundStep::Driven;
    if (has_lower && kept(bound.lower_slot) > 0) bound.step = BoundStep::Lower;
    if (has_upper && kept(bound.upper_slot) < 0) bound.step = BoundStep::Upper;
}

/// What the motor pushes with where a limit keeps the row at that speed.
double push_at(const JointBound& bound, double speed, double without) {
    if (bound.slope > 0)
        return std::clamp(
            (bound.motor_speed - speed) / bound.slope, -bound.motor_impulse, bound.motor_impulse);
    return bound.motor_speed > speed   ? bound.motor_impulse
           : bound.motor_speed < speed ? -bound.motor_impulse
                                       : without;
}

/// The motor pushes on with all it has where the limit is slower than it wants to be.
BoundStep after_lower(const JointBound& bound, double slack) {
    const double pushing = push_at(bound, bound.slowest, -bound.motor_impulse);
    if (bound.impulse >= pushing - slack) return BoundStep::Lower;
    if (bound.slope > 0) return BoundStep::Driven;
    if (!(bound.motor_impulse > 0) || bound.motor_speed <= bound.slowest)
        return BoundStep::Backward;
    return bound.motor_speed <= bound.fastest ? BoundStep::Driven : BoundStep::Upper;
}

BoundStep after_upper(const JointBound& bound, double slack) {
    const double pushing = push_at(bound, bound.fastest, bound.motor_impulse);
    if (bound.impulse <= pushing + slack) return BoundStep::Upper;
    if (bound.slope > 0) return BoundStep::Driven;
    if (!(bound.motor_impulse > 0) || bound.motor_speed >= bound.fastest) return BoundStep::Forward;
    return bound.motor_speed >= bound.slowest ? BoundStep::Driven : BoundStep::Lower;
}

BoundStep after_driven(const JointBound& bound, double slack) {
    const double speed = bound.motor_speed - bound.slope * bound.impulse;
    if (speed < bound.slowest) return BoundStep::Lower;
    if (speed > bound.fastest) return BoundStep::Upper;
    if (bound.impulse > bound.motor_impulse + slack) return BoundStep::Forward;
    if (bound.impulse < -bound.motor_impulse - slack) return BoundStep::Backward;
    return BoundStep::Driven;
}

BoundStep after_constant(const JointBound& bound, double speed) {
    if (speed < bound.slowest - kSameSpeed) return BoundStep::Lower;
    if (speed > bound.fastest + kSameSpeed) return BoundStep::Upper;
    const double beside = bound.slope * bound.motor_impulse - kSameSpeed;
    const bool reached = bound.step == BoundStep::Forward ? speed > bound.motor_speed - beside
                                                          : speed < bound.motor_speed + beside;
    return bound.motor_impulse > 0 && reached ? BoundStep::Driven : bound.step;
}

}  // namespace

double JointBound::wanted_speed() const {
    switch (step) {
        case BoundStep::Lower:
            return slowest;
        case BoundStep::Upper:
            return fastest;
        case BoundStep::Locked:
            return std::clamp(0.0, slowest, std::max(slowest, fastest));
        default:
            return motor_speed;
    }
}

double JointBound::constant_impulse() const {
    return step == BoundStep::Forward ? motor_impulse : -motor_impulse;
}

double JointBound::wanted_position(double substep_s) const {
    return position + wanted_speed() * substep_s;
}

double JointBound::bounded_correction(double deviation, double substep_s) {
    return std::clamp(deviation, -kPush_mps * substep_s, kPush_mps * substep_s);
}

void JointBound::release() {
    position = std::clamp(0.0, lower, upper);
    if (at_limit()) step = BoundStep::Forward;
}

void JointBound::aim(double substep_s) {
    const double scale = spring.by_mass ? driven : 1;
    const double stiffness = scale * static_cast<double>(spring.stiffness);
    const double damping = scale * static_cast<double>(spring.damping);
    const double per_speed = damping + substep_s * stiffness;  // force
    slope = per_speed > 0 ? 1 / (substep_s * per_speed) : 0;
    if (!(slope > 0)) return;
    motor_speed = (stiffness * (static_cast<double>(spring.position) - position) +
                   damping * static_cast<double>(spring.target)) /
                  per_speed;
}

void JointBound::before_motion(double substep_s) {
    impulse = 0;
    eased = false;
    aim(substep_s);
    slowest = std::min((lower - position) / substep_s, kPush_mps);
    fastest = std::max((upper - position) / substep_s, -kPush_mps);
}

void JointBound::after_motion(double substep_s) {
    slowest = std::min((lower - position) / substep_s, 0.0);
    fastest = std::max((upper - position) / substep_s, 0.0);
}

void JointBound::start_motor(double speed) {
    if (step != BoundStep::Driven) return;
    const double wanted = mass * (motor_speed - speed) / (1 + mass * slope);
    if (std::abs(wanted) <= motor_impulse) return;
    step = wanted > 0 ? BoundStep::Forward : BoundStep::Backward;
}

bool JointBound::ease_push(double more) {
    constexpr double kEnough = 1.01;
    const bool pushes = (step == BoundStep::Lower && slowest > 0) ||
                        (step == BoundStep::Upper && fastest < 0) ||
                        (step == BoundStep::Locked && wanted_speed() != 0);
    if (!pushes || eased) return false;
    const double most = mass * kPush_mps * kPush_mps;
    const double given = (impulse + more) * wanted_speed();
    if (!(given > kEnough * most)) return false;
    const double kept = most / given;  // not its root: nor does the impulse grow with the lever
    slowest *= slowest > 0 ? kept : 1;
    fastest *= fastest < 0 ? kept : 1;
    eased = true;
    return true;
}

bool JointBound::update_step(double speed) {
    const BoundStep before = step;
    const double slack = mass * kSameSpeed;
    if (step == BoundStep::Lower)
        step = after_lower(*this, slack);
    else if (step == BoundStep::Upper)
        step = after_upper(*this, slack);
    else if (step == BoundStep::Driven)
        step = after_driven(*this, slack);
    else if (step != BoundStep::Locked)
        step = after_constant(*this, speed);
    return step != before;
}

void JointBound::store_load(SolverJoint& joint, double substep_s) const {
    const auto per_second = static_cast<Real>(impulse / substep_s);
    joint.bound_load[lower_slot] = step == BoundStep::Lower ? std::max(per_second, Real{0}) : 0;
    joint.bound_load[upper_slot] = step == BoundStep::Upper ? std::min(per_second, Real{0}) : 0;
    if (std::isfinite(motor_speed)) joint.bound_load[2] = per_second;
}

void add_bounds(std::uint32_t node_index,
                const JointNode& node,
                const SolverJoint& joint,
                double substep_s,
                JointRows& rows,
                std::vector<JointBound>& bounds) {
    const auto add = [&](JointBound bound, std::uint8_t row) {
        bound.joint_index = node.joint;
        bound.node = node_index;
        bound.row = row;
        recall(bound, joint);
        rows.bounded = static_cast<std::uint8_t>(rows.bounded | (1U << row));
        rows.active = static_cast<std::uint8_t>(rows.active & ~(1U << row));
        bounds.push_back(bound);
    };
    switch (node.kind) {
        case NodeKind::Align:
        case NodeKind::Across: {
            if (!joint.limits && !joint.motor) return;
            JointBound bound;
            if (joint.limits) set_limits(bound, *joint.limits);
            if (joint.motor) set_motor(bound, *joint.motor, substep_s);
            add(bound, 2);
            return;
        }
        case NodeKind::Length: {
            if (joint.kind != JointKind::Distance || !joint.limits) return;
            JointBound bound;
            set_limits(bound, *joint.limits);
            add(bound, 0);
            return;
        }
        case NodeKind::Swing: {
            if (joint.limits && !rows.fixed_swing) {
                const auto [low, high] = *joint.limits;
                JointBound swing;
                swing.upper = static_cast<double>(std::max(std::abs(low), std::abs(high)));
                swing.lower_slot = 0;
                swing.upper_slot = 0;
                add(swing, 0);
            }
            if (joint.twist_limits) {
                JointBound twist;
                set_limits(twist, *joint.twist_limits);
                twist.lower_slot = 1;
                twist.upper_slot = 2;
                add(twist, 2);
            }
            return;
        }
        default:
            return;
    }
}

}  // namespace plumbline::physics
