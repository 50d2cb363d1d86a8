#include "engine/physics/dynamics/contact/contact_constraint.h"

#include <algorithm>

namespace plumbline::physics {
namespace {

using Matrix = LaneMatrix;

/// Inverse of a symmetric positive definite matrix by Gauss-Jordan without pivoting.
Matrix inverse_of(Matrix m) {
    Matrix inverse{};
    for (int i = 0; i < kLanes; ++i) inverse[static_cast<std::size_t>(i)][i] = 1;
    for (int at = 0; at < kLanes; ++at) {
        const auto pivot = static_cast<std::size_t>(at);
        const Lanes scale = splat(1 / m[pivot][at]);
        m[pivot] *= scale;
        inverse[pivot] *= scale;
        for (std::size_t row = 0; row < kLanes; ++row) {
            if (row == pivot) continue;
            const Lanes share = splat(m[row][at]);
            m[row] -= share * m[pivot];
            inverse[row] -= share * inverse[pivot];
        }
    }
    return inverse;
}

Matrix reciprocals_of(const Matrix& diagonal) {
    Matrix inverse{};
    for (int i = 0; i < kLanes; ++i) {
        const auto row = static_cast<std::size_t>(i);
        inverse[row][i] = 1 / diagonal[row][i];
    }
    return inverse;
}

void prepare_friction(ContactConstraint& constraint, const SolverBody& a, const SolverBody& b) {
    const Real load = sum_of(constraint.normal_Ns);
    Lanes weights{};
    for (int i = 0; i < constraint.count; ++i)
        weights[i] =
            load > 0 ? constraint.normal_Ns[i] / load : 1 / static_cast<Real>(constraint.count);
    const Vec3 below = constraint.normal * constraint.radius_a;
    const Vec3 above = constraint.normal * constraint.radius_b;
    constraint.center_a = weighted_sum(constraint.offset_a, weights) - below;
    constraint.center_b = weighted_sum(constraint.offset_b, weights) + above;
    constraint.twist_arm_m = 0;
    for (int i = 0; i < constraint.count; ++i) {
        constraint.twist_arm_m +=
            weights[i] * glm::length(constraint.arm_a(i) - constraint.center_a);
    }
    Vec3 turn_a[2];
    Vec3 turn_b[2];
    for (int t = 0; t < 2; ++t) {
        turn_a[t] = glm::cross(constraint.center_a, constraint.tangent[t]);
        turn_b[t] = glm::cross(constraint.center_b, constraint.tangent[t]);
    }
    const auto turned = [&](int s, int t) {
        return glm::dot(turn_a[s], a.inverse_inertia * turn_a[t]) +
               glm::dot(turn_b[s], b.inverse_inertia * turn_b[t]);
    };
    for (int t = 0; t < 2; ++t)
        constraint.slip_response[t] = a.inverse_mass + b.inverse_mass + turned(t, t);
    constraint.slip_coupling = turned(0, 1);
    const Real moment = inverse_moment_along(a, b, constraint.normal);
    constraint.twist_mass = moment > 0 ? 1 / moment : Real{0};
}

}  // namespace

void prepare(ContactConstraint& constraint,
             const SolverBody& a,
             const SolverBody& b,
             const Softness& soft,
             Real sharing) {
    constraint.start_normal = constraint.normal;
    constraint.against_immovable = !a.movable() || !b.movable();
    constraint.carried = !constraint.rounded() && !b.movable() && b.spin_radps != Vec3{0, 0, 0};
    constraint.jointed = a.jointed || b.jointed;
    LaneVec3 gain_a;
    LaneVec3 gain_b;
    for (int i = 0; i < kLanes; ++i) {
        const bool used = i < constraint.count;
        const Vec3 angular_a =
            used ? glm::cross(constraint.arm_a(i), constraint.normal) : Vec3{0, 0, 0};
        const Vec3 angular_b =
            used ? glm::cross(constraint.arm_b(i), constraint.normal) : Vec3{0, 0, 0};
        set_lane(constraint.angular_a, i, angular_a);
        set_lane(constraint.angular_b, i, angular_b);
        set_lane(gain_a, i, a.inverse_inertia * angular_a);
        set_lane(gain_b, i, b.inverse_inertia * angular_b);
    }
    const Real linear = a.inverse_mass + b.inverse_mass;
    Matrix soft_matrix;
    Matrix rigid_matrix;
    for (int i = 0; i < kLanes; ++i) {
        const auto row = static_cast<std::size_t>(i);
        const bool used = i < constraint.count;
        const Lanes of_a = dot_lanes(lane(constraint.angular_a, i), gain_a);
        const Lanes of_b = dot_lanes(lane(constraint.angular_b, i), gain_b);
        Lanes own{};
        own[i] = 1;
        constraint.response[row] =
            used ? (first_lanes(constraint.count) ? splat(linear) + of_a + of_b : own) : own;
        // share = A / (A + compliance) turns softness into the compliance of the row.
        constraint.compliance[i] =
            constraint.response[row][i] * sharing * soft.decay / std::max(soft.mass_share, 1e-6_r);
        soft_matrix[row] = rigid_matrix[row] = constraint.response[row];
        soft_matrix[row][i] += constraint.compliance[i];
        rigid_matrix[row][i] *= 1 + kRedundancy * Real(constraint.count > 1);
    }
    constraint.soft_mass =
        constraint.count > 1 ? inverse_of(soft_matrix) : reciprocals_of(soft_matrix);
    constraint.rigid_mass =
        constraint.count > 1 ? inverse_of(rigid_matrix) : reciprocals_of(rigid_matrix);
    if (constraint.friction > 0) prepare_friction(constraint, a, b);
}

}  // namespace plumbline::physics
