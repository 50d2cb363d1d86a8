// What is in sight.
#pragma once

#include "engine/core/bounds.h"
#include "engine/core/math.h"

#include <array>
#include <span>

namespace plumbline::render {

/// False only if the box is certainly outside the planes, inside positive; a box near a corner may be
/// kept in vain.
bool may_touch(std::span<const Vec4f> planes_world, const Aabb& box_world);

/// Whether the lines of sight are parallel: all has the same size in the image, however far.
inline bool is_parallel(const Mat4f& clip_from_world) {
    return Vec3f{clip_from_world[0][3], clip_from_world[1][3], clip_from_world[2][3]} ==
           Vec3f{0.0F};
}

/// Six planes, inside positive. Taken from a matrix whose clip volume is OpenGL's (-w to w).
class Frustum {
public:
    explicit Frustum(const Mat4f& clip_from_world);

    bool may_touch(const Aabb& box_world) const {
        return render::may_touch(planes_world_, box_world);
    }

private:
    std::array<Vec4f, 6> planes_world_;
};

}  // namespace plumbline::render
