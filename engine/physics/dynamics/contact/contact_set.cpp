#include "engine/physics/dynamics/contact/contact_set.h"

#include "engine/physics/dynamics/substep_choice.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

constexpr Real kContactDamping = 10;  ///< ratio: far above 1, sinking in never swings back
constexpr int kProjectedSweeps = 4;   ///< within a block, where some points press and some do not
constexpr int kRubRounds = 12;  ///< of normals and friction, where what sticks changed by much ...
constexpr Real kOneSpot = 1e-4_r;  ///< nearer centres, as a share of the radii, have no direction
constexpr Real kShove = 0.05_r;    ///< of the fastest push: more is deep overlap
constexpr Real kOut_m = 1e-5_r;    ///< what bounced and will be no deeper is out
constexpr Real kMuch = 0.005_r;    ///< ... as a share of its limit

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
    return {around * std::cos(angle), height, around * std::sin(angle)};
}

inline Lanes opening_speeds(const ContactBlock& block, const SolverBody& a, const SolverBody& b) {
    const Real along = glm::dot(block.normal, a.velocity_mps - b.velocity_mps);
    const Lanes of_a = dot_lanes(a.spin_radps, block.angular_a);
    const Lanes of_b = dot_lanes(b.spin_radps, block.angular_b);
    Lanes speeds;
    for (std::size_t i = 0; i < kLanes; ++i) speeds[i] = along + of_a[i] - of_b[i];
    return speeds;
}

/// The impulses that make A*change + wanted + compliance*impulse = 0 where they press, by
/// projected Gauss-Seidel within the block. A point's lane is a constant, so that all stays in
/// registers: of a large pile's step this is the dearest loop.
Lanes projected(const ContactBlock& block, const Lanes& wanted, const Lanes& compliance) {
    Lanes next = block.normal_Ns;
    if (block.count == 1) {
        const Real error = wanted[0] + compliance[0] * next[0];
        next[0] = std::max(next[0] - error / (block.response[0][0] + compliance[0]), Real{0});
        return next;
    }
    Lanes residual = wanted;
    Lanes diagonal;
    for (std::size_t i = 0; i < kLanes; ++i) diagonal[i] = block.response[i][i] + compliance[i];
    const auto solve = [&](std::size_t i) {
        const Real error = residual[i] + compliance[i] * next[i];
        const Real better = next[i] - error / diagonal[i];
        const Real pressing = better > 0 ? better : Real{0};
        const Real change = pressing - next[i];
        next[i] = pressing;
        for (std::size_t k = 0; k < kLanes; ++k) residual[k] += block.response[i][k] * change;
    };
    for (int sweep = 0; sweep < kProjectedSweeps; ++sweep) {
        solve(0);
        solve(1);
        solve(2);
        solve(3);
    }
    return next;
}

inline Lanes product(const LaneMatrix& m, const Lanes& v) {
    Lanes result{};
    for (std::size_t k = 0; k < kLanes; ++k) {
        for (std::size_t i = 0; i < kLanes; ++i) result[i] += m[k][i] * v[k];  // m is symmetric
    }
    return result;
}

/// Nothing presses and nothing closes fast enough to press.
inline bool stays_apart(const ContactBlock& block, const Lanes& wanted) {
    bool apart = true;
    for (std::size_t i = 0; i < kLanes; ++i)
        apart = apart && wanted[i] >= 0 && block.normal_Ns[i] == 0;
    return apart;
}

inline bool all_press(const Lanes& impulses, int count) {
    Real least = impulses[0];
    for (int i = 1; i < count; ++i) least = std::min(least, impulses[static_cast<std::size_t>(i)]);
    return least >= 0;
}

inline void press(ContactBlock& block, SolverBody& a, SolverBody& b, const Lanes& next) {
    Lanes change;
    for (std::size_t i = 0; i < kLanes; ++i) change[i] = next[i] - block.normal_Ns[i];
    block.normal_Ns = next;
    const Vec3 along = block.normal * sum_of(change);
    a.velocity_mps += along * a.inverse_mass;
    b.velocity_mps -= along * b.inverse_mass;
    a.spin_radps += a.inverse_inertia * weighted_sum(block.angular_a, change);
    b.spin_radps -= b.inverse_inertia * weighted_sum(block.angular_b, change);
}

