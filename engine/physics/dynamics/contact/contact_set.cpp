#include "engine/physics/dynamics/contact/contact_set.h"

#include "engine/physics/dynamics/contact/point_impulses.h"
#include "engine/physics/dynamics/substep_choice.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

constexpr Real kContactDamping = 10;  ///< ratio: far above 1, penetration in never swings back
/// Of normals and friction, where what sticks changed by much ...
constexpr int kFrictionRounds = 12;
constexpr Real kOneSpot = 1e-4_r;  ///< nearer centres, as a share of the radii, have no direction
constexpr Real kDepenetratedShare = 0.05_r;  ///< of the fastest push: more is deep penetration
constexpr Real kOut_m = 1e-5_r;              ///< what bounced and will be no deeper is out
constexpr Real kMuch = 0.005_r;              ///< ... as a share of its limit

/// R(q)^T v - v without the cancellation of the two terms.
inline Vec3 turned_back_change(const Quat& q, const Vec3& v) {
    const Vec3 axis{-q.x, -q.y, -q.z};
    const Vec3 t = Real{2} * glm::cross(axis, v);
    return q.w * t + glm::cross(axis, t);
}

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
    Lanes speeds;
    for (std::size_t i = 0; i < kLanes; ++i) speeds[i] = along + of_a[i] - of_b[i];
    return speeds;
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

/// What nothing moves is not pushed out, and hands no speed limit on from one body to another.
void mark_depenetrated(SolverBody& a, SolverBody& b) {
    for (SolverBody* body : {&a, &b}) {
        if (body->movable()) body->depenetrated = true;
    }
}

}  // namespace

void ContactSet::begin_step(std::span<SolverBody> bodies, Real h, Real push_mps, Real bounce_mps) {
    bodies_ = bodies;
    h_ = h;
    push_mps_ = push_mps;
    bounce_mps_ = bounce_mps;
    row_solves = 0;
    const Real stiff_hz = kContactFrequency / h;
    between_movable_ = softness_of(stiff_hz, kContactDamping, h);
    against_immovable_ = softness_of(2 * stiff_hz, kContactDamping / 2, h);

    for (ContactConstraint& constraint : constraints) {
        const SolverBody& a = bodies[constraint.a];
        const SolverBody& b = bodies[constraint.b];
        prepare(
            constraint, a, b, a.movable() && b.movable() ? between_movable_ : against_immovable_);
    }
    order_.clear();
    for (std::uint32_t i = 0; i < constraints.size(); ++i) {
        if (!constraints[i].against_immovable) order_.push_back(i);
    }
    for (std::uint32_t i = 0; i < constraints.size(); ++i) {
        if (constraints[i].against_immovable) order_.push_back(i);
    }
}

void ContactSet::warm_start() {
    for (const std::uint32_t index : order_) {
        const ContactConstraint& constraint = constraints[index];
        SolverBody& a = bodies_[constraint.a];
        SolverBody& b = bodies_[constraint.b];
        const Vec3 friction = constraint.tangent[0] * constraint.tangent_Ns[0] +
                              constraint.tangent[1] * constraint.tangent_Ns[1];
        const Vec3 impulse = constraint.normal * sum_of(constraint.normal_Ns) + friction;
        const Vec3 turning = constraint.normal * constraint.twist_Nms + constraint.rolling_Nms;
        const Vec3 torque_a = weighted_sum(constraint.angular_a, constraint.normal_Ns) +
                              glm::cross(constraint.center_a, friction) + turning;
        const Vec3 torque_b = weighted_sum(constraint.angular_b, constraint.normal_Ns) +
                              glm::cross(constraint.center_b, friction) + turning;
        a.velocity_increment_mps += impulse * a.inverse_mass;
        a.spin_increment_radps += a.inverse_inertia * torque_a;
        b.velocity_increment_mps -= impulse * b.inverse_mass;
        b.spin_increment_radps -= b.inverse_inertia * torque_b;
    }
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
    constraint.normal = distance > reach_m * kOneSpot
                            ? apart / distance
                            : direction_of(constraint.a * 7919U + constraint.b);
    constraint.separation_m[0] = distance - reach_m;
    constraint.center_a = offset_a - constraint.normal * constraint.radius_a;
    constraint.center_b = offset_b + constraint.normal * constraint.radius_b;
    set_lane(constraint.angular_a, 0, glm::cross(constraint.center_a, constraint.normal));
    set_lane(constraint.angular_b, 0, glm::cross(constraint.center_b, constraint.normal));
    const Vec3 along = constraint.tangent[0] -
                       constraint.normal * glm::dot(constraint.normal, constraint.tangent[0]);
    constraint.tangent[0] = normalize_or(along, constraint.tangent[1]);
    constraint.tangent[1] = glm::cross(constraint.normal, constraint.tangent[0]);
}

