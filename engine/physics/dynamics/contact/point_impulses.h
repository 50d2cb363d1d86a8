// The normal impulses of one constraint's points, solved together: directly where all of them press,
// else by projected Gauss-Seidel. Lanes without a point keep an impulse of zero.
#pragma once

#include "engine/physics/dynamics/contact/contact_constraint.h"

#include <algorithm>

namespace plumbline::physics {

/// The impulses that take `error` (m/s, what the points' closing speeds lack) away: `before` minus
/// `mass` times it. Negative where a point would have to pull.
inline Lanes direct(const Lanes& before, const LaneMatrix& mass, const Lanes& error) {
    Lanes change{};
    for (std::size_t k = 0; k < kLanes; ++k) {
        for (std::size_t i = 0; i < kLanes; ++i) change[i] += mass[k][i] * error[k];  // symmetric
    }
    Lanes next;
    for (std::size_t i = 0; i < kLanes; ++i) next[i] = before[i] - change[i];
    return next;
}

/// The impulses that make A*change + wanted + compliance*impulse = 0 where they press, by
/// projected Gauss-Seidel within the constraint. A point's lane is a constant, so that all stays in
/// registers: of a large pile's step this is the dearest loop.
inline Lanes projected(const ContactConstraint& constraint,
                       const Lanes& wanted,
                       const Lanes& compliance) {
    constexpr int kSweeps = 4;
    Lanes next = constraint.normal_Ns;
    if (constraint.count == 1) {
        const Real error = wanted[0] + compliance[0] * next[0];
        next[0] = std::max(next[0] - error / (constraint.response[0][0] + compliance[0]), Real{0});
        return next;
    }
    Lanes residual = wanted;
    Lanes diagonal;
    for (std::size_t i = 0; i < kLanes; ++i)
        diagonal[i] = constraint.response[i][i] + compliance[i];
    const auto solve = [&](std::size_t i) {
        const Real error = residual[i] + compliance[i] * next[i];
        const Real better = next[i] - error / diagonal[i];
        const Real pressing = better > 0 ? better : Real{0};
        const Real change = pressing - next[i];
        next[i] = pressing;
        for (std::size_t k = 0; k < kLanes; ++k) residual[k] += constraint.response[i][k] * change;
    };
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
        solve(0);
        solve(1);
        solve(2);
        solve(3);
    }
    return next;
}

/// Nothing presses and nothing closes fast enough to press.
inline bool stays_separated(const ContactConstraint& constraint, const Lanes& wanted) {
    bool apart = true;
    for (std::size_t i = 0; i < kLanes; ++i)
        apart = apart && wanted[i] >= 0 && constraint.normal_Ns[i] == 0;
    return apart;
}

inline bool all_press(const Lanes& impulses, int count) {
    Real least = impulses[0];
    for (int i = 1; i < count; ++i) least = std::min(least, impulses[static_cast<std::size_t>(i)]);
    return least >= 0;
}

/// What new normal impulses change of two bodies.
struct NormalChange {
    Real gained_Ns{0};   ///< all together
    Real changed_Ns{0};  ///< of each, whichever way
    Vec3 velocity_a{0, 0, 0};
    Vec3 velocity_b{0, 0, 0};
    Vec3 spin_a{0, 0, 0};
    Vec3 spin_b{0, 0, 0};
};

inline NormalChange apply_normal(ContactConstraint& constraint,
                                 SolverBody& a,
                                 SolverBody& b,
                                 const Lanes& next) {
    Lanes change;
    for (std::size_t i = 0; i < kLanes; ++i) change[i] = next[i] - constraint.normal_Ns[i];
    constraint.normal_Ns = next;
    NormalChange of{.gained_Ns = sum_of(change)};
    for (const Real each : change) of.changed_Ns += std::abs(each);
    const Vec3 along = constraint.normal * of.gained_Ns;
    of.velocity_a = along * a.inverse_mass;
    of.velocity_b = -along * b.inverse_mass;
    of.spin_a = a.inverse_inertia * weighted_sum(constraint.angular_a, change);
    of.spin_b = -(b.inverse_inertia * weighted_sum(constraint.angular_b, change));
    a.velocity_mps += of.velocity_a;
    b.velocity_mps += of.velocity_b;
    a.spin_radps += of.spin_a;
    b.spin_radps += of.spin_b;
    return of;
}

}  // namespace plumbline::physics
