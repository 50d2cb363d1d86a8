#include "engine/physics/dynamics/contact/contact_set.h"

#include "engine/physics/dynamics/contact/point_impulses.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

namespace plumbline::physics {
namespace {

/// Of normals and friction, where what sticks changed by much.
constexpr int kFrictionRounds = 12;
constexpr Real kOneSpot = 1e-4_r;  ///< nearer centres, as a share of the radii, have no direction
constexpr Real kDepenetratedShare = 0.05_r;  ///< of the fastest push: more is deep penetration
/// What a sweep changes a speed by is much beyond this share of the bodies' own speed.
constexpr Real kRestlessOfSpeed = 0.1_r;
constexpr Real kLasts = 2;       ///< times the load before: more is an impact
constexpr Real kOut_m = 1e-5_r;  ///< what bounced and will be no deeper is out

/// The n-th of directions that are spread evenly over the sphere (Fibonacci's).
Vec3 direction_of(std::uint32_t n) {
    constexpr std::uint32_t kDirections = 1021;
    const Real height = 1 - (2 * static_cast<Real>(n % kDirections) + 1) / kDirections;
    const Real around = std::sqrt(1 - height * height);
    const Real angle = static_cast<Real>(n % kDirections) * 2.39996323_r;  // golden angle
    return {around * portable_cos(angle), height, around * portable_sin(angle)};
}

inline Lanes opening_speeds(const ContactConstraint& constraint,
                            const SolverBody& a,
                            const SolverBody& b) {
    const Real along = glm::dot(constraint.normal, a.velocity_mps - b.velocity_mps);
    const Lanes of_a = dot_lanes(a.spin_radps, constraint.angular_a);
    const Lanes of_b = dot_lanes(b.spin_radps, constraint.angular_b);
    return splat(along) + of_a - of_b;
}

/// A new push of `gained_mps` along `normal` holds against what would have moved the body into the
/// contact all through the sub-step: nothing is left of that to take half of the way for.
inline void hold_against(SolverBody& body, const Vec3& normal, Real gained_mps) {
    const Real pressing_mps = -glm::dot(body.velocity_increment_mps, normal);
    body.velocity_increment_mps += normal * std::max(std::min(gained_mps, pressing_mps), Real{0});
}

/// What is taken back of the impulse before, of an impact that is over, did not act all through the sub-step either. A
/// body that has no such share, as joints solved by iteration leave it, gets none.
inline void take_back(SolverBody& body, const Vec3& velocity_mps, const Vec3& spin_radps) {
    if (body.velocity_increment_mps != Vec3{0, 0, 0}) body.velocity_increment_mps += velocity_mps;
    if (body.spin_increment_radps != Vec3{0, 0, 0}) body.spin_increment_radps += spin_radps;
}

/// What pressed two bodies much more than in the sub-step before that was an impact, which does not go on. `light_Ns`: what rests presses
/// as hard when it lands from a sub-step's fall.
void ease_impact(std::span<ContactConstraint> pair, Real light_Ns) {
    Real load_Ns = 0;
    Real before_Ns = 0;
    for (ContactConstraint& constraint : pair) {
        load_Ns += sum_of(constraint.normal_Ns);
        before_Ns += std::exchange(constraint.load_before_Ns, Real{0});
    }
    pair.front().load_before_Ns = load_Ns;
    const Real eased_Ns = std::min(load_Ns, std::max(kLasts * before_Ns, light_Ns));
    if (eased_Ns == load_Ns) return;
    const Real share = eased_Ns / load_Ns;
    for (ContactConstraint& constraint : pair) {
        constraint.normal_Ns *= splat(share);
        for (Real& tangent_Ns : constraint.tangent_Ns) tangent_Ns *= share;
        constraint.twist_Nms *= share;
        constraint.rolling_Nms *= share;
    }
}

/// What nothing moves is not pushed out, and hands no speed limit on from one body to another.
void mark_depenetrated(SolverBody& a, SolverBody& b) {
    for (SolverBody* body : {&a, &b}) {
        if (body->movable()) body->depenetrated = true;
    }
}

/// Of both sub-steps as much as neither changed much of: the rest is an impact.
Lanes steady_part(Lanes before, Lanes now) {
    const Lanes least = before < now ? before : now;
    const Lanes unchanged = least + least - (before < now ? now : before);
    return unchanged > splat(0) ? unchanged : splat(0);
}

/// What a contact does to its bodies' velocities by its arms.
struct Wrench {
    Vec3 force_Ns;
    Vec3 torque_a_Nms;
    Vec3 torque_b_Nms;

