// The normal impulses of one constraint's points, solved together: directly where all of them press,
// else by projected Gauss-Seidel. Lanes without a point keep an impulse of zero.
#pragma once

#include "engine/physics/dynamics/contact/contact_constraint.h"

#include <algorithm>

namespace plumbline::physics {

/// The impulses that take `error` (m/s, what the points' closing speeds lack) away: `before` minus
/// `mass` times it. Negative where a point would have to pull.
inline Lanes direct(Lanes before, const LaneMatrix& mass, Lanes error) {
    // The matrix is symmetric.
    Lanes change = mass[0] * splat(error[0]);
    change += mass[1] * splat(error[1]);
    change += mass[2] * splat(error[2]);
    change += mass[3] * splat(error[3]);
    return before - change;
}

/// The least impulses of two points that leave neither closing: both press, one of them, or none (a linear complementarity
/// problem; its matrix is positive definite, so that one of the four fits). `speeds`: without any impulse.
inline Lanes of_two_points(Lanes diagonal, Real coupled, Lanes speeds) {
    const Lanes alone = -speeds / diagonal;
    const Real determinant = diagonal[0] * diagonal[1] - coupled * coupled;
    const Real first = coupled * speeds[1] - diagonal[1] * speeds[0];
    const Real second = coupled * speeds[0] - diagonal[0] * speeds[1];
    if (first >= 0 && second >= 0 && determinant > 0)
        return Lanes{first / determinant, second / determinant, 0, 0};
    if (alone[0] > 0 && coupled * alone[0] + speeds[1] >= 0) return Lanes{alone[0], 0, 0, 0};
    if (alone[1] > 0 && coupled * alone[1] + speeds[0] >= 0) return Lanes{0, alone[1], 0, 0};
    return splat(0);
}

/// The impulses that make A*change + wanted + compliance*impulse = 0 where they press: of two points exactly, of more by
/// projected Gauss-Seidel within the constraint. A point's lane is a constant, so that all stays in
/// registers: of a large pile's step this is the dearest loop.
inline Lanes projected(const ContactConstraint& constraint, Lanes wanted, Lanes compliance) {
    constexpr int kSweeps = 4;
    const Lanes before = constraint.normal_Ns;
    const LaneMatrix& response = constraint.response;
    if (constraint.count == 1) {
        const Real error = wanted[0] + compliance[0] * before[0];
        return Lanes{
            std::max(before[0] - error / (response[0][0] + compliance[0]), Real{0}), 0, 0, 0};
    }
    const Lanes own = Lanes{response[0][0], response[1][1], response[2][2], response[3][3]};
    if (constraint.count == 2) {
        const Lanes firm = own * splat(1 + kRedundancy);
        const Real coupled = response[0][1];
        const Lanes speeds =
            wanted - firm * before - splat(coupled) * Lanes{before[1], before[0], 0, 0};
        return of_two_points(firm + compliance, coupled, speeds);
    }
    const Lanes diagonal = own + compliance;
    const Lanes share = splat(1) / diagonal;
    Lanes residual = wanted;
    std::array<Real, kLanes> next{before[0], before[1], before[2], before[3]};
    const auto solve = [&](int i) {
        const auto row = static_cast<std::size_t>(i);
        const Real error = residual[i] + compliance[i] * next[row];
        const Real pressing = std::max(next[row] - error * share[i], Real{0});
        residual += response[row] * splat(pressing - next[row]);
        next[row] = pressing;
    };
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
        solve(0);
        solve(1);
        solve(2);
        if (constraint.count == kLanes) solve(3);
    }
    return Lanes{next[0], next[1], next[2], next[3]};
}

/// Nothing presses and nothing closes fast enough to press.
inline bool stays_separated(const ContactConstraint& constraint, Lanes wanted) {
    return !any((wanted < splat(0)) | (constraint.normal_Ns != splat(0)));
}

/// Of the first `count` impulses.
inline bool all_press(Lanes impulses, int count) {
    return !any((impulses < splat(0)) & first_lanes(count));
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

[[gnu::always_inline]] inline NormalChange apply_normal(ContactConstraint& constraint,
                                                        SolverBody& a,
                                                        SolverBody& b,
                                                        Lanes next) {
    const Lanes change = next - constraint.normal_Ns;
    constraint.normal_Ns = next;
    NormalChange of{.gained_Ns = sum_of(change),
                    .changed_Ns = sum_of(change < splat(0) ? -change : change)};
    const Vec3 along = constraint.normal * of.gained_Ns;
    of.velocity_a = along * a.inverse_mass;
    of.velocity_b = -along * b.inverse_mass;
    of.spin_a = a.inverse_inertia * weighted_sum(constraint.angular_a, change);
    of.spin_b = -(b.inverse_inertia * weighted_sum(constraint.angular_b, change));
    a.velocity_mps += of.velocity_a;
    a.spin_radps += of.spin_a;
    if (!b.movable()) return of;  // others may read it at this moment
    b.velocity_mps += of.velocity_b;
    b.spin_radps += of.spin_b;
    return of;
}

}  // namespace plumbline::physics
