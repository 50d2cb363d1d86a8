#include "engine/physics/dynamics/joint/joint_spring.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

/// Springs on one body may together have this much of (angular frequency * sub-step)^2, and of
/// damping rate * sub-step, to be followed explicitly; 4 would be unstable.
constexpr double kMostExplicit = 0.25;
/// ... and above this of it the swing is not followed at all.
constexpr double kMostImplicit = 400;
/// ... nor is that of turning bodies above this of it, as it leaves the line that it is taken along.
constexpr double kMostTurn = 1;

/// At most what an impulse at the anchor changes the anchor's velocity by, whatever its direction.
double most_inverse_mass(const SolverBody& body, const Vec3d& anchor) {
    if (!body.movable()) return 0;
    double largest = 0;
    for (const double moment : {body.inertia_kgm2.x, body.inertia_kgm2.y, body.inertia_kgm2.z}) {
        if (moment > 0) largest = std::max(largest, 1 / moment);
    }
    return static_cast<double>(body.inverse_mass) + glm::dot(anchor, anchor) * largest;
}

/// (Angular frequency * sub-step)^2 of the swing in which the bodies only turn.
double lever_share(const SolverJoint& spring,
                   std::span<const SolverBody> bodies,
                   double substep_s) {
    const auto by_lever = [](const SolverBody& body, const Vec3d& anchor) {
        return most_inverse_mass(body, anchor) - static_cast<double>(body.inverse_mass);
    };
    return static_cast<double>(spring.stiffness_Npm) * substep_s * substep_s *
           (by_lever(bodies[spring.a], spring.anchor_in_a) +
            by_lever(bodies[spring.b], spring.anchor_in_b));
}

/// 1 - (sin(x)/x)^2.
double lost_by_steps(double x) {
    if (x < 1e-3) return x * x / 3;
    const double quotient = portable_sin(x) / x;
    return 1 - quotient * quotient;
}

void add_to_totals(const JointSpring& spring,
                   const SpringLine& line,
                   double impulse_Ns,
                   JointGroup& group) {
    group.totals[spring.joint].impulse_Ns -= line.direction * impulse_Ns;
}

double force_N(const JointSpring& spring, const SpringLine& line) {
    return spring.stiffness_Npm * (spring.rest_m - line.length_m);
}

/// The relative acceleration along the line by what is known to act, times the mass.
double steady_force_N(const JointSpring& spring, const SpringLine& line) {
    const auto of = [&](const JointBody& body, const Vec3d& arm) {
        if (!body.movable) return 0.0;
        return glm::dot(line.direction,
                        Vec3d(body.body->acceleration_mps2) +
                            glm::cross(Vec3d(body.body->angular_acceleration_radps2), arm));
    };
    return (of(*spring.b, line.arm_b) - of(*spring.a, line.arm_a)) / line.inverse_mass;
}

bool has_steady_change(const SolverBody& body) {
    return body.velocity_increment_mps != Vec3{0, 0, 0} ||
           body.spin_increment_radps != Vec3{0, 0, 0};
}

/// The velocities that the sub-step began with: without what the caller's accelerations did since.
BodyVelocities start_of_substep(const JointBody& body, double substep_s) {
    BodyVelocities start{body.velocity_mps, body.spin_radps};
    if (!body.movable) return start;
    const SolverBody& of = *body.body;
    const bool steady = has_steady_change(of);
    const auto half = static_cast<Real>(substep_s / 2);
    start.velocity_mps -= Vec3d(steady ? of.velocity_increment_mps : of.acceleration_mps2 * half);
    start.spin_radps -=
        Vec3d(steady ? of.spin_increment_radps : of.angular_acceleration_radps2 * half);
    return start;
}

/// What of an impulse was there in the sub-step before and hardly changed since.
double lasting_part(double impulse_Ns, double before_Ns) {
    const double steady_Ns =
        std::min(std::abs(impulse_Ns), std::abs(before_Ns)) - std::abs(impulse_Ns - before_Ns);
    return std::copysign(std::max(steady_Ns, 0.0), impulse_Ns);
}

}  // namespace

SpringLine::SpringLine(const JointSpring& spring) {
    const JointBody& a = *spring.a;
    const JointBody& b = *spring.b;
    arm_a = a.axes * spring.anchor_in_a;
    arm_b = b.axes * spring.anchor_in_b;
    const Vec3d gap = (b.position_m - a.position_m) + (arm_b - arm_a);
    length_m = glm::length(gap);
    if (length_m > kNoLength_m) direction = gap / length_m;
    const Vec3d lever_a = glm::cross(arm_a, direction);
    const Vec3d lever_b = glm::cross(arm_b, direction);
    response_a = a.inverse_inertia * -lever_a;
    response_b = b.inverse_inertia * lever_b;
    inverse_mass = a.inverse_mass + b.inverse_mass - glm::dot(response_a, lever_a) +
                   glm::dot(response_b, lever_b);
}

