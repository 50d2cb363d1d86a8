#include "engine/physics/small_step/geometric_stiffness.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

/// Motion with a larger square of (angular frequency * sub-step) is slowed down, to the other one.
constexpr double kTooFast = 3.0;
constexpr double kSlowEnough = 2.0;
/// Smaller changes of inertia are not worth a new factor.
constexpr double kNoticeable = 1.02;

bool pulls_at_arms(NodeKind kind) {
    return kind == NodeKind::Point || kind == NodeKind::Across || kind == NodeKind::Length;
}

/// The inverse of the least mass that the body shows at the anchor.
double most_inverse_mass(const JointBody& body, const Vec3d& anchor) {
    const Vec3d& inverse = body.inverse_moments;
    return body.inverse_mass +
           glm::dot(anchor, anchor) * std::max({inverse.x, inverse.y, inverse.z});
}

}  // namespace

void GeometricStiffness::start(const JointGroup& group) {
    stiffness_Nm_.assign(group.bodies.size(), 0.0);
    pivot_kgm2_.assign(group.bodies.size(), 0.0);
    std::vector<std::uint32_t>& joints = joints_at_;
    joints.assign(group.bodies.size(), 0);
    for (const JointRows& rows : group.rows) {
        if (!pulls_at_arms(rows.kind)) continue;
        ++joints[rows.a];
        ++joints[rows.b];
    }
    for (const JointRows& rows : group.rows) {
        if (rows.kind != NodeKind::Point) continue;
        const auto pivot = [&](std::uint32_t index,
                               const Vec3d& arm,
                               std::uint32_t other_index,
                               const Vec3d& other_arm) {
            const JointBody& body = group.bodies[index];
            const JointBody& other = group.bodies[other_index];
            if (!body.movable || (other.movable && joints[index] > 1)) return;
            const double mass =
                1 / (body.inverse_mass + (other.movable ? most_inverse_mass(other, other_arm) : 0));
            pivot_kgm2_[index] = std::max(pivot_kgm2_[index], mass * glm::dot(arm, arm));
        };
        pivot(rows.a, rows.anchor_in_a, rows.b, rows.anchor_in_b);
        pivot(rows.b, rows.anchor_in_b, rows.a, rows.anchor_in_a);
    }
}

void GeometricStiffness::add_pull(const JointRows& rows, const Vec3d& force_on_b) {
    // The stiffest direction of the symmetric part of [f]x[r]x.
    const double force = glm::length(force_on_b);
    stiffness_Nm_[rows.a] +=
        0.5 * (force * glm::length(rows.arm_a) - glm::dot(force_on_b, rows.arm_a));
    stiffness_Nm_[rows.b] +=
        0.5 * (force * glm::length(rows.arm_b) + glm::dot(force_on_b, rows.arm_b));
}

double GeometricStiffness::wanted_moment(std::size_t body, double moment, double substep_s) const {
    const double needed = stiffness_Nm_[body] * substep_s * substep_s;
    const double pivot = pivot_kgm2_[body];
    if (needed < kTooFast * (moment + pivot)) return moment;
    return std::max(moment, needed / kSlowEnough - pivot);
}

bool GeometricStiffness::raise(JointGroup& group, std::span<const Vec3d> corrections) {
    const double h = group.substep_s;
    std::ranges::fill(stiffness_Nm_, 0.0);
    for (std::size_t i = 0; i < group.rows.size(); ++i) {
        const JointRows& rows = group.rows[i];
        if (!pulls_at_arms(rows.kind)) continue;
        add_pull(rows, -rows.force_on_a((group.impulses[i] + corrections[i] / h) / h));
    }
    bool any = false;
    for (std::size_t i = 0; i < group.bodies.size(); ++i) {
        JointBody& body = group.bodies[i];
        if (!body.movable) continue;
        Vec3d kept{1, 1, 1};
        for (int k = 0; k < 3; ++k) {
            const double now = body.inverse_moments[k];
            if (!(now > 0)) continue;
            kept[k] = 1 / std::max(1.0, wanted_moment(i, body.moments[k], h) * now);
        }
        if (std::min({kept.x, kept.y, kept.z}) * kNoticeable > 1) continue;
        any = true;
        body.inverse_moments *= kept;
        body.slow_down(kept, h);
        body.update_inertia();
    }
    if (any) {
        for (JointRows& rows : group.rows) rows.update_responses(group.bodies);
    }
    return any;
}

void GeometricStiffness::lower(JointGroup& group) {
    for (std::size_t i = 0; i < group.bodies.size(); ++i) {
        JointBody& body = group.bodies[i];
        if (!body.movable) continue;
        for (int k = 0; k < 3; ++k) {
            double& inverse = body.inverse_moments[k];
            if (!(inverse * body.moments[k] < 1) || inverse <= 0) continue;
            inverse = std::max(inverse, 1 / wanted_moment(i, body.moments[k], group.substep_s));
        }
    }
}

}  // namespace plumbline::physics
