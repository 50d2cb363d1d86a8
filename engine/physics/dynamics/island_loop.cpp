#include "engine/physics/dynamics/island_loop.h"

#include "engine/core/time/trace_events.h"
#include "engine/physics/dynamics/rotation.h"

#include <algorithm>

namespace plumbline::physics {
namespace {

using Sweep = ContactSet::Sweep;

/// Slower spins gain less than 1e-4 rad/s2 from the gyroscopic torque: it is left out.
constexpr Real kLeastGyroSpin_radps = 1e-2_r;
/// Without gravity slower impacts do not bounce.
constexpr Real kSlowestBounce_mps = 1e-3_r;
/// Of one sub-step, with bias: an impact reaches as many bodies within it. What rests needs one.
constexpr int kMostSweeps = 8;
/// Of the slowest impact: what a sweep changes a speed by for another to follow. Few bodies without joints are swept until less
/// is left: it costs little.
constexpr Real kRestless = 0.3_r;
constexpr Real kRestlessOfFew = 0.1_r;
/// With joints: what light feet carry of a heavy load comes to them in many sweeps, and what is left of that makes it rock.
constexpr Real kRestlessOfJointed = 0.003_r;
constexpr std::size_t kFewBodies = 64;

/// Many bodies in one place push each other in rows, and what each pair may give adds up: none
/// leaves faster than one pair may push, or than it came. Whether that slowed it.
bool clamp_depenetration_velocity(SolverBody& body, Real push_mps) {
    if (!body.depenetrated || !body.movable()) return false;
    const Real most = std::max(push_mps, body.start_speed_mps);
    const Real speed = glm::length(body.velocity_mps);
    if (speed > most) body.velocity_mps *= most / speed;
    return speed > most;
}

/// What pushed a body off its axes is taken back: the sweeps see its whole mass along all of them
/// and reach the others' share of a push in the sweeps that follow.
void hold_along_axes(std::span<const HeldBody> held, std::span<SolverBody> bodies) {
    for (const HeldBody& each : held) {
        bodies[each.body].velocity_mps *= each.linear_factor;
        bodies[each.body].delta_position_m *= each.linear_factor;
    }
}

/// Forces for the sub-step, and the impulses of the one before.
void apply_steady_forces(std::span<SolverBody> bodies,
                         ContactSet& contacts,
                         FieldForces& fields,
                         const FieldTime& time,
                         Real h) {
    const TraceSpan span("forces");
    contacts.each_body([h](SolverBody& body) {
        body.velocity_increment_mps = body.acceleration_mps2 * h;
        body.spin_increment_radps = body.angular_acceleration_radps2 * h;
    });
    contacts.warm_start();
    if (!fields.empty()) fields.push(bodies, time);
    contacts.each_body([](SolverBody& body) {
        if (!body.movable()) return;
        body.velocity_mps =
            body.velocity_mps * body.linear_damping_factor + body.velocity_increment_mps;
        body.spin_radps = body.spin_radps * body.angular_damping_factor + body.spin_increment_radps;
    });
}

/// World axes, of the pose now.
void renew_inertia(SolverBody& body) {
    const Mat3 axes = glm::mat3_cast(Quat(Quatd(body.delta_rotation) * body.start_orientation));
    SymmetricMat3& m = body.inverse_inertia;
    m = {};
    for (int k = 0; k < 3; ++k) {
        const double moment = body.inertia_kgm2[k];
        const Real inverse = moment > 0 ? static_cast<Real>(1 / moment) : Real{0};
        const Vec3& axis = axes[k];
        m.xx += inverse * axis.x * axis.x;
        m.xy += inverse * axis.x * axis.y;
        m.xz += inverse * axis.x * axis.z;
        m.yy += inverse * axis.y * axis.y;
        m.yz += inverse * axis.y * axis.z;
        m.zz += inverse * axis.z * axis.z;
    }
}

void turn_body(SolverBody& body, bool gyroscopic_torque, Real h) {
    const bool gyroscopic =
        gyroscopic_torque && body.movable() && !body.isotropic_inertia &&
        glm::dot(body.spin_radps, body.spin_radps) > kLeastGyroSpin_radps * kLeastGyroSpin_radps;
    if (!gyroscopic) {
        const Vec3 mean = body.spin_radps - body.spin_increment_radps * Real{0.5};
        body.delta_rotation = glm::normalize(turn_by(mean, h) * body.delta_rotation);
        return;
    }
    // Steady changes act before and after the free turn by half: else what swings in a field would be damped.
    const Vec3d half_gain = 0.5 * Vec3d(body.spin_increment_radps);
    const FreeTurn start{Quatd(body.delta_rotation) * body.start_orientation,
                         Vec3d(body.spin_radps) - half_gain};
    const FreeTurn end = turned_freely(start, body.inertia_kgm2, static_cast<double>(h));
    body.delta_rotation = Quat(end.orientation * glm::conjugate(body.start_orientation));
    body.spin_radps = Vec3(end.spin_radps + half_gain);
}

/// Turning by more makes a body's moments along the world's axes, and the masses of its contacts, others, rad: of slender bodies earlier,
/// as their moments differ more.
Real most_turn_rad(const SolverBody& body) {
    constexpr Real kMost_rad = 0.05_r;
    if (body.isotropic_inertia) return kMost_rad;
    const Vec3d& moments = body.inertia_kgm2;
    const double least = std::min({moments.x, moments.y, moments.z});
    const double most = std::max({moments.x, moments.y, moments.z});
    return kMost_rad * static_cast<Real>(std::sqrt(least / most));
}

void note_turn(SolverBody& body, Real h) {
    body.turned.is_far = false;
    body.turned.total_rad += glm::length(body.spin_radps) * h;
    if (!body.movable()) return;
    if (body.turned.total_rad < kLeastTurn_rad) return;
    // Joints keep theirs up to date.
    if (!body.isotropic_inertia && !body.jointed) renew_inertia(body);
    if (body.turned.total_rad - body.turned.weighed_rad < most_turn_rad(body)) return;
    body.turned.is_far = true;
    body.turned.weighed_rad = body.turned.total_rad;
}

/// Forces that act all through the sub-step move a body by half of what their speed would: flight
/// is exact, sliding and rolling are second order.
void move_bodies(const ContactSet& contacts, bool gyroscopic_torque, Real h) {
    const TraceSpan span("move bodies");
    const Real half = h / 2;
    contacts.each_body([=](SolverBody& body) {
        body.delta_position_m += body.velocity_mps * h - body.velocity_increment_mps * half;
        turn_body(body, gyroscopic_torque, h);
        note_turn(body, h);
    });
}

/// Where a jointed body touches something, those of elastic joints lose spin as these say.
void slow_pressed(std::span<SolverBody> bodies,
                  std::span<const SolverJoint> joints,
                  const ContactSet& contacts,
                  Real h) {
    const auto decays = [](const SolverJoint& joint) { return joint.pressed_decay_per_s > 0; };
    const auto is_jointed = [&](const ContactConstraint& of) {
        return bodies[of.a].jointed || bodies[of.b].jointed;
    };
    if (std::ranges::none_of(joints, decays) ||
        std::ranges::none_of(contacts.constraints, is_jointed))
        return;
    for (const SolverJoint& joint : joints) {
        if (!decays(joint)) continue;
        Real& factor = bodies[joint.a].angular_damping_factor;
        factor = std::min(factor, portable_exp(-joint.pressed_decay_per_s * h));
    }
}

}  // namespace

void IslandLoop::clear() {
    bodies.assign(1, SolverBody{});
    contacts.constraints.clear();
    contacts.belts.clear();
    touching_m.clear();
    joints.clear();
    held.clear();
    fields.begin_island({});
}

LoopReport IslandLoop::run(const LoopSettings& settings) {
    settings_ = settings;
    report_ = {};
    const double h = settings.step_s / settings.substeps;
    h_ = static_cast<Real>(h);
    const Real bounce_mps = 2 * settings.gravity_mps2 * h_ + kSlowestBounce_mps;
    const Real spring_s = settings.spring_s > 0 ? static_cast<Real>(settings.spring_s) : h_;
    const bool few = joints.empty() && bodies.size() <= kFewBodies;
    const Real restless = few ? kRestlessOfFew : kRestless;
    for (const SolverJoint& joint : joints) {
        for (const std::uint32_t end : {joint.a, joint.b})
            bodies[end].jointed = bodies[end].movable();
    }
    slow_pressed(bodies, joints, contacts, h_);
    contacts.begin_step(bodies,
                        {.h = h_,
                         .spring_s = spring_s,
                         .push_mps = settings.push_mps,
                         .bounce_mps = bounce_mps,
                         .restless_mps = bounce_mps * restless,
                         .restless_jointed_mps = bounce_mps * kRestlessOfJointed,
                         .team = settings.team});
    if (!joints.empty()) joint_system_.start(bodies, joints, h, settings.joint_method);
    const bool stiff_springs = !joints.empty() && joint_system_.has_stiff_springs();
    impacts_.begin_step(contacts,
                        bodies,
                        {.threshold_mps = bounce_mps,
                         .may_shift = !stiff_springs,
                         .joints = joints.empty() ? nullptr : &joint_system_});
    for (SolverBody& body : bodies) body.start_speed_mps = glm::length(body.velocity_mps);
    guard_.begin(
        bodies, contacts.constraints, joints, joints.empty() ? 0 : joint_system_.most_speed(), h_);
    for (int i = 0; i < settings.substeps; ++i) substep(i);
    for (SolverBody& body : bodies)
        report_.clamped_bodies += clamp_depenetration_velocity(body, settings.push_mps) ? 1U : 0U;
    report_.braked_J = guard_.end(bodies, joints, fields.work(), settings.step_s);
    if (!joints.empty()) {
        joint_system_.finish();
        report_.max_joint_error_m = joint_system_.work().max_error_m;
        report_.row_solves += joint_system_.work().row_solves;
        report_.unresolved_joints = joint_system_.work().unresolved > 1;
    }
    report_.row_solves += contacts.row_solves() + report_.impacts;
    return report_;
}

LoopReport IslandLoop::run_impacts(const LoopSettings& settings, Real rest_s) {
    settings_ = settings;
    report_ = {};
    h_ = static_cast<Real>(settings.step_s);
    const Real bounce_mps = 2 * settings.gravity_mps2 * rest_s + kSlowestBounce_mps;
    contacts.begin_step(
        bodies, {.h = h_, .spring_s = h_, .push_mps = settings.push_mps, .bounce_mps = bounce_mps});
    impacts_.begin_step(contacts,
                        bodies,
                        {.threshold_mps = bounce_mps,
                         .may_shift = false,
                         .inelastic_too = true,
                         .touching_m = touching_m});
    for (SolverBody& body : bodies) body.start_speed_mps = glm::length(body.velocity_mps);
    guard_.begin(bodies, contacts.constraints, joints, 0, h_);
    report_.impacts = impacts_.run();
    report_.braked_J = guard_.end(bodies, joints, {}, 0);
    report_.row_solves = contacts.row_solves() + report_.impacts;
    return report_;
}

void IslandLoop::substep(int number) {
    if (impacts_.needed()) {
        const auto impacts = impacts_.run();
        report_.impacts += impacts;
        if (impacts > 0 && !joints.empty()) joint_system_.end_impacts();
    }
    const auto h = static_cast<double>(h_);
    apply_steady_forces(bodies, contacts, fields, {settings_.start_s + (number + 0.5) * h, h}, h_);
    if (!joints.empty()) joint_system_.push_springs(h / 2);
    solve_velocities();
    if (!joints.empty()) joint_system_.begin_motion(!contacts.constraints.empty());
    move_bodies(contacts, settings_.gyroscopic_torque, h_);
    if (!fields.empty()) fields.count(bodies);
    hold_along_axes(held, bodies);
    if (!joints.empty()) {
        joint_system_.correct_positions();
        joint_system_.push_springs(h / 2);
        joint_system_.refresh();
    }
    relax();
    contacts.end_substep();
}

void IslandLoop::solve_velocities() {
    const TraceSpan span("sweeps with bias");
    if (contacts.constraints.empty() && !joint_system_.solves_before_motion()) return;
    const bool both = !joints.empty() && !contacts.constraints.empty();
    // Contacts see what joints press on them from the first sweep on, as they see their own impulses of before.
    if (both) joint_system_.solve_velocities();
    bool is_restless = true;
    for (int i = 0; i < settings_.iterations || (is_restless && i < kMostSweeps); ++i) {
        is_restless =
            contacts.sweep_with_bias(i < settings_.iterations ? Sweep::All : Sweep::Restless);
        if (!joints.empty()) joint_system_.solve_velocities();
        hold_along_axes(held, bodies);
    }
}

void IslandLoop::relax() {
    const TraceSpan span("relax");
    // What the motion took to stay on the joints is no speed that contacts must stop.
    if (!joints.empty() && !contacts.constraints.empty()) joint_system_.solve_velocities();
    bool is_restless = true;
    for (int i = 0; i < settings_.iterations || (is_restless && i < kMostSweeps); ++i) {
        is_restless = contacts.relax(i < settings_.iterations ? Sweep::All : Sweep::Restless);
        if (!joints.empty()) joint_system_.solve_velocities();
        hold_along_axes(held, bodies);
    }
}

}  // namespace plumbline::physics
