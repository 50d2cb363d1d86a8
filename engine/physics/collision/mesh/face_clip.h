// The part of a flat polygon that lies over a triangle.
#pragma once

#include "engine/core/math.h"

#include <array>
#include <cstdint>
#include <span>

namespace plumbline::physics {

struct ClippedPolygon {
    static constexpr std::size_t kMost = 72;

    std::array<Vec3d, kMost> corners;
    /// Which of the triangle's edges cut the corner: bit i for that from corner i to the next. 0: one of the
    /// polygon's own.
    std::array<std::uint8_t, kMost> cuts;
    std::size_t count{0};

    void add(const Vec3d& corner, unsigned cut_by) {
        if (count == kMost) return;
        corners[count] = corner;
        cuts[count++] = static_cast<std::uint8_t>(cut_by);
    }
};

/// The triangle is counter-clockwise round the unit `normal`, along which the polygon is seen; a polygon of two
/// corners is a line. Corners within `touching_m` of the triangle lie over it (Sutherland and Hodgman 1974).
void clip_to_triangle(std::span<const Vec3d> polygon,
                      const std::array<Vec3d, 3>& triangle,
                      const Vec3d& normal,
                      double touching_m,
                      ClippedPolygon& clipped);

}  // namespace plumbline::physics