double SpringLine::speed(const JointSpring& spring) const {
    return glm::dot(direction, spring.b->velocity_at(arm_b) - spring.a->velocity_at(arm_a));
}

double SpringLine::mean_speed(const JointSpring& spring) const {
    const auto steady = [](const JointBody& body, const Vec3d& arm) {
        return Vec3d(body.body->velocity_increment_mps) +
               glm::cross(Vec3d(body.body->spin_increment_radps), arm);
    };
    return speed(spring) -
           0.5 * glm::dot(direction, steady(*spring.b, arm_b) - steady(*spring.a, arm_a));
}

double SpringLine::start_speed(const JointSpring& spring, double substep_s) const {
    const auto at = [&](const JointBody& body, const Vec3d& arm) {
        const BodyVelocities start = start_of_substep(body, substep_s);
        return start.velocity_mps + glm::cross(start.spin_radps, arm);
    };
    return glm::dot(direction, at(*spring.b, arm_b) - at(*spring.a, arm_a));
}

void SpringLine::push(const JointSpring& spring, double impulse_Ns) const {
    spring.a->velocity_mps -= direction * (impulse_Ns * spring.a->inverse_mass);
    spring.b->velocity_mps += direction * (impulse_Ns * spring.b->inverse_mass);
    spring.a->spin_radps += response_a * impulse_Ns;
    spring.b->spin_radps += response_b * impulse_Ns;
}

void SpringLine::push_steadily(JointSpring& spring, double impulse_Ns) const {
    spring.kept_Ns += impulse_Ns;
    if (spring.unresolved) return push(spring, impulse_Ns);
    push(spring, impulse_Ns);
    set_ahead(spring, lasting_part(spring.kept_Ns, spring.before_Ns));
}

void SpringLine::take_back_ahead(JointSpring& spring) const {
    set_ahead(spring, 0);
}

void SpringLine::set_ahead(JointSpring& spring, double ahead_Ns) const {
    const double more_Ns = ahead_Ns - spring.ahead_Ns;
    spring.ahead_Ns = ahead_Ns;
    push(spring, more_Ns);
    // Twice: the motion's speed is without the half of a steady change.
    add_steady_change(spring, 2 * more_Ns);
}

void SpringLine::add_steady_change(const JointSpring& spring, double impulse_Ns) const {
    const auto add = [&](SolverBody& body, double per_mass, const Vec3d& response) {
        body.velocity_increment_mps += Vec3(direction * (impulse_Ns * per_mass));
        body.spin_increment_radps += Vec3(response * impulse_Ns);
    };
    add(*spring.a->body, -spring.a->inverse_mass, response_a);
    add(*spring.b->body, spring.b->inverse_mass, response_b);
}

bool turns_bodies(const SolverJoint& spring, std::span<const SolverBody> bodies, double substep_s) {
    return lever_share(spring, bodies, substep_s) > kMostExplicit;
}

bool is_unresolved(const SolverJoint& spring,
                   std::span<const SolverBody> bodies,
                   double substep_s) {
    const double inverse_mass = most_inverse_mass(bodies[spring.a], spring.anchor_in_a) +
                                most_inverse_mass(bodies[spring.b], spring.anchor_in_b);
    return static_cast<double>(spring.stiffness_Npm) * substep_s * substep_s * inverse_mass >
               kMostImplicit ||
           lever_share(spring, bodies, substep_s) > kMostTurn;
}

void find_stiff_springs(std::span<const SolverBody> bodies,
                        std::span<const SolverJoint> joints,
                        double substep_s,
                        std::vector<double>& by_body,
                        std::vector<bool>& stiff) {
    by_body.assign(bodies.size(), 0.0);
    stiff.assign(joints.size(), false);
    const auto each_side = [&](const SolverJoint& joint, const auto& visit) {
        if (joint.kind != JointKind::Spring) return;
        const double rate = (static_cast<double>(joint.stiffness_Npm) * substep_s +
                             static_cast<double>(joint.damping_Nspm)) *
                            substep_s;
        visit(joint.a, rate * most_inverse_mass(bodies[joint.a], joint.anchor_in_a));
        visit(joint.b, rate * most_inverse_mass(bodies[joint.b], joint.anchor_in_b));
    };
    for (const SolverJoint& joint : joints) {
        each_side(joint, [&](std::uint32_t body, double share) { by_body[body] += share; });
    }
    for (std::size_t i = 0; i < joints.size(); ++i) {
        each_side(joints[i], [&](std::uint32_t body, double share) {
            if (share > 0 && by_body[body] > kMostExplicit) stiff[i] = true;
        });
    }
}

