// Friction of contacts: sliding, twisting, rolling and spinning.
#include "engine/physics/dynamics/contact/contact_set.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

constexpr Real kMuch = 0.005_r;  ///< change of what sticks, as a share of its limit

/// What stops the slip, whose two directions turn the bodies differently: the full response's inverse.
Vec2 stopping_impulse(const ContactConstraint& constraint, const Vec2& slip) {
    const auto& [first, second] = constraint.slip_response;
    const Real coupling = constraint.slip_coupling;
    const Real determinant = first * second - coupling * coupling;
    if (!(determinant > 0)) return {0, 0};
    return Vec2{second * slip.x - coupling * slip.y, first * slip.y - coupling * slip.x} /
           determinant;
}

/// What acts straight against the slip and stops it along itself: Coulomb's direction of what slides.
Vec2 opposing_impulse(const ContactConstraint& constraint, const Vec2& slip) {
    const auto& [first, second] = constraint.slip_response;
    const Real along = first * slip.x * slip.x + second * slip.y * slip.y +
                       2 * constraint.slip_coupling * slip.x * slip.y;
    return along > 0 ? slip * (glm::dot(slip, slip) / along) : Vec2{0, 0};
}

/// What a stop would take, of a force or of a twist over its arm, and what each unit of it changes of the motion there.
struct Wanted {
    Real size;
    Real weight;
};
struct Kept {
    Real of_force;
    Real of_twist;
};

/// The nearest to what is wanted, measured by the motion it leaves, whose squares sum to the limit's: a wheel that turns as it rolls
/// gives up its twist, and not what holds it sideways.
Kept within_limit(Real limit, const Wanted& force, const Wanted& twist) {
    constexpr int kRounds = 4;
    const auto size_of = [](Real f, Real u) { return std::sqrt(f * f + u * u); };
    // Sizes over 1 + x / weight: one over the root of the sum of their squares is all but linear in x (More and Sorensen,
    // Computing a trust region step, 1983).
    Kept kept{1, 1};
    const bool has_twist = twist.size > 0 && std::isfinite(twist.weight);
    Real x = 0;
    for (int round = 0; has_twist && round < kRounds; ++round) {
        const Real f = force.size * kept.of_force;
        const Real u = twist.size * kept.of_twist;
        const Real slope = f * f / (force.weight + x) + u * u / (twist.weight + x);
        if (!(slope > 0 && limit > 0)) break;
        x = std::max(x + (f * f + u * u) / slope * (size_of(f, u) / limit - 1), Real{0});
        kept = {force.weight / (force.weight + x), twist.weight / (twist.weight + x)};
    }
    const Real size = size_of(force.size * kept.of_force, twist.size * kept.of_twist);
    const Real exact = size > 0 ? limit / size : Real{0};
    return {kept.of_force * exact, kept.of_twist * exact};
}

}  // namespace

/// Coulomb friction of the whole constraint: a force at the centre of the load and a twist about it, as
/// much as stops the slip, within the ellipsoid that approximates their common limit (Goyal, Ruina
/// and Papadopoulos, Planar sliding with dry friction, 1991).
FrictionChange ContactSet::solve_friction(ContactConstraint& constraint) {
    SolverBody& a = bodies_[constraint.a];
    SolverBody& b = bodies_[constraint.b];
    const Vec3 center_a = constraint.center_a;
    const Vec3 center_b = constraint.center_b;
    const Vec3 slip_world =
        a.velocity_at(center_a) - b.velocity_at(center_b) -
        belt_velocity_at(constraint,
                         constraint.center_offset_b + constraint.normal * constraint.radius_b);
    const Vec2 slip{glm::dot(slip_world, constraint.tangent[0]),
                    glm::dot(slip_world, constraint.tangent[1])};
    const Vec2 before{constraint.tangent_Ns[0], constraint.tangent_Ns[1]};
    const Real limit = constraint.friction * sum_of(constraint.normal_Ns);
    const Real twist_limit = limit * constraint.twist_arm_m;
    Real twist = 0;
    if (twist_limit > 0) {
        Real spin = glm::dot(a.spin_radps - b.spin_radps, constraint.normal);
        if (constraint.belt != 0)
            spin -= glm::dot(belts[constraint.belt - 1].spin_radps, constraint.normal);
        twist = constraint.twist_Nms - constraint.twist_mass * spin;
    }
    const Real twist_share = twist_limit > 0 ? twist / twist_limit : Real{0};
    const auto used_by = [&](const Vec2& force_Ns) {
        return glm::dot(force_Ns, force_Ns) + twist_share * twist_share * limit * limit;
    };
    Vec2 next = before - stopping_impulse(constraint, slip);
    const bool slides = used_by(next) > limit * limit;
    if (slides) {
        next = before - opposing_impulse(constraint, slip);
        if (used_by(next) > limit * limit) {
            const Real arm_m = constraint.twist_arm_m;
            const Kept kept = within_limit(
                limit,
                {glm::length(next),
                 (constraint.slip_response[0] + constraint.slip_response[1]) / 2},
                {std::abs(twist_share) * limit, arm_m * arm_m / constraint.twist_mass});
            next *= kept.of_force;
            twist *= kept.of_twist;
        }
    }
    const Vec3 force =
        constraint.tangent[0] * (next.x - before.x) + constraint.tangent[1] * (next.y - before.y);
    const Vec3 turning = constraint.normal * (twist - constraint.twist_Nms);
    const bool changed = !slides && glm::dot(force, force) > kMuch * kMuch * limit * limit;
    constraint.tangent_Ns[0] = next.x;
    constraint.tangent_Ns[1] = next.y;
    constraint.twist_Nms = twist;
    const auto push = [&](SolverBody& body, const Vec3& arm, Real sign) {
        if (!body.movable()) return;
        const Vec3 change = force * (sign * body.inverse_mass);
        body.velocity_mps += change;
        // Friction that is new in this sub-step acted in all of it: its half of the way. Joints would take that back.
        if (!constraint.jointed) body.delta_position_m += change * (h_ / 2);
        body.spin_radps += body.inverse_inertia * ((glm::cross(arm, force) + turning) * sign);
    };
    push(a, center_a, 1);
    push(b, center_b, -1);
    constraint.row_solves += 3;
    return {.changed_mps = glm::length(force) * constraint.slip_response[0], .is_much = changed};
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
    if (b.movable()) b.spin_radps -= b.inverse_inertia * change;
    constraint.row_solves += 3;
    const Real limit = std::max(constraint.rolling_m, constraint.spinning_m) * load;
    const bool holds = glm::dot(next, next) < limit * limit * (1 - kMuch);
    return holds && glm::dot(change, change) > kMuch * kMuch * limit * limit;
}

}  // namespace plumbline::physics
