#include "engine/physics/small_step/contact_set.h"

#include <algorithm>

namespace plumbline::physics {
namespace {

/// Shares of 1/h at which contacts are as stiff as sweeps still hold stable, and their damping.
constexpr Real kContactFrequency = 0.125_r;
constexpr Real kContactDamping = 10;

Real mass_along(const SolverBody& a,
                const SolverBody& b,
                const Vec3& arm_a,
                const Vec3& arm_b,
                const Vec3& direction) {
    const Vec3 turn_a = glm::cross(arm_a, direction);
    const Vec3 turn_b = glm::cross(arm_b, direction);
    const Real inverse = a.inverse_mass + b.inverse_mass +
                         glm::dot(turn_a, a.inverse_inertia * turn_a) +
                         glm::dot(turn_b, b.inverse_inertia * turn_b);
    return inverse > 0 ? 1 / inverse : Real{0};
}

Real inverse_moment_along(const SolverBody& a, const SolverBody& b, const Vec3& axis) {
    return glm::dot(axis, a.inverse_inertia * axis) + glm::dot(axis, b.inverse_inertia * axis);
}

/// R(q)^T v - v without the cancellation of the two terms.
Vec3 turned_back_change(const Quat& q, const Vec3& v) {
    const Vec3 axis{-q.x, -q.y, -q.z};
    const Vec3 t = Real{2} * glm::cross(axis, v);
    return q.w * t + glm::cross(axis, t);
}

}  // namespace

void ContactSet::begin_step(std::span<SolverBody> bodies, Real h, Real push_mps) {
    bodies_ = bodies;
    h_ = h;
    push_mps_ = push_mps;
    row_solves_ = 0;
    any_restitution_ = false;
    const Real stiff_hz = kContactFrequency / h;
    between_movable_ = softness_of(stiff_hz, kContactDamping, h);
    against_immovable_ = softness_of(2 * stiff_hz, kContactDamping / 2, h);

    order_.clear();
    for (std::uint32_t i = 0; i < groups.size(); ++i) {
        if (!groups[i].bounded) order_.push_back(i);
    }
    for (std::uint32_t i = 0; i < groups.size(); ++i) {
        if (groups[i].bounded) order_.push_back(i);
    }
    for (const ContactGroup& group : groups) {
        const SolverBody& a = bodies[group.a];
        const SolverBody& b = bodies[group.b];
        any_restitution_ = any_restitution_ || group.restitution > 0;
        for (std::uint32_t i = group.first; i < group.first + group.count; ++i) {
            ContactPoint& point = points[i];
            point.arm_a = point.offset_a - group.normal * point.radius_a;
            point.arm_b = point.offset_b + group.normal * point.radius_b;
            point.normal_mass = mass_along(a, b, point.arm_a, point.arm_b, group.normal);
            for (int t = 0; t < 2; ++t) {
                point.tangent_mass[t] =
                    mass_along(a, b, point.arm_a, point.arm_b, group.tangent[t]);
            }
        }
    }
}

void ContactSet::warm_start() {
    for (const std::uint32_t index : order_) {
        const ContactGroup& group = groups[index];
        SolverBody& a = bodies_[group.a];
        SolverBody& b = bodies_[group.b];
        for (std::uint32_t i = group.first; i < group.first + group.count; ++i) {
            const ContactPoint& point = points[i];
            const Vec3 impulse = group.normal * point.normal_Ns +
                                 group.tangent[0] * point.tangent_Ns[0] +
                                 group.tangent[1] * point.tangent_Ns[1];
            const Vec3 torque_a = glm::cross(point.arm_a, impulse) + point.rolling_Nms;
            const Vec3 torque_b = glm::cross(point.arm_b, impulse) + point.rolling_Nms;
            a.steady_mps += impulse * a.inverse_mass;
            a.steady_radps += a.inverse_inertia * torque_a;
            b.steady_mps -= impulse * b.inverse_mass;
            b.steady_radps -= b.inverse_inertia * torque_b;
        }
    }
}

/// Separation of each point now; where a ball touches, the arms follow it.
void ContactSet::place(const ContactGroup& group) {
    const SolverBody& a = bodies_[group.a];
    const SolverBody& b = bodies_[group.b];
    const Vec3 moved = a.moved_m - b.moved_m;
    const Real along = glm::dot(group.normal, moved);
    const Vec3 turn_a = turned_back_change(a.turned, group.normal);
    const Vec3 turn_b = turned_back_change(b.turned, group.normal);
    for (std::uint32_t i = group.first; i < group.first + group.count; ++i) {
        ContactPoint& point = points[i];
        point.separation_m = point.start_separation_m + along + glm::dot(turn_a, point.offset_a) -
                             glm::dot(turn_b, point.offset_b);
        if (point.radius_a > 0) {
            // The ball of a moved over b: the point on b is where the ball is now.
            point.arm_b = point.offset_b + group.normal * point.radius_b + moved;
        } else if (point.radius_b > 0) {
            point.arm_a = point.offset_a - moved;
        }
    }
}

template <ContactSet::Pass pass>
void ContactSet::solve(ContactGroup& group) {
    SolverBody& a = bodies_[group.a];
    SolverBody& b = bodies_[group.b];
    const Softness& soft = group.bounded ? against_immovable_ : between_movable_;
    place(group);
    for (std::uint32_t i = group.first; i < group.first + group.count; ++i) {
        ContactPoint& point = points[i];
        Real bias = 0;
        Real share = 1;
        Real decay = 0;
        if (point.separation_m > 0) {
            // A bouncy point that does not touch yet is the impact pass's: what looks ahead into
            // the next sub-step would eat the speed before the impact is seen.
            if (pass == Pass::Relax && group.restitution > 0 && point.normal_Ns == 0) continue;
            bias = point.separation_m / h_;
        } else if (pass == Pass::Bias) {
            bias = std::max(soft.mass_share * soft.bias_per_s * point.separation_m, -push_mps_);
            share = soft.mass_share;
            decay = soft.decay;
        }
        const Vec3 relative = a.velocity_at(point.arm_a) - b.velocity_at(point.arm_b);
        const Real speed = glm::dot(relative, group.normal);
        const Real change = -point.normal_mass * (share * speed + bias) - decay * point.normal_Ns;
        const Real next = std::max(point.normal_Ns + change, Real{0});
        const Vec3 impulse = group.normal * (next - point.normal_Ns);
        point.normal_Ns = next;
        a.push(impulse, point.arm_a);
        b.push(-impulse, point.arm_b);

        if (pass == Pass::Bias) continue;
        if (group.friction > 0) {
            const Vec3 slip = a.velocity_at(point.arm_a) - b.velocity_at(point.arm_b);
            Real t0 =
                point.tangent_Ns[0] - point.tangent_mass[0] * glm::dot(slip, group.tangent[0]);
            Real t1 =
                point.tangent_Ns[1] - point.tangent_mass[1] * glm::dot(slip, group.tangent[1]);
            const Real limit = group.friction * point.normal_Ns;
            const Real length = std::sqrt(t0 * t0 + t1 * t1);
            if (length > limit) {
                t0 *= limit / length;
                t1 *= limit / length;
            }
            const Vec3 rub = group.tangent[0] * (t0 - point.tangent_Ns[0]) +
                             group.tangent[1] * (t1 - point.tangent_Ns[1]);
            point.tangent_Ns[0] = t0;
            point.tangent_Ns[1] = t1;
            a.push(rub, point.arm_a);
            b.push(-rub, point.arm_b);
        }
        if (group.rolling_m > 0 || group.spinning_m > 0) solve_rolling(group, point, a, b);
    }
    row_solves_ += group.count * (pass == Pass::Bias ? 1U : 3U);
}

/// Resistance to rolling and to spinning: torques of at most a length times the load.
void ContactSet::solve_rolling(const ContactGroup& group,
                               ContactPoint& point,
                               SolverBody& a,
                               SolverBody& b) {
    const Vec3 relative = a.spin_radps - b.spin_radps;
    const auto bounded = [&](const Vec3& spin, const Vec3& held, Real limit) {
        const Real speed = glm::length(spin);
        Vec3 wanted = held;
        if (speed > 0) {
            const Vec3 axis = spin / speed;
            const Real inverse = inverse_moment_along(a, b, axis);
            if (inverse > 0) wanted -= spin / inverse;
        }
        const Real length = glm::length(wanted);
        return length > limit ? wanted * (limit / length) : wanted;
    };
    const Vec3 held_spin = group.normal * glm::dot(point.rolling_Nms, group.normal);
    const Vec3 spin = group.normal * glm::dot(relative, group.normal);
    const Vec3 next =
        bounded(spin, held_spin, group.spinning_m * point.normal_Ns) +
        bounded(relative - spin, point.rolling_Nms - held_spin, group.rolling_m * point.normal_Ns);
    const Vec3 change = next - point.rolling_Nms;
    point.rolling_Nms = next;
    a.spin_radps += a.inverse_inertia * change;
    b.spin_radps -= b.inverse_inertia * change;
    row_solves_ += 3;
}

template <ContactSet::Pass pass>
void ContactSet::sweep() {
    for (const std::uint32_t index : order_) solve<pass>(groups[index]);
}

void ContactSet::end_substep() {
    for (ContactPoint& point : points) point.total_Ns += point.normal_Ns;
}

void ContactSet::solve_with_bias() {
    sweep<Pass::Bias>();
}
void ContactSet::relax() {
    sweep<Pass::Relax>();
}

}  // namespace plumbline::physics