/// A new push of `gained_mps` along `normal` holds against what would have moved the body into the
/// contact all through the sub-step: nothing is left of that to take half of the way for.
inline void hold_against(SolverBody& body, const Vec3& normal, Real gained_mps) {
    const Real pressing_mps = -glm::dot(body.steady_mps, normal);
    body.steady_mps += normal * std::max(std::min(gained_mps, pressing_mps), Real{0});
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

    for (ContactBlock& block : blocks) {
        const SolverBody& a = bodies[block.a];
        const SolverBody& b = bodies[block.b];
        prepare(block, a, b, a.movable() && b.movable() ? between_movable_ : against_immovable_);
    }
    order_.clear();
    for (std::uint32_t i = 0; i < blocks.size(); ++i) {
        if (!blocks[i].against_immovable) order_.push_back(i);
    }
    for (std::uint32_t i = 0; i < blocks.size(); ++i) {
        if (blocks[i].against_immovable) order_.push_back(i);
    }
}

void ContactSet::warm_start() {
    for (const std::uint32_t index : order_) {
        const ContactBlock& block = blocks[index];
        SolverBody& a = bodies_[block.a];
        SolverBody& b = bodies_[block.b];
        const Vec3 rub =
            block.tangent[0] * block.tangent_Ns[0] + block.tangent[1] * block.tangent_Ns[1];
        const Vec3 impulse = block.normal * sum_of(block.normal_Ns) + rub;
        const Vec3 turning = block.normal * block.twist_Nms + block.rolling_Nms;
        const Vec3 torque_a = weighted_sum(block.angular_a, block.normal_Ns) +
                              glm::cross(block.center_a, rub) + turning;
        const Vec3 torque_b = weighted_sum(block.angular_b, block.normal_Ns) +
                              glm::cross(block.center_b, rub) + turning;
        a.steady_mps += impulse * a.inverse_mass;
        a.steady_radps += a.inverse_inertia * torque_a;
        b.steady_mps -= impulse * b.inverse_mass;
        b.steady_radps -= b.inverse_inertia * torque_b;
    }
}

/// Two balls: the normal turns with the line between their centres.
void ContactSet::place_balls(ContactBlock& block) const {
    const SolverBody& a = bodies_[block.a];
    const SolverBody& b = bodies_[block.b];
    const Vec3 offset_a = a.turned * lane(block.offset_a, 0);
    const Vec3 offset_b = b.turned * lane(block.offset_b, 0);
    const Real reach_m = block.radius_a + block.radius_b;
    const Vec3 apart = block.start_normal * (reach_m + block.start_separation_m[0]) + a.moved_m -
                       b.moved_m + (offset_a - lane(block.offset_a, 0)) -
                       (offset_b - lane(block.offset_b, 0));
    const Real distance = glm::length(apart);
    // Balls on one spot part in directions that differ from pair to pair.
    block.normal =
        distance > reach_m * kOneSpot ? apart / distance : direction_of(block.a * 7919U + block.b);
    block.separation_m[0] = distance - reach_m;
    block.center_a = offset_a - block.normal * block.radius_a;
    block.center_b = offset_b + block.normal * block.radius_b;
    set_lane(block.angular_a, 0, glm::cross(block.center_a, block.normal));
    set_lane(block.angular_b, 0, glm::cross(block.center_b, block.normal));
    const Vec3 along = block.tangent[0] - block.normal * glm::dot(block.normal, block.tangent[0]);
    block.tangent[0] = normalize_or(along, block.tangent[1]);
    block.tangent[1] = glm::cross(block.normal, block.tangent[0]);
}

void ContactSet::place(ContactBlock& block) const {
    if (block.balls()) return place_balls(block);
    const SolverBody& a = bodies_[block.a];
    const SolverBody& b = bodies_[block.b];
    const Vec3 moved = a.moved_m - b.moved_m;
    const Real along = glm::dot(block.normal, moved);
    const Lanes of_a = dot_lanes(turned_back_change(a.turned, block.normal), block.offset_a);
    const Lanes of_b = dot_lanes(turned_back_change(b.turned, block.normal), block.offset_b);
    for (std::size_t i = 0; i < kLanes; ++i)
        block.separation_m[i] = block.start_separation_m[i] + along + of_a[i] - of_b[i];
    if (!block.rounded()) return;
    // The ball moved over the other side: what touches it there is where the ball is now.
    const Vec3 shift = block.shift_of(moved);
    for (int i = 0; i < block.count; ++i) {
        if (block.radius_a > 0) {
            set_lane(block.angular_b, i, glm::cross(block.arm_b(i) + shift, block.normal));
        } else {
            set_lane(block.angular_a, i, glm::cross(block.arm_a(i) - shift, block.normal));
        }
    }
}

