// Small dense algebra of the joint solver: 3x3 blocks in double precision.
#pragma once

#include "engine/core/math.h"

#include <array>

namespace plumbline::physics {

/// A symmetric 3x3 matrix by its six numbers.
struct Symmetric3 {
    double xx{0}, xy{0}, xz{0}, yy{0}, yz{0}, zz{0};

    Vec3d operator*(const Vec3d& v) const {
        return {xx * v.x + xy * v.y + xz * v.z,
                xy * v.x + yy * v.y + yz * v.z,
                xz * v.x + yz * v.y + zz * v.z};
    }
};

/// A 3x3 matrix by its rows.
struct Block3 {
    std::array<Vec3d, 3> row{};

    Vec3d operator*(const Vec3d& v) const {
        return {glm::dot(row[0], v), glm::dot(row[1], v), glm::dot(row[2], v)};
    }
    /// The transposed matrix times v.
    Vec3d transposed_times(const Vec3d& v) const {
        return row[0] * v.x + row[1] * v.y + row[2] * v.z;
    }
};

inline Block3 operator*(const Block3& a, const Symmetric3& s) {
    return {{s * a.row[0], s * a.row[1], s * a.row[2]}};
}

/// a times b transposed.
inline Block3 times_transposed(const Block3& a, const Block3& b) {
    return {{b * a.row[0], b * a.row[1], b * a.row[2]}};
}

inline void subtract(Block3& from, const Block3& what) {
    for (std::size_t i = 0; i < 3; ++i) from.row[i] -= what.row[i];
}

inline void add(Block3& to, const Block3& what) {
    for (std::size_t i = 0; i < 3; ++i) to.row[i] += what.row[i];
}

/// The rotation matrix of a unit quaternion, by rows.
inline Block3 rows_of(const Quatd& q) {
    const double xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z;
    const double xy = q.x * q.y, xz = q.x * q.z, yz = q.y * q.z;
    const double wx = q.w * q.x, wy = q.w * q.y, wz = q.w * q.z;
    return {{Vec3d{1 - 2 * (yy + zz), 2 * (xy - wz), 2 * (xz + wy)},
             Vec3d{2 * (xy + wz), 1 - 2 * (xx + zz), 2 * (yz - wx)},
             Vec3d{2 * (xz - wy), 2 * (yz + wx), 1 - 2 * (xx + yy)}}};
}

/// A diagonal matrix given in a body's axes, in world axes.
inline Symmetric3 in_world(const Vec3d& diagonal, const Block3& world_from_body) {
    const auto& r = world_from_body.row;
    const Vec3d x = r[0] * diagonal;
    const Vec3d y = r[1] * diagonal;
    const Vec3d z = r[2] * diagonal;
    return {glm::dot(x, r[0]),
            glm::dot(x, r[1]),
            glm::dot(x, r[2]),
            glm::dot(y, r[1]),
            glm::dot(y, r[2]),
            glm::dot(z, r[2])};
}

/// The rotation by a small turn, exact to 1e-13 up to a tenth of a radian; larger ones are exact.
inline Quatd small_turn(const Vec3d& turn_rad) {
    const double square = 0.25 * glm::dot(turn_rad, turn_rad);
    double cosine = 1 - square / 2 * (1 - square / 12 * (1 - square / 30));
    double sine_by_angle = 0.5 * (1 - square / 6 * (1 - square / 20 * (1 - square / 42)));
    if (square > 0.0025) {
        const double half = std::sqrt(square);
        cosine = portable_cos(half);
        sine_by_angle = 0.5 * portable_sin(half) / half;
    }
    return {cosine, turn_rad * sine_by_angle};
}

/// The inverse of a positive matrix by L D L^T. A pivot below `floor` counts as `floor`.
inline Symmetric3 inverse_of(const Symmetric3& a, double floor) {
    const double p0 = 1 / std::max(a.xx, floor);
    const double l10 = a.xy * p0;
    const double l20 = a.xz * p0;
    const double p1 = 1 / std::max(a.yy - l10 * a.xy, floor);
    const double below = a.yz - l10 * a.xz;
    const double l21 = below * p1;
    const double p2 = 1 / std::max(a.zz - l20 * a.xz - l21 * below, floor);
    // The inverse of L has -l10, -l21 and this below its diagonal.
    const double m20 = l10 * l21 - l20;
    const double m20p = m20 * p2;
    const double l21p = -l21 * p2;
    return {
        p0 + l10 * l10 * p1 + m20 * m20p, -l10 * p1 + l21p * m20, m20p, p1 - l21 * l21p, l21p, p2};
}

}  // namespace plumbline::physics
