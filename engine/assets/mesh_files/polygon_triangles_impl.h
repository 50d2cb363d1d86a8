// Polygons of files to triangles. Private to engine/assets.
#pragma once

#include "engine/core/math.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace plumbline::assets {

/// More corners are not read: the time grows with the square of them.
inline constexpr std::size_t kMostCorners = 256;

/// Triangles of a polygon by the numbers of its corners, wound as it is; it may be bent a little and
/// need not be convex. Two fewer than corners, always: what is crossed or flat gives what it gives.
std::vector<std::array<std::uint32_t, 3>> triangles_of(std::span<const Vec3f> polygon);

}  // namespace plumbline::assets
