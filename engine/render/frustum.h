// What is in sight.
#pragma once

#include "engine/core/bounds.h"
#include "engine/core/math.h"

#include <array>

namespace plumbline::render {

/// Six planes, inside positive. Taken from a matrix whose clip volume is OpenGL's (-w to w).
class Frustum {
public:
    explicit Frustum(const Mat4f& clip_from_world);

    /// False only if the box is certainly outside; a box near a corner may be kept in vain.
    bool may_touch(const Aabb& box_world) const;

private:
    std::array<Vec4f, 6> planes_world_;
};

}  // namespace plumbline::render
