// A convex shape as the general narrow phase sees it: in the frame of one call, in double precision.
#pragma once

#include "engine/physics/collision/shape/convex_shape.h"

#include <array>

namespace plumbline::physics {

/// A core and a radius round it: a sphere's core is its centre, a capsule's the segment of its axis.
/// Others are their own core, with a radius of 0.
struct PlacedConvex {
    const ConvexShape* shape{nullptr};  ///< null: a triangle
    glm::dmat3 axes{1.0};               ///< columns, unit
    Vec3d center_m{0, 0, 0};
    double radius_m{0};
    std::array<Vec3d, 3> triangle{};  ///< corners, in the frame of the call
};

/// The frame's axes are the world's, its origin is `origin_world`.
PlacedConvex placed_convex(const PlacedShape& placed, const Vec3d& origin_world);
PlacedConvex placed_triangle(const std::array<Vec3d, 3>& corners_m);

/// The core's point that lies farthest along `direction`, whatever that vector's length.
Vec3d support(const PlacedConvex& convex, const Vec3d& direction);

/// How far `a` lies beyond `b` along the unit `direction`, m; negative: they overlap along it.
double separation_along(const PlacedConvex& a, const PlacedConvex& b, const Vec3d& direction);

/// What of a core touches first along a direction: a flat region in space.
struct Feature {
    /// A disc keeps its axis, and its `corners` are places on its rim.
    enum class Kind : std::uint8_t { Point, Segment, Polygon, Disc };
    static constexpr std::size_t kMostCorners = 64;

    Kind kind{Kind::Point};
    std::size_t count{0};
    std::array<Vec3d, kMostCorners> corners;  ///< of a polygon: round its normal
    Vec3d normal{0, 1, 0};                    ///< of a polygon or a disc, outward
    Vec3d center_m{0, 0, 0};                  ///< of a disc
    double radius_m{0};                       ///< likewise
    double between_m{
        0};  ///< how much deeper than all of its corners a disc's rim may lie between two of them

    void add(const Vec3d& corner) {
        if (count < kMostCorners) corners[count++] = corner;
    }
};

/// The face, cap, line or corner of the core that looks most along the unit `direction`.
void find_feature(const PlacedConvex& convex, const Vec3d& direction, Feature& feature);

/// A flat face's plane: `offset_m` along its outward normal.
struct FacePlane {
    Vec3d normal{0, 1, 0};
    double offset_m{0};
    bool exists{false};
};
/// The flat face that looks most along `direction`; none on spheres, capsules and the sides of cylinders.
FacePlane face_along(const PlacedConvex& convex, const Vec3d& direction);
/// The flat face over which `point` lies highest; none where it lies higher over a round side.
FacePlane face_under(const PlacedConvex& convex, const Vec3d& point);

/// How far the core's points lie apart, at least: what counts as small on it.
double size_of(const PlacedConvex& convex);

}  // namespace plumbline::physics
