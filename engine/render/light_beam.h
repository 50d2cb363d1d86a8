// Where a spot light can reach: what lies outside is drawn without its shader code. Pure arithmetic.
#pragma once

#include "engine/core/bounds.h"
#include "engine/core/math.h"

#include <array>
#include <vector>

namespace plumbline::render {

/// A part of the picture; x and y from -1 to 1. Empty: left above right.
struct ClipRect {
    Vec2f min{1.0F};
    Vec2f max{-1.0F};

    bool empty() const { return min.x >= max.x || min.y >= max.y; }
    /// Of the picture's area, 0…1.
    float share() const { return empty() ? 0.0F : (max.x - min.x) * (max.y - min.y) * 0.25F; }
};

/// A cone from a point, as an eight-sided pyramid around it.
class LightBeam {
public:
    /// The direction is unit. A beam wider than 80 degrees from its axis reaches everything.
    LightBeam(const Vec3f& position_world,
              const Vec3f& direction_world,
              float half_angle_rad,
              float radius_m);

    /// False only if nothing in the box is certainly lit.
    bool reaches(const Aabb& box_world) const;
    /// The smallest part of the picture that shows all places that lie both in the box and in the
    /// beam, before the camera's near plane.
    ClipRect lit_part(const Aabb& box_world, const Mat4f& clip_from_world) const;

private:
    static constexpr std::size_t kSides = 8;
    using Polygon = std::vector<Vec3f>;

    bool is_everywhere_;
    std::array<Vec4f, kSides + 1> planes_world_{};  ///< inside positive; the last is the far end
    std::array<Polygon, kSides + 1> faces_world_;
};

}  // namespace plumbline::render