void push_soft_spring(JointSpring& spring,
                      double substep_s,
                      double duration_s,
                      bool after_motion,
                      JointGroup& group) {
    const SpringLine line(spring);
    if (!(line.inverse_mass > 0)) return;
    const auto damp = [&] {
        if (!(spring.damping_Nspm > 0)) return 0.0;
        const double lost = -portable_expm1(-spring.damping_Nspm * line.inverse_mass * duration_s) /
                            line.inverse_mass;
        const double impulse = -line.mean_speed(spring) * lost;
        line.push(spring, impulse);
        add_to_totals(spring, line, impulse, group);
        return impulse;
    };
    if (after_motion) spring.damped_Ns = damp();
    // Explicit pushes make a period too short by the factor whose square this is. What is at rest
    // under its own weight is not changed: there the sum of the forces is zero.
    const double lost =
        lost_by_steps(0.5 * substep_s * std::sqrt(spring.stiffness_Npm * line.inverse_mass));
    const double force = force_N(spring, line);
    const double impulse = duration_s * (force - lost * (force + steady_force_N(spring, line)));
    if (after_motion) {
        spring.kept_Ns = impulse;
        return push_second_half(spring, group);
    }
    spring.kept_Ns = spring.ahead_Ns = 0;
    line.push_steadily(spring, impulse);
    add_to_totals(spring, line, impulse, group);
    const double damped_Ns = damp();
    // At a steady speed the half after the motion sees less of what presses.
    const double quarter = 0.25 * spring.damping_Nspm * line.inverse_mass * substep_s;
    const double later_Ns = damped_Ns * (1 - quarter) / (1 + quarter);
    line.set_ahead(spring, spring.ahead_Ns + lasting_part(later_Ns, spring.damped_Ns));
}

StiffRow push_row(const JointSpring& spring, const SpringLine& line, double duration_s) {
    // The force is that of the middle of the motion, stiffness * (extension + duration * speed), or that of
    // its end, for all of the sub-step.
    if (spring.unresolved) duration_s *= 2;
    const double extension_m = line.length_m - spring.rest_m;
    const double per_speed = spring.stiffness_Npm * duration_s + spring.damping_Nspm;
    return {.bias_mps = spring.stiffness_Npm * extension_m / per_speed,
            .compliance = 1 / (duration_s * per_speed)};
}

bool is_overdamped(const JointSpring& spring, const SpringLine& line) {
    return line.inverse_mass > 0 &&
           spring.damping_Nspm * spring.damping_Nspm * line.inverse_mass > 4 * spring.stiffness_Npm;
}

StiffRow overdamped_row(const JointSpring& spring, const SpringLine& line, double substep_s) {
    const double per_speed = spring.damping_Nspm + spring.stiffness_Npm * substep_s;
    return {.bias_mps = spring.stiffness_Npm * (line.length_m - spring.rest_m) / per_speed,
            .compliance = 1 / (substep_s * per_speed)};
}

void keep_as_steady(JointSpring& spring, double impulse_Ns, double substep_s) {
    const SpringLine line(spring);
    const double start_mps = line.start_speed(spring, substep_s);
    const double passing_mps = start_mps - lasting_part(start_mps, spring.before_mps);
    const double decay =
        (spring.damping_Nspm + spring.stiffness_Npm * substep_s) * line.inverse_mass * substep_s;
    const double passing_Ns = -passing_mps / line.inverse_mass * decay / (1 + decay);
    spring.before_mps = start_mps;
    if (has_steady_change(*spring.a->body) || has_steady_change(*spring.b->body))
        line.add_steady_change(spring, impulse_Ns - passing_Ns);
}

void push_overdamped_spring(JointSpring& spring, JointGroup& group) {
    const SpringLine line(spring);
    spring.overdamped = is_overdamped(spring, line);
    if (!spring.overdamped) return;
    const StiffRow row = overdamped_row(spring, line, group.substep_s);
    const double impulse =
        -(line.speed(spring) + row.bias_mps) / (line.inverse_mass + row.compliance);
    keep_as_steady(spring, impulse, group.substep_s);
    line.push(spring, impulse);
    add_to_totals(spring, line, impulse, group);
}

void push_stiff_spring(JointSpring& spring, double duration_s, JointGroup& group) {
    spring.kept_Ns = spring.ahead_Ns = 0;
    adjust_stiff_spring(spring, duration_s, group);
}

void adjust_stiff_spring(JointSpring& spring, double duration_s, JointGroup& group) {
    const SpringLine line(spring);
    if (!(line.inverse_mass > 0) || !(spring.stiffness_Npm > 0) || spring.overdamped) return;
    const StiffRow row = push_row(spring, line, duration_s);
    const double more =
        -(line.mean_speed(spring) + row.bias_mps + row.compliance * spring.kept_Ns) /
        (line.inverse_mass + row.compliance);
    line.push_steadily(spring, more);
    add_to_totals(spring, line, more, group);
}

void push_second_half(JointSpring& spring, JointGroup& group) {
    if (spring.unresolved) return;
    const SpringLine line(spring);
    line.push(spring, spring.kept_Ns);
    add_to_totals(spring, line, spring.kept_Ns, group);
    spring.before_Ns = spring.kept_Ns;
}

}  // namespace plumbline::physics