void ContactSet::solve_with_bias(ContactBlock& block) {
    SolverBody& a = bodies_[block.a];
    SolverBody& b = bodies_[block.b];
    const Softness& soft = block.against_immovable ? against_immovable_ : between_movable_;
    place(block);
    Lanes wanted = opening_speeds(block, a, b);
    Lanes compliance{};
    bool all_overlap = true;
    const Real pull_m = glm::dot(a.steady_mps - b.steady_mps, block.normal) * (h_ / 2);
    for (std::size_t i = 0; i < kLanes; ++i) {
        const bool overlaps = block.separation_m[i] <= 0;
        all_overlap = all_overlap && (overlaps || static_cast<int>(i) >= block.count);
        // What bounced is on its way out already, at the speed it should have.
        if (overlaps && block.restitution > 0 && wanted[i] > bounce_mps_) continue;
        if (block.bounced && block.separation_m[i] + wanted[i] * h_ - pull_m > -kOut_m) continue;
        const Real bias = soft.bias_per_s * block.separation_m[i];
        wanted[i] += overlaps ? std::max(bias, -push_mps_) : block.separation_m[i] / h_;
        if (overlaps && bias < -kShove * push_mps_) a.shoved = b.shoved = true;
        compliance[i] = overlaps ? block.compliance[i] : Real{0};
    }
    if (stays_apart(block, wanted)) return;
    Lanes next;
    bool solved = false;
    if (all_overlap) {
        Lanes error;
        for (std::size_t i = 0; i < kLanes; ++i)
            error[i] = static_cast<int>(i) < block.count
                           ? wanted[i] + compliance[i] * block.normal_Ns[i]
                           : Real{0};
        const Lanes change = product(block.soft_mass, error);
        for (std::size_t i = 0; i < kLanes; ++i) next[i] = block.normal_Ns[i] - change[i];
        solved = all_press(next, block.count);
    }
    if (!solved) next = projected(block, wanted, compliance);
    const Real gained_Ns = sum_of(next) - sum_of(block.normal_Ns);
    press(block, a, b, next);
    if (gained_Ns > 0) {
        hold_against(a, block.normal, gained_Ns * a.inverse_mass);
        hold_against(b, -block.normal, gained_Ns * b.inverse_mass);
    } else {
        // What is taken back of the impulse before, of a blow that is over, did not act either.
        a.steady_mps += block.normal * (gained_Ns * a.inverse_mass);
        b.steady_mps -= block.normal * (gained_Ns * b.inverse_mass);
    }
}

void ContactSet::relax(ContactBlock& block) {
    place(block);
    // Friction turns a body about its centre, which loads other points than before: where it did
    // so, both are solved again.
    for (int round = 0; round < kRubRounds; ++round) {
        if (!carry(block)) return;
        bool changed = block.friction > 0 && rub(block);
        if (block.rolling_m > 0 || block.spinning_m > 0) changed |= resist_rolling(block);
        if (!changed) return;
    }
}

/// Normal impulses without bias. False: the bodies are apart and nothing holds them any more.
bool ContactSet::carry(ContactBlock& block) {
    SolverBody& a = bodies_[block.a];
    SolverBody& b = bodies_[block.b];
    Lanes wanted = opening_speeds(block, a, b);
    bool all_overlap = true;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const bool used = static_cast<int>(i) < block.count;
        if (block.separation_m[i] <= 0) continue;
        all_overlap = all_overlap && !used;
        // A point that does not touch yet is left to the next sub-step, which looks ahead itself: to
        // do it here as well would eat the speed of what is to bounce, and would let a body be
        // pushed by a carrier that comes to a stop at it.
        const bool touches = block.normal_Ns[i] > 0;
        wanted[i] = touches ? wanted[i] + block.separation_m[i] / h_ : kNoPoint_m;
    }
    if (stays_apart(block, wanted) && !block.rubs()) return false;
    Lanes next;
    bool solved = false;
    if (all_overlap) {
        for (std::size_t i = static_cast<std::size_t>(block.count); i < kLanes; ++i) wanted[i] = 0;
        const Lanes change = product(block.rigid_mass, wanted);
        for (std::size_t i = 0; i < kLanes; ++i) next[i] = block.normal_Ns[i] - change[i];
        solved = all_press(next, block.count);
    }
    if (!solved) next = projected(block, wanted, Lanes{});
    press(block, a, b, next);
    row_solves += static_cast<std::uint64_t>(block.count);
    return true;
}

