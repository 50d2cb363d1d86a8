// Small dense algebra of the joint solver: 3x3 blocks in double precision.
#pragma once

#include "engine/core/math.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

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

inline double& diagonal(Symmetric3& s, int i) {
    return i == 0 ? s.xx : i == 1 ? s.yy : s.zz;
}

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

/// A positive matrix as L D L^T: L below its unit diagonal, and the reciprocals of D.
struct Factored3 {
    double l10{0}, l20{0}, l21{0};
    double p0{1}, p1{1}, p2{1};
    bool cancelled{false};  ///< a row is almost a combination of those before it

    /// The inverse of the whole matrix. Where a row `cancelled`, its digits are lost: substitute.
    Symmetric3 inverse() const {
        const double m20 = l10 * l21 - l20;  // of the inverse of L
        const double m20p = m20 * p2;
        const double l21p = -l21 * p2;
        return {p0 + l10 * l10 * p1 + m20 * m20p,
                -l10 * p1 + l21p * m20,
                m20p,
                p1 - l21 * l21p,
                l21p,
                p2};
    }
    /// The inverse times v by substitution. Its rounding errors lie along the vectors that the
    /// matrix takes to almost nothing, so the product with the matrix keeps all digits.
    Vec3d substitute(const Vec3d& v) const {
        const double y = v.y - l10 * v.x;
        const double z = (v.z - l20 * v.x - l21 * y) * p2;
        const double middle = y * p1 - l21 * z;
        return {v.x * p0 - l10 * middle - l20 * z, middle, z};
    }
};

/// Factors a positive matrix. A pivot below `floor` counts as `floor`.
inline Factored3 factored(const Symmetric3& a, double floor) {
    constexpr double kCancelled = 1e-5;  // of its diagonal is left of a row
    Factored3 f;
    f.p0 = 1 / std::max(a.xx, floor);
    f.l10 = a.xy * f.p0;
    f.l20 = a.xz * f.p0;
    const double second = a.yy - f.l10 * a.xy;
    f.p1 = 1 / std::max(second, floor);
    const double below = a.yz - f.l10 * a.xz;
    f.l21 = below * f.p1;
    const double third = a.zz - f.l20 * a.xz - f.l21 * below;
    f.p2 = 1 / std::max(third, floor);
    f.cancelled = second < kCancelled * a.yy || third < kCancelled * a.zz;
    return f;
}

/// Zero but for the components whose bits are set.
inline Vec3d masked(const Vec3d& v, std::uint8_t active) {
    if (active == 0b111) return v;
    return {(active & 1) != 0 ? v.x : 0, (active & 2) != 0 ? v.y : 0, (active & 4) != 0 ? v.z : 0};
}

/// The same of rows and columns.
inline void mask(Block3& block, std::uint8_t rows, std::uint8_t columns) {
    for (std::size_t i = 0; i < 3; ++i) {
        block.row[i] = ((rows >> i) & 1) != 0 ? masked(block.row[i], columns) : Vec3d{0, 0, 0};
    }
}

/// Rows that are not active, or that move nothing, get a one of their own.
inline void mask(Symmetric3& s, std::uint8_t active) {
    if ((active & 1) == 0 || !(s.xx > 0)) s.xx = 1, s.xy = 0, s.xz = 0;
    if ((active & 2) == 0 || !(s.yy > 0)) s.yy = 1, s.xy = 0, s.yz = 0;
    if ((active & 4) == 0 || !(s.zz > 0)) s.zz = 1, s.xz = 0, s.yz = 0;
}

}  // namespace plumbline::physics
