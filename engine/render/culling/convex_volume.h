// A part of the world that light or shadow may reach: what lies outside is drawn without the shader
// code for it. Pure arithmetic.
#pragma once

#include "engine/core/bounds.h"
#include "engine/core/math.h"

#include <vector>

namespace plumbline::render {

/// A part of the image; x and y from -1 to 1. Empty: left above right.
struct ClipRect {
    Vec2f min{1.0F};
    Vec2f max{-1.0F};

    bool empty() const { return min.x >= max.x || min.y >= max.y; }
    /// Of the image's area, 0…1.
    float share() const { return empty() ? 0.0F : (max.x - min.x) * (max.y - min.y) * 0.25F; }
};

ClipRect intersection(const ClipRect& a, const ClipRect& b);

/// The smallest part of the image that shows all of the box before the camera's near plane.
ClipRect part_seen(const Aabb& box_world, const Mat4f& clip_from_world);

class ConvexVolume {
public:
    /// A spot light's: an eight-sided pyramid around the cone. The direction is unit. Wider than 80
    /// degrees from its axis, the volume is everywhere.
    static ConvexVolume cone(const Vec3f& position_world,
                             const Vec3f& direction_world,
                             float half_angle_rad,
                             float radius_m);
    /// A box whose third axis goes along the unit direction: from min to max in the coordinates of
    /// axes_along(direction).
    static ConvexVolume prism(const Vec3f& direction_world, const Aabb& along);

    /// False only if no point of the box lies in it.
    bool reaches(const Aabb& box_world) const;
    /// The smallest part of the image that shows all places that lie both in the box and in the
    /// volume, before the camera's near plane.
    ClipRect part_seen(const Aabb& box_world, const Mat4f& clip_from_world) const;

private:
    using Polygon = std::vector<Vec3f>;

    bool is_everywhere_{false};
    std::vector<Vec4f> planes_world_;  ///< inside positive
    std::vector<Polygon> faces_world_;
};

/// Three axes at right angles, the third along the unit direction: a row each.
Mat3f axes_along(const Vec3f& direction_world);

}  // namespace plumbline::render