void ContactSet::update_separations(ContactConstraint& constraint) const {
    if (constraint.spheres()) return update_sphere_separations(constraint);
    const SolverBody& a = bodies_[constraint.a];
    const SolverBody& b = bodies_[constraint.b];
    const Vec3 moved = a.delta_position_m - b.delta_position_m;
    const Real along = glm::dot(constraint.normal, moved);
    const Lanes of_a =
        dot_lanes(turned_back_change(a.delta_rotation, constraint.normal), constraint.offset_a);
    const Lanes of_b =
        dot_lanes(turned_back_change(b.delta_rotation, constraint.normal), constraint.offset_b);
    for (std::size_t i = 0; i < kLanes; ++i)
        constraint.separation_m[i] = constraint.start_separation_m[i] + along + of_a[i] - of_b[i];
    if (!constraint.rounded()) return;
    // The sphere moved over the other side: what touches it there is where the sphere is now.
    const Vec3 shift = constraint.shift_of(moved);
    for (int i = 0; i < constraint.count; ++i) {
        if (constraint.radius_a > 0) {
            set_lane(constraint.angular_b,
                     i,
                     glm::cross(constraint.arm_b(i) + shift, constraint.normal));
        } else {
            set_lane(constraint.angular_a,
                     i,
                     glm::cross(constraint.arm_a(i) - shift, constraint.normal));
        }
    }
}

void ContactSet::solve_with_bias(ContactConstraint& constraint) {
    SolverBody& a = bodies_[constraint.a];
    SolverBody& b = bodies_[constraint.b];
    const Softness& soft = constraint.against_immovable ? against_immovable_ : between_movable_;
    update_separations(constraint);
    Lanes wanted = opening_speeds(constraint, a, b);
    Lanes compliance{};
    bool all_penetrate = true;
    const Real pull_m =
        glm::dot(a.velocity_increment_mps - b.velocity_increment_mps, constraint.normal) * (h_ / 2);
    for (std::size_t i = 0; i < kLanes; ++i) {
        const bool penetrates = constraint.separation_m[i] <= 0;
        all_penetrate = all_penetrate && (penetrates || static_cast<int>(i) >= constraint.count);
        // What bounced is on its way out already, at the speed it should have.
        if (penetrates && constraint.restitution > 0 && wanted[i] > bounce_mps_) continue;
        if (constraint.bounced && constraint.separation_m[i] + wanted[i] * h_ - pull_m > -kOut_m)
            continue;
        const Real bias = soft.bias_per_s * constraint.separation_m[i];
        wanted[i] += penetrates ? std::max(bias, -push_mps_) : constraint.separation_m[i] / h_;
        if (penetrates && bias < -kDepenetratedShare * push_mps_) mark_depenetrated(a, b);
        compliance[i] = penetrates ? constraint.compliance[i] : Real{0};
    }
    if (stays_separated(constraint, wanted)) return;
    Lanes next;
    bool solved = false;
    if (all_penetrate) {
        Lanes error;
        for (std::size_t i = 0; i < kLanes; ++i)
            error[i] = static_cast<int>(i) < constraint.count
                           ? wanted[i] + compliance[i] * constraint.normal_Ns[i]
                           : Real{0};
        next = direct(constraint.normal_Ns, constraint.soft_mass, error);
        solved = all_press(next, constraint.count);
    }
    if (!solved) next = projected(constraint, wanted, compliance);
    const NormalChange change = apply_normal(constraint, a, b, next);
    if (change.gained_Ns > 0) {
        hold_against(a, constraint.normal, change.gained_Ns * a.inverse_mass);
        hold_against(b, -constraint.normal, change.gained_Ns * b.inverse_mass);
    } else {
        take_back(a, change.velocity_a, change.spin_a);
        take_back(b, change.velocity_b, change.spin_b);
    }
}