/// Coulomb friction of the whole block: a force at the centre of the load and a twist about it, as
/// much as stops the slip, within the ellipsoid that approximates their common limit (Goyal, Ruina
/// and Papadopoulos, Planar sliding with dry friction, 1991). Returns whether what
/// sticks changed by much.
bool ContactSet::rub(ContactBlock& block) {
    SolverBody& a = bodies_[block.a];
    SolverBody& b = bodies_[block.b];
    Vec3 center_a = block.center_a;
    Vec3 center_b = block.center_b;
    if (block.carried) {
        // The place goes round with what carries it.
        const Vec3 shift = b.turned * block.center_b - block.center_b;
        center_a += shift + b.moved_m - a.moved_m;
        center_b += shift;
    }
    if (block.balls()) {
        // place_balls() left them where they are
    } else if (block.radius_a > 0) {
        center_b += block.shift_of(a.moved_m - b.moved_m);
    } else if (block.radius_b > 0) {
        center_a += block.shift_of(b.moved_m - a.moved_m);
    }
    const Vec3 slip = a.velocity_at(center_a) - b.velocity_at(center_b);
    Real next[2];
    for (int t = 0; t < 2; ++t)
        next[t] = block.tangent_Ns[t] - block.tangent_mass[t] * glm::dot(slip, block.tangent[t]);
    const Real limit = block.friction * sum_of(block.normal_Ns);
    const Real twist_limit = limit * block.twist_arm_m;
    Real twist = 0;
    if (twist_limit > 0) {
        const Real spin = glm::dot(a.spin_radps - b.spin_radps, block.normal);
        twist = block.twist_Nms - block.twist_mass * spin;
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
    const Vec3 force = block.tangent[0] * (next[0] - block.tangent_Ns[0]) +
                       block.tangent[1] * (next[1] - block.tangent_Ns[1]);
    const Vec3 turning = block.normal * (twist - block.twist_Nms);
    const bool changed = !slides && glm::dot(force, force) > kMuch * kMuch * limit * limit;
    block.tangent_Ns[0] = next[0];
    block.tangent_Ns[1] = next[1];
    block.twist_Nms = twist;
    const Vec3 change_a = force * a.inverse_mass;
    const Vec3 change_b = force * b.inverse_mass;
    a.velocity_mps += change_a;
    b.velocity_mps -= change_b;
    // Friction that is new in this sub-step acted in all of it: its half of the way.
    a.moved_m += change_a * (h_ / 2);
    b.moved_m -= change_b * (h_ / 2);
    a.spin_radps += a.inverse_inertia * (glm::cross(center_a, force) + turning);
    b.spin_radps -= b.inverse_inertia * (glm::cross(center_b, force) + turning);
    row_solves += 3;
    return changed;
}

/// Resistance to rolling and to spinning: torques of at most a length times the load. Returns
/// whether what holds changed by much.
bool ContactSet::resist_rolling(ContactBlock& block) {
    SolverBody& a = bodies_[block.a];
    SolverBody& b = bodies_[block.b];
    const Vec3 relative = a.spin_radps - b.spin_radps;
    const Real load = sum_of(block.normal_Ns);
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
    const Vec3 held_spin = block.normal * glm::dot(block.rolling_Nms, block.normal);
    const Vec3 spin = block.normal * glm::dot(relative, block.normal);
    const Vec3 next =
        bounded(spin, held_spin, block.spinning_m * load) +
        bounded(relative - spin, block.rolling_Nms - held_spin, block.rolling_m * load);
    const Vec3 change = next - block.rolling_Nms;
    block.rolling_Nms = next;
    a.spin_radps += a.inverse_inertia * change;
    b.spin_radps -= b.inverse_inertia * change;
    row_solves += 3;
    const Real limit = std::max(block.rolling_m, block.spinning_m) * load;
    const bool holds = glm::dot(next, next) < limit * limit * (1 - kMuch);
    return holds && glm::dot(change, change) > kMuch * kMuch * limit * limit;
}

void ContactSet::solve_with_bias() {
    for (const std::uint32_t index : order_) {
        solve_with_bias(blocks[index]);
        row_solves += static_cast<std::uint64_t>(blocks[index].count);
    }
}

void ContactSet::relax() {
    for (const std::uint32_t index : order_) {
        relax(blocks[index]);
    }
}

void ContactSet::end_substep() {
    for (ContactBlock& block : blocks) {
        for (std::size_t i = 0; i < kLanes; ++i) block.total_Ns[i] += block.normal_Ns[i];
        block.bounced = false;
        // Who is pressed by what was pushed out moves as fast.
        SolverBody& a = bodies_[block.a];
        SolverBody& b = bodies_[block.b];
        if ((a.shoved || b.shoved) && sum_of(block.normal_Ns) > 0) a.shoved = b.shoved = true;
    }
}

}  // namespace plumbline::physics
