#include "engine/physics/dynamics/joint/joint_iterative.h"

#include "engine/physics/dynamics/joint/softness.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

/// As stiff as a sub-step can follow: a quarter of its rate, strongly damped.
constexpr double kFrequencyTimesSubstep = 0.25;
constexpr double kDampingRatio = 5;

std::uint8_t unbounded(const JointRows& rows) {
    return static_cast<std::uint8_t>(rows.active & ~rows.bounded);
}

Vec3d kept_of(const Vec3d& v, std::uint8_t rows) {
    return {(rows & 1) != 0 ? v.x : 0, (rows & 2) != 0 ? v.y : 0, (rows & 4) != 0 ? v.z : 0};
}

/// The inverse of the block of some rows; zero in the others.
Symmetric3 inverse_of_rows(Symmetric3 s, std::uint8_t rows) {
    const double more = 1e-9 / 3 * (s.xx + s.yy + s.zz);
    if ((rows & 1) == 0 || !(s.xx > 0)) s.xx = 1, s.xy = 0, s.xz = 0;
    if ((rows & 2) == 0 || !(s.yy > 0)) s.yy = 1, s.xy = 0, s.yz = 0;
    if ((rows & 4) == 0 || !(s.zz > 0)) s.zz = 1, s.xz = 0, s.yz = 0;
    return factored(s, std::max(more, 1e-300)).inverse();
}

bool is_places(NodeKind kind) {
    return kind == NodeKind::Point || kind == NodeKind::Across || kind == NodeKind::Length;
}

}  // namespace

void IterativeJoints::start(JointGroup& group) {
    accumulated_.assign(group.rows.size(), Vec3d{0, 0, 0});
    for (std::size_t i = 0; i < group.rows.size(); ++i) {
        const JointRows& rows = group.rows[i];
        const SolverJoint& joint = group.joints[group.topology->nodes[i].joint];
        const std::size_t first = is_places(rows.kind) ? 0 : 3;
        for (std::size_t k = 0; k < 3; ++k) {
            accumulated_[i][static_cast<int>(k)] =
                static_cast<double>(joint.mean_load[first + k]) * group.substep_s;
        }
        accumulated_[i] = kept_of(accumulated_[i], unbounded(rows));
    }
    for (JointBound& bound : group.bounds) {
        const SolverJoint& joint = group.joints[bound.joint_index];
        const auto slot = bound.step == BoundStep::Lower   ? bound.lower_slot
                          : bound.step == BoundStep::Upper ? bound.upper_slot
                                                           : std::uint8_t{2};
        const bool carries = bound.step == BoundStep::Lower || bound.step == BoundStep::Upper ||
                             bound.step == BoundStep::Driven;
        if (carries) {
            bound.impulse = static_cast<double>(joint.bound_load[slot]) * group.substep_s;
        }
    }
    refresh(group);
}

void IterativeJoints::refresh(const JointGroup& group) {
    mass_.resize(group.rows.size());
    error_.resize(group.rows.size());
    for (std::size_t i = 0; i < group.rows.size(); ++i) {
        const JointRows& rows = group.rows[i];
        mass_[i] = inverse_of_rows(own_coupling(rows, group.bodies), unbounded(rows));
        error_[i] = rows.errors(group.bodies);
    }
}

void IterativeJoints::warm_start(JointGroup& group) {
    // First order all through: half of a force's way would only be taken back by the soft joints.
    for (const JointBody& body : group.bodies) {
        if (!body.movable) continue;
        body.body->velocity_increment_mps = {0, 0, 0};
        body.body->spin_increment_radps = {0, 0, 0};
    }
    for (std::size_t i = 0; i < group.rows.size(); ++i) {
        group.rows[i].push(group.bodies, accumulated_[i]);
        group.impulses[i] += accumulated_[i];
    }
    for (JointBound& bound : group.bounds) {
        const double warm = bound.impulse;
        bound.before_motion(group.substep_s);
        bound.impulse = warm;
        Vec3d along{0, 0, 0};
        along[bound.row] = warm;
        group.rows[bound.node].push(group.bodies, along);
        group.impulses[bound.node] += along;
    }
}

void IterativeJoints::sweep(JointGroup& group, bool with_bias) {
    const auto h = static_cast<Real>(group.substep_s);
    const Softness softness = softness_of(
        static_cast<Real>(kFrequencyTimesSubstep) / h, static_cast<Real>(kDampingRatio), h);
    const double share = with_bias ? static_cast<double>(softness.mass_share) : 1;
    const double decay = with_bias ? static_cast<double>(softness.decay) : 0;
    const double bias_per_s = with_bias ? static_cast<double>(softness.bias_per_s) : 0;
    for (std::size_t i = 0; i < group.rows.size(); ++i) {
        const JointRows& rows = group.rows[i];
        const double size = glm::length(error_[i]);
        const double rate = size > 0 ? std::min(bias_per_s, kPush_mps / size + 1) : 0;
        Vec3d change = rows.speeds(group.bodies);
        if (with_bias) change += error_[i] * rate;
        change = mass_[i] * (-share * kept_of(change, unbounded(rows))) - decay * accumulated_[i];
        accumulated_[i] += change;
        rows.push(group.bodies, change);
        group.impulses[i] += change;
    }
    for (JointBound& bound : group.bounds) solve_bound(group, bound);
    group.row_solves += 3 * group.rows.size() + group.bounds.size();
}

void IterativeJoints::solve_bound(JointGroup& group, JointBound& bound) {
    const JointRows& rows = group.rows[bound.node];
    const double speed = rows.speeds(group.bodies)[bound.row];
    const double at_lower = bound.impulse + bound.mass * (bound.slowest - speed);
    const double at_upper = bound.impulse + bound.mass * (bound.fastest - speed);
    double wanted = 0;
    if (bound.motor_impulse > 0) {
        const double missing = bound.motor_speed - bound.slope * bound.impulse - speed;
        wanted = std::clamp(bound.impulse + bound.mass * missing / (1 + bound.mass * bound.slope),
                            -bound.motor_impulse,
                            bound.motor_impulse);
    }
    if (bound.step == BoundStep::Locked) {
        wanted = bound.impulse + bound.mass * (bound.wanted_speed() - speed);
    } else {
        bound.step = wanted < at_lower         ? BoundStep::Lower
                     : wanted > at_upper       ? BoundStep::Upper
                     : bound.motor_impulse > 0 ? BoundStep::Driven
                                               : BoundStep::Forward;
        wanted = std::clamp(wanted, at_lower, std::max(at_lower, at_upper));
    }
    Vec3d change{0, 0, 0};
    change[bound.row] = wanted - bound.impulse;
    bound.impulse = wanted;
    rows.push(group.bodies, change);
    group.impulses[bound.node] += change;
}

void IterativeJoints::finish(const JointGroup& group) const {
    for (std::size_t i = 0; i < group.rows.size(); ++i) {
        SolverJoint& joint = group.joints[group.topology->nodes[i].joint];
        const std::size_t first = is_places(group.rows[i].kind) ? 0 : 3;
        for (std::size_t k = 0; k < 3; ++k) {
            joint.mean_load[first + k] =
                static_cast<Real>(accumulated_[i][static_cast<int>(k)] / group.substep_s);
        }
    }
}

}  // namespace plumbline::physics