void ContactSet::relax(ContactConstraint& constraint) {
    update_separations(constraint);
    // Friction turns a body about its centre, which loads other points than before: where it did
    // so, both are solved again.
    for (int round = 0; round < kFrictionRounds; ++round) {
        if (!relax_normal(constraint)) return;
        bool changed = constraint.friction > 0 && solve_friction(constraint);
        if (constraint.rolling_m > 0 || constraint.spinning_m > 0)
            changed |= resist_rolling(constraint);
        if (!changed) return;
    }
}

/// Normal impulses without bias. False: the bodies are apart and nothing holds them any more.
bool ContactSet::relax_normal(ContactConstraint& constraint) {
    SolverBody& a = bodies_[constraint.a];
    SolverBody& b = bodies_[constraint.b];
    Lanes wanted = opening_speeds(constraint, a, b);
    bool all_penetrate = true;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const bool used = static_cast<int>(i) < constraint.count;
        if (constraint.separation_m[i] <= 0) continue;
        all_penetrate = all_penetrate && !used;
        // A point that does not touch yet is left to the next sub-step, which looks ahead itself: to
        // do it here as well would eat the speed of what is to bounce, and would let a body be
        // pushed by a kinematic body that comes to a stop at it.
        const bool touches = constraint.normal_Ns[i] > 0;
        wanted[i] = touches ? wanted[i] + constraint.separation_m[i] / h_ : kNoPoint_m;
    }
    if (stays_separated(constraint, wanted) && !constraint.holds_friction()) return false;
    Lanes next;
    bool solved = false;
    if (all_penetrate) {
        for (std::size_t i = static_cast<std::size_t>(constraint.count); i < kLanes; ++i)
            wanted[i] = 0;
        next = direct(constraint.normal_Ns, constraint.rigid_mass, wanted);
        solved = all_press(next, constraint.count);
    }
    if (!solved) next = projected(constraint, wanted, Lanes{});
    apply_normal(constraint, a, b, next);
    row_solves += static_cast<std::uint64_t>(constraint.count);
    return true;
}

/// Coulomb friction of the whole constraint: a force at the centre of the load and a twist about it, as
/// much as stops the slip, within the ellipsoid that approximates their common limit (Goyal, Ruina
/// and Papadopoulos, Planar sliding with dry friction, 1991). Returns whether what
/// sticks changed by much.
bool ContactSet::solve_friction(ContactConstraint& constraint) {
    SolverBody& a = bodies_[constraint.a];
    SolverBody& b = bodies_[constraint.b];
    Vec3 center_a = constraint.center_a;
    Vec3 center_b = constraint.center_b;
    if (constraint.carried) {
        // The place goes round with what carries it.
        const Vec3 shift = b.delta_rotation * constraint.center_b - constraint.center_b;
        center_a += shift + b.delta_position_m - a.delta_position_m;
        center_b += shift;
    }
    if (constraint.spheres()) {
        // update_sphere_separations() left them where they are
    } else if (constraint.radius_a > 0) {
        center_b += constraint.shift_of(a.delta_position_m - b.delta_position_m);
    } else if (constraint.radius_b > 0) {
        center_a += constraint.shift_of(b.delta_position_m - a.delta_position_m);
    }
    const Vec3 slip = a.velocity_at(center_a) - b.velocity_at(center_b);
    Real next[2];
    for (int t = 0; t < 2; ++t)
        next[t] = constraint.tangent_Ns[t] -
                  constraint.tangent_mass[t] * glm::dot(slip, constraint.tangent[t]);
    const Real limit = constraint.friction * sum_of(constraint.normal_Ns);
    const Real twist_limit = limit * constraint.twist_arm_m;
    Real twist = 0;
    if (twist_limit > 0) {
        const Real spin = glm::dot(a.spin_radps - b.spin_radps, constraint.normal);
        twist = constraint.twist_Nms - constraint.twist_mass * spin;
    }
    const Real twist_share = twist_limit > 0 ? twist / twist_limit : Real{0};
    const Real squared = next[0] * next[0] + next[1] * next[1];
    const Real used = squared + twist_share * twist_share * limit * limit;
    const bool slides = used > limit * limit;
    if (slides) {
        const Real kept = limit / std::sqrt(used);
        next[0] *= kept;
        next[1] *= kept;
        twist *= kept;
    }
    const Vec3 force = constraint.tangent[0] * (next[0] - constraint.tangent_Ns[0]) +
                       constraint.tangent[1] * (next[1] - constraint.tangent_Ns[1]);
    const Vec3 turning = constraint.normal * (twist - constraint.twist_Nms);
    const bool changed = !slides && glm::dot(force, force) > kMuch * kMuch * limit * limit;
    constraint.tangent_Ns[0] = next[0];
    constraint.tangent_Ns[1] = next[1];
    constraint.twist_Nms = twist;
    const Vec3 change_a = force * a.inverse_mass;
    const Vec3 change_b = force * b.inverse_mass;
    a.velocity_mps += change_a;
    b.velocity_mps -= change_b;
    // Friction that is new in this sub-step acted in all of it: its half of the way.
    a.delta_position_m += change_a * (h_ / 2);
    b.delta_position_m -= change_b * (h_ / 2);
    a.spin_radps += a.inverse_inertia * (glm::cross(center_a, force) + turning);
    b.spin_radps -= b.inverse_inertia * (glm::cross(center_b, force) + turning);
    row_solves += 3;
    return changed;
}