    Wrench(const ContactConstraint& constraint, Lanes normal_Ns, Real friction_share) {
        const Vec3 friction = (constraint.tangent[0] * constraint.tangent_Ns[0] +
                               constraint.tangent[1] * constraint.tangent_Ns[1]) *
                              friction_share;
        force_Ns = constraint.normal * sum_of(normal_Ns) + friction;
        torque_a_Nms = weighted_sum(constraint.angular_a, normal_Ns) +
                       glm::cross(constraint.center_a, friction);
        torque_b_Nms = weighted_sum(constraint.angular_b, normal_Ns) +
                       glm::cross(constraint.center_b, friction);
    }
};

}  // namespace

std::uint64_t ContactSet::row_solves() const {
    std::uint64_t sum = 0;
    for (const ContactConstraint& constraint : constraints) sum += constraint.row_solves;
    return sum;
}

void ContactSet::warm_start() {
    each_part_in_order([this](std::span<const SweepPlace> part) {
        for_each_pair(part, [this](std::span<ContactConstraint> pair) {
            const Real linear =
                bodies_[pair.front().a].inverse_mass + bodies_[pair.front().b].inverse_mass;
            ease_impact(pair, bounce_mps_ / linear);
            for (ContactConstraint& constraint : pair) {
                constraint.before_Ns = constraint.normal_Ns;
                warm_start(constraint);
            }
        });
    });
}

void ContactSet::warm_start(const ContactConstraint& constraint) {
    SolverBody& a = bodies_[constraint.a];
    SolverBody& b = bodies_[constraint.b];
    const Wrench impulse(constraint, constraint.normal_Ns, 1);
    const Vec3 turning = constraint.normal * constraint.twist_Nms + constraint.rolling_Nms;
    a.velocity_increment_mps += impulse.force_Ns * a.inverse_mass;
    a.spin_increment_radps += a.inverse_inertia * (impulse.torque_a_Nms + turning);
    if (!b.movable()) return;
    b.velocity_increment_mps -= impulse.force_Ns * b.inverse_mass;
    b.spin_increment_radps -= b.inverse_inertia * (impulse.torque_b_Nms + turning);
}

/// Two spheres: the normal turns with the line between their centres.
void ContactSet::update_sphere_separations(ContactConstraint& constraint) const {
    const SolverBody& a = bodies_[constraint.a];
    const SolverBody& b = bodies_[constraint.b];
    const Vec3 offset_a = a.delta_rotation * lane(constraint.offset_a, 0);
    const Vec3 offset_b = b.delta_rotation * lane(constraint.offset_b, 0);
    const Real reach_m = constraint.radius_a + constraint.radius_b;
    const Vec3 apart = constraint.start_normal * (reach_m + constraint.start_separation_m[0]) +
                       a.delta_position_m - b.delta_position_m +
                       (offset_a - lane(constraint.offset_a, 0)) -
                       (offset_b - lane(constraint.offset_b, 0));
    const Real distance = glm::length(apart);
    // Spheres on one spot part in directions that differ from pair to pair.
    turn_normal(constraint,
                distance > reach_m * kOneSpot ? apart / distance
                                              : direction_of(constraint.a * 7919U + constraint.b));
    constraint.separation_m[0] = distance - reach_m;
    constraint.center_a = offset_a - constraint.normal * constraint.radius_a;
    constraint.center_b = offset_b + constraint.normal * constraint.radius_b;
    set_lane(constraint.angular_a, 0, glm::cross(constraint.center_a, constraint.normal));
    set_lane(constraint.angular_b, 0, glm::cross(constraint.center_b, constraint.normal));
}

void ContactSet::update_separations(ContactConstraint& constraint) const {
    if (constraint.spheres()) return update_sphere_separations(constraint);
    follow(constraint, bodies_[constraint.a], bodies_[constraint.b]);
}

/// Follows the bodies' motion of the sub-step. What presses steadily acts half before it and half after, where the arms are others then
/// (as RATTLE has it, Andersen 1983): else what rocks and rolls would gain energy.
void ContactSet::follow_motion(ContactConstraint& constraint) {
    SolverBody& a = bodies_[constraint.a];
    SolverBody& b = bodies_[constraint.b];
    const Real load_Ns = sum_of(constraint.normal_Ns);
    if (!arms_turn(constraint, a, b) || !(load_Ns > 0)) return update_separations(constraint);
    const Lanes half = steady_part(constraint.before_Ns, constraint.normal_Ns) * splat(Real{0.5});
    const Real friction_share = sum_of(half) / load_Ns;
    const Wrench before(constraint, half, friction_share);
    update_separations(constraint);
    const Wrench after(constraint, half, friction_share);
    const Vec3 more = after.force_Ns - before.force_Ns;
    a.velocity_mps += more * a.inverse_mass;
    a.spin_radps += a.inverse_inertia * (after.torque_a_Nms - before.torque_a_Nms);
    if (!b.movable()) return;
    b.velocity_mps -= more * b.inverse_mass;
    b.spin_radps -= b.inverse_inertia * (after.torque_b_Nms - before.torque_b_Nms);
}

/// Returns by how much it changed the speed at the contact, m/s.
Real ContactSet::solve_with_bias(ContactConstraint& constraint, Sweep which) {
    SolverBody& a = bodies_[constraint.a];
    SolverBody& b = bodies_[constraint.b];
    const Softness& soft = constraint.against_immovable ? against_immovable_ : between_movable_;
    // Until bodies move, separations stay; friction moves jointed ones.
    if (which == Sweep::All || constraint.jointed) update_separations(constraint);
    Lanes wanted = opening_speeds(constraint, a, b);
    const LaneMask used = first_lanes(constraint.count);
    const LaneMask penetrates = constraint.separation_m <= splat(0);
    const bool all_penetrate = !any(used & ~penetrates);
    const Lanes bias = constraint.separation_m * splat(soft.bias_per_s);
    const Lanes push = bias < splat(-push_mps_) ? splat(-push_mps_) : bias;
    // What bounced is on its way out already, at the speed it should have.
    LaneMask on_its_way = LaneMask{};
    if (constraint.restitution > 0) on_its_way = penetrates & (wanted > splat(bounce_mps_));
    if (constraint.bounced) {
        const Real pull_m =
            glm::dot(a.velocity_increment_mps - b.velocity_increment_mps, constraint.normal) *
            (h_ / 2);
        on_its_way |= constraint.separation_m + wanted * splat(h_) - splat(pull_m) > splat(-kOut_m);
    }
    const LaneMask deep =
        penetrates & ~on_its_way & (bias < splat(-kDepenetratedShare * push_mps_));
    if (any(deep)) mark_depenetrated(a, b);
    wanted += on_its_way ? splat(0) : (penetrates ? push : constraint.separation_m / splat(h_));
    const Lanes compliance = (penetrates & ~on_its_way) ? constraint.compliance : splat(0);
    if (stays_separated(constraint, wanted)) return 0;
    Lanes next;
    bool solved = false;
    if (all_penetrate) {
        const Lanes error = used ? wanted + compliance * constraint.normal_Ns : splat(0);
        next = direct(constraint.normal_Ns, constraint.soft_mass, error);
        solved = all_press(next, constraint.count);
    }
    if (!solved) next = projected(constraint, wanted, compliance);
    const NormalChange change = apply_normal(constraint, a, b, next);
    const Real changed_mps = change.changed_Ns * constraint.response[0][0];
    if (change.gained_Ns > 0) {
        hold_against(a, constraint.normal, change.gained_Ns * a.inverse_mass);
        if (b.movable()) hold_against(b, -constraint.normal, change.gained_Ns * b.inverse_mass);
    } else {
        take_back(a, change.velocity_a, change.spin_a);
        if (b.movable()) take_back(b, change.velocity_b, change.spin_b);
    }
    // Bodies that slid on what they stand on while they are pushed out of it would stay where they slid to.
    if (constraint.jointed && constraint.friction > 0)
        return changed_mps + solve_friction(constraint).changed_mps;
    return changed_mps;
}

/// Returns by how much it changed speeds at the contact, m/s.
Real ContactSet::relax(ContactConstraint& constraint) {
    follow_motion(constraint);
    const SolverBody& a = bodies_[constraint.a];
    const SolverBody& b = bodies_[constraint.b];
    if (a.turned.is_far || b.turned.is_far) weigh_anew(constraint, a, b);
    // Friction turns a body about its centre, which loads other points than before: where it did
    // so, both are solved again.
    Real changed_mps = 0;
    for (int round = 0; round < kFrictionRounds; ++round) {
        if (!relax_normal(constraint, changed_mps)) break;
        FrictionChange change;
        if (constraint.friction > 0) change = solve_friction(constraint);
        changed_mps += change.changed_mps;
        if (constraint.rolling_m > 0 || constraint.spinning_m > 0)
            change.is_much |= resist_rolling(constraint);
        if (!change.is_much) break;
    }
    return changed_mps;
}

/// Normal impulses without bias. False: the bodies are apart and nothing holds them any more.
bool ContactSet::relax_normal(ContactConstraint& constraint, Real& changed_mps) {
    SolverBody& a = bodies_[constraint.a];
    SolverBody& b = bodies_[constraint.b];
    Lanes wanted = opening_speeds(constraint, a, b);
    const LaneMask used = first_lanes(constraint.count);
    const LaneMask penetrates = constraint.separation_m <= splat(0);
    const bool all_penetrate = !any(used & ~penetrates);
    // A point that does not touch yet is left to the next sub-step, which looks ahead itself: to
    // do it here as well would eat the speed of what is to bounce, and would let a body be
    // pushed by a kinematic body that comes to a stop at it.
    const LaneMask touches = constraint.normal_Ns > splat(0);
    wanted = penetrates
                 ? wanted
                 : (touches ? wanted + constraint.separation_m / splat(h_) : splat(kNoPoint_m));
    if (stays_separated(constraint, wanted) && !constraint.holds_friction()) return false;
    Lanes next;
    bool solved = false;
    if (all_penetrate) {
        wanted = used ? wanted : splat(0);
        next = direct(constraint.normal_Ns, constraint.rigid_mass, wanted);
        solved = all_press(next, constraint.count);
    }
    if (!solved) next = projected(constraint, wanted, Lanes{});
    changed_mps += apply_normal(constraint, a, b, next).changed_Ns * constraint.response[0][0];
    constraint.row_solves += static_cast<std::uint32_t>(constraint.count);
    return true;
}

/// Whether a sweep that changed the speed at the contact by so much left its bodies far from where they settle.
bool ContactSet::is_much(Real changed_mps, const ContactConstraint& constraint) const {
    const Real beyond_mps =
        changed_mps - (constraint.jointed ? restless_jointed_mps_ : restless_mps_);
    if (beyond_mps <= 0) return false;
    const Vec3& of_a = bodies_[constraint.a].velocity_mps;
    const Vec3& of_b = bodies_[constraint.b].velocity_mps;
    const Real speed2 = std::max(glm::dot(of_a, of_a), glm::dot(of_b, of_b));
    return beyond_mps * beyond_mps > kRestlessOfSpeed * kRestlessOfSpeed * speed2;
}

/// `solve` returns by how much it changed the speed at a constraint.
template <typename Solve>
bool ContactSet::sweep(Sweep which, Solve solve) {
    std::swap(was_restless_, is_restless_);
    is_restless_.assign(bodies_.size(), 0);
    std::atomic<bool> any{false};
    each_part_in_order([&](std::span<const SweepPlace> part) {
        if (sweep_part(part, which, solve)) any.store(true, std::memory_order_relaxed);
    });
    return any;
}

template <typename Solve>
bool ContactSet::sweep_part(std::span<const SweepPlace> part, Sweep which, Solve solve) {
    bool any = false;
    for (const SweepPlace& place : part) {
        if (which == Sweep::Restless && !place.jointed && was_restless_[place.a] == 0 &&
            was_restless_[place.b] == 0)
            continue;
        ContactConstraint& constraint = constraints[place.constraint];
        if (!is_much(solve(constraint), constraint)) continue;
        any = true;
        for (const std::uint32_t body : {place.a, place.b}) {
            if (bodies_[body].movable()) is_restless_[body] = 1;
        }
    }
    return any;
}

bool ContactSet::sweep_with_bias(Sweep which) {
    belt_ahead_s_ = h_ / 2;
    return sweep(which, [this, which](ContactConstraint& constraint) {
        constraint.row_solves += static_cast<std::uint32_t>(constraint.count);
        return solve_with_bias(constraint, which);
    });
}

bool ContactSet::relax(Sweep which) {
    belt_ahead_s_ = 0;
    return sweep(which, [this](ContactConstraint& constraint) {
        const Real changed_mps = relax(constraint);
        return constraint.jointed ? changed_mps : Real{0};
    });
}

void ContactSet::end_substep() {
    each_part([this](std::span<const SweepPlace> part) {
        for (const SweepPlace& place : part) {
            ContactConstraint& constraint = constraints[place.constraint];
            constraint.total_Ns += constraint.normal_Ns;
            constraint.bounced = false;
        }
    });
    // Who is pressed by what was pushed out moves as fast.
    const auto pushed = [](const SolverBody& body) { return body.depenetrated; };
    if (std::ranges::none_of(bodies_, pushed)) return;
    for (const ContactConstraint& constraint : constraints) {
        SolverBody& a = bodies_[constraint.a];
        SolverBody& b = bodies_[constraint.b];
        if ((a.depenetrated || b.depenetrated) && sum_of(constraint.normal_Ns) > 0)
            mark_depenetrated(a, b);
    }
}

}  // namespace plumbline::physics
