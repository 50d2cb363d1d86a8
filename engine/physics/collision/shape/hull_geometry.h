// A convex hull's corners, faces and edges, made once when its shape is made.
#pragma once

#include "engine/core/math.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace plumbline::physics {

/// A flat face: its plane, and its corners counter-clockwise from outside.
struct HullFace {
    Vec3d normal{0, 1, 0};  ///< unit, outward
    double offset_m{0};     ///< of the plane along the normal: that of the hull's farthest corner
    std::uint32_t first{0};
    std::uint32_t count{0};  ///< of HullGeometry::face_corners
};

struct HullGeometry {
    std::vector<Vec3d> corners_m;
    std::vector<HullFace> faces;
    std::vector<std::uint32_t> face_corners;
    /// The corners next to corner i: `neighbours[first_neighbour[i]]` up to `first_neighbour[i + 1]`.
    std::vector<std::uint32_t> neighbours;
    std::vector<std::uint32_t> first_neighbour;
    double width_m{0};  ///< the least extent along a face's normal

    std::span<const std::uint32_t> corners_of(const HullFace& face) const {
        return std::span(face_corners).subspan(face.first, face.count);
    }
};

/// Triangles that lie within this angle of each other, and within kFaceSag of the hull's extent of one
/// plane, are one face.
inline constexpr double kSameFace_rad = 0.003;
inline constexpr double kFaceSag = 1e-4;

/// From a closed convex surface of triangles, counter-clockwise from outside.
HullGeometry hull_geometry(std::span<const Vec3d> corners_m,
                           std::span<const std::array<std::uint32_t, 3>> triangles);

}  // namespace plumbline::physics