/// Resistance to rolling and to spinning: torques of at most a length times the load. Returns
/// whether what holds changed by much.
bool ContactSet::resist_rolling(ContactConstraint& constraint) {
    SolverBody& a = bodies_[constraint.a];
    SolverBody& b = bodies_[constraint.b];
    const Vec3 relative = a.spin_radps - b.spin_radps;
    const Real load = sum_of(constraint.normal_Ns);
    const auto bounded = [&](const Vec3& spin, const Vec3& held, Real limit) {
        const Real speed = glm::length(spin);
        Vec3 wanted = held;
        if (speed > 0) {
            const Real inverse = inverse_moment_along(a, b, spin / speed);
            if (inverse > 0) wanted -= spin / inverse;
        }
        const Real length = glm::length(wanted);
        return length > limit ? wanted * (limit / length) : wanted;
    };
    const Vec3 held_spin = constraint.normal * glm::dot(constraint.rolling_Nms, constraint.normal);
    const Vec3 spin = constraint.normal * glm::dot(relative, constraint.normal);
    const Vec3 next =
        bounded(spin, held_spin, constraint.spinning_m * load) +
        bounded(relative - spin, constraint.rolling_Nms - held_spin, constraint.rolling_m * load);
    const Vec3 change = next - constraint.rolling_Nms;
    constraint.rolling_Nms = next;
    a.spin_radps += a.inverse_inertia * change;
    b.spin_radps -= b.inverse_inertia * change;
    row_solves += 3;
    const Real limit = std::max(constraint.rolling_m, constraint.spinning_m) * load;
    const bool holds = glm::dot(next, next) < limit * limit * (1 - kMuch);
    return holds && glm::dot(change, change) > kMuch * kMuch * limit * limit;
}

void ContactSet::solve_with_bias() {
    for (const std::uint32_t index : order_) {
        solve_with_bias(constraints[index]);
        row_solves += static_cast<std::uint64_t>(constraints[index].count);
    }
}

void ContactSet::relax() {
    for (const std::uint32_t index : order_) {
        relax(constraints[index]);
    }
}

void ContactSet::end_substep() {
    for (ContactConstraint& constraint : constraints) {
        for (std::size_t i = 0; i < kLanes; ++i) constraint.total_Ns[i] += constraint.normal_Ns[i];
        constraint.bounced = false;
        // Who is pressed by what was pushed out moves as fast.
        SolverBody& a = bodies_[constraint.a];
        SolverBody& b = bodies_[constraint.b];
        if ((a.depenetrated || b.depenetrated) && sum_of(constraint.normal_Ns) > 0)
            mark_depenetrated(a, b);
    }
}

}  // namespace plumbline::physics
