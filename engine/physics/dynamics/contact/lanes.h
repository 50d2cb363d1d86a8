// Four numbers side by side in a vector register (in float64: in two). Arithmetic and comparisons act on each, as the vector
// extension of g++ and clang defines them: the same bits as four numbers one after another.
#pragma once

#include "engine/core/math.h"

#include <array>
#include <cstddef>

namespace plumbline::physics {

inline constexpr int kLanes = 4;
using Lanes [[gnu::vector_size(kLanes * sizeof(Real))]] = Real;
using LaneMask = decltype(Lanes{} < Lanes{});  ///< of each: all bits set, or none
using LaneVec3 = std::array<Lanes, 3>;         ///< x of all lanes, y of all lanes, z of all lanes
using LaneMatrix = std::array<Lanes, kLanes>;

inline Lanes splat(Real value) {
    return Lanes{value, value, value, value};
}

inline bool any(LaneMask mask) {
    const LaneMask pairs = mask | __builtin_shufflevector(mask, mask, 2, 3, 0, 1);
    return (pairs[0] | pairs[1]) != 0;
}

/// The lanes before `count`, 0 to 4.
inline LaneMask first_lanes(int count) {
    return Lanes{0, 1, 2, 3} < splat(static_cast<Real>(count));
}

inline Vec3 lane(const LaneVec3& vectors, int i) {
    return {vectors[0][i], vectors[1][i], vectors[2][i]};
}
inline void set_lane(LaneVec3& vectors, int i, const Vec3& value) {
    for (std::size_t axis = 0; axis < 3; ++axis) vectors[axis][i] = value[static_cast<int>(axis)];
}
inline Real sum_of(Lanes values) {
    return (values[0] + values[1]) + (values[2] + values[3]);
}

/// sum over axes of direction[axis] * lanes[axis]
inline Lanes dot_lanes(const Vec3& direction, const LaneVec3& vectors) {
    return splat(direction.x) * vectors[0] + splat(direction.y) * vectors[1] +
           splat(direction.z) * vectors[2];
}

/// Of each axis as sum_of() adds.
inline Vec3 weighted_sum(const LaneVec3& vectors, Lanes weights) {
    const Lanes x = vectors[0] * weights;
    const Lanes y = vectors[1] * weights;
    const Lanes z = vectors[2] * weights;
    const Lanes pairs_xy =
        __builtin_shufflevector(x, y, 0, 4, 2, 6) + __builtin_shufflevector(x, y, 1, 5, 3, 7);
    const Lanes pairs_z =
        __builtin_shufflevector(z, z, 0, 0, 2, 2) + __builtin_shufflevector(z, z, 1, 1, 3, 3);
    const Lanes sums = __builtin_shufflevector(pairs_xy, pairs_z, 0, 1, 4, 5) +
                       __builtin_shufflevector(pairs_xy, pairs_z, 2, 3, 6, 7);
    return {sums[0], sums[1], sums[2]};
}

/// As glm::cross() of each.
inline LaneVec3 cross_lanes(const LaneVec3& vectors, const Vec3& with) {
    return {vectors[1] * splat(with.z) - splat(with.y) * vectors[2],
            vectors[2] * splat(with.x) - splat(with.z) * vectors[0],
            vectors[0] * splat(with.y) - splat(with.x) * vectors[1]};
}

/// Each turned by `q`, a unit quaternion.
inline LaneVec3 turned(const Quat& q, const LaneVec3& vectors) {
    const glm::mat<3, 3, Real> columns = glm::mat3_cast(q);
    LaneVec3 result;
    for (int axis = 0; axis < 3; ++axis) {
        const Vec3 row{columns[0][axis], columns[1][axis], columns[2][axis]};
        result[static_cast<std::size_t>(axis)] = dot_lanes(row, vectors);
    }
    return result;
}

}  // namespace plumbline::physics
