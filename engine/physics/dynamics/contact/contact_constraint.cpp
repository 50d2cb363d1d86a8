#include "engine/physics/dynamics/contact/contact_constraint.h"

#include <algorithm>

namespace plumbline::physics {
namespace {

using Matrix = LaneMatrix;

/// Inverse of a symmetric positive definite matrix by Gauss-Jordan without pivoting. Rows from `kCount` on are those of
/// the identity.
template <int kCount>
Matrix inverse_of_first(Matrix m) {
    Matrix inverse{};
    for (int i = 0; i < kLanes; ++i) inverse[static_cast<std::size_t>(i)][i] = 1;
    for (int at = 0; at < kCount; ++at) {
        const auto pivot = static_cast<std::size_t>(at);
        const Lanes scale = splat(1 / m[pivot][at]);
        m[pivot] *= scale;
        inverse[pivot] *= scale;
        for (std::size_t row = 0; row < kCount; ++row) {
            if (row == pivot) continue;
            const Lanes share = splat(m[row][at]);
            m[row] -= share * m[pivot];
            inverse[row] -= share * inverse[pivot];
        }
    }
    return inverse;
}

Matrix inverse_of(const Matrix& m, int count) {
    if (count == 1) return inverse_of_first<1>(m);
    if (count == 2) return inverse_of_first<2>(m);
    return count == 3 ? inverse_of_first<3>(m) : inverse_of_first<4>(m);
}

/// As SymmetricMat3 times each.
LaneVec3 times(const SymmetricMat3& m, const LaneVec3& v) {
    return {splat(m.xx) * v[0] + splat(m.xy) * v[1] + splat(m.xz) * v[2],
            splat(m.xy) * v[0] + splat(m.yy) * v[1] + splat(m.yz) * v[2],
            splat(m.xz) * v[0] + splat(m.yz) * v[1] + splat(m.zz) * v[2]};
}

LaneVec3 moved_by(const LaneVec3& vectors, const Vec3& by) {
    return {vectors[0] + splat(by.x), vectors[1] + splat(by.y), vectors[2] + splat(by.z)};
}

Lanes lengths_of(const LaneVec3& vectors) {
    const Lanes squares =
        vectors[0] * vectors[0] + vectors[1] * vectors[1] + vectors[2] * vectors[2];
    return Lanes{
        std::sqrt(squares[0]), std::sqrt(squares[1]), std::sqrt(squares[2]), std::sqrt(squares[3])};
}

void weigh_friction(ContactConstraint& constraint, const SolverBody& a, const SolverBody& b) {
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

void place_friction(ContactConstraint& constraint) {
    const Real load = sum_of(constraint.normal_Ns);
    const Lanes shares = load > 0 ? constraint.normal_Ns / splat(load)
                                  : splat(1 / static_cast<Real>(constraint.count));
    const Lanes weights = first_lanes(constraint.count) ? shares : splat(0);
    constraint.center_offset_a = weighted_sum(constraint.offset_a, weights);
    constraint.center_offset_b = weighted_sum(constraint.offset_b, weights);
    const Vec3 below = constraint.normal * constraint.radius_a;
    constraint.center_a = constraint.center_offset_a - below;
    constraint.center_b = constraint.center_offset_b + constraint.normal * constraint.radius_b;
    const Lanes arms_m =
        weights * lengths_of(moved_by(moved_by(constraint.offset_a, -below), -constraint.center_a));
    constraint.twist_arm_m = arms_m[0] + arms_m[1] + arms_m[2] + arms_m[3];
}

/// `gives`: the compliance of soft rows as a share of their inverse mass.
void weigh(ContactConstraint& constraint,
           const SolverBody& a,
           const SolverBody& b,
           const Lanes& gives) {
    const LaneMask used_lanes = first_lanes(constraint.count);
    const LaneVec3 gain_a = times(a.inverse_inertia, constraint.angular_a);
    const LaneVec3 gain_b = times(b.inverse_inertia, constraint.angular_b);
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
        constraint.response[row] = used ? (used_lanes ? splat(linear) + of_a + of_b : own) : own;
        constraint.compliance[i] = constraint.response[row][i] * gives[i];
        soft_matrix[row] = rigid_matrix[row] = constraint.response[row];
        soft_matrix[row][i] += constraint.compliance[i];
        rigid_matrix[row][i] *= 1 + kRedundancy * Real(constraint.count > 1);
    }
    constraint.soft_mass = inverse_of(soft_matrix, constraint.count);
    constraint.rigid_mass = inverse_of(rigid_matrix, constraint.count);
    if (constraint.friction > 0) weigh_friction(constraint, a, b);
}

}  // namespace

void prepare(ContactConstraint& constraint,
             const SolverBody& a,
             const SolverBody& b,
             const Softness& soft,
             Real sharing) {
    constraint.start_normal = constraint.normal;
    constraint.against_immovable = !a.movable() || !b.movable();
    constraint.jointed = a.jointed || b.jointed;
    const LaneMask used_lanes = first_lanes(constraint.count);
    const Vec3 below = constraint.normal * constraint.radius_a;
    const Vec3 above = constraint.normal * constraint.radius_b;
    constraint.angular_a = cross_lanes(moved_by(constraint.offset_a, -below), constraint.normal);
    constraint.angular_b = cross_lanes(moved_by(constraint.offset_b, above), constraint.normal);
    for (LaneVec3* angular : {&constraint.angular_a, &constraint.angular_b}) {
        for (Lanes& axis : *angular) axis = used_lanes ? axis : splat(0);
    }
    if (constraint.friction > 0) place_friction(constraint);
    // share = A / (A + compliance) turns softness into the compliance of the row.
    weigh(constraint, a, b, splat(sharing * soft.decay / std::max(soft.mass_share, 1e-6_r)));
}

void weigh_anew(ContactConstraint& constraint, const SolverBody& a, const SolverBody& b) {
    const LaneMatrix& response = constraint.response;
    const Lanes own{response[0][0], response[1][1], response[2][2], response[3][3]};
    weigh(constraint, a, b, constraint.compliance / own);
}

}  // namespace plumbline::physics
