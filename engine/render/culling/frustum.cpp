#include "engine/render/culling/frustum.h"

namespace plumbline::render {

Frustum::Frustum(const Mat4f& clip_from_world) {
    const Mat4f rows = glm::transpose(clip_from_world);
    for (int axis = 0; axis < 3; ++axis) {
        planes_world_[static_cast<std::size_t>(axis) * 2] = rows[3] + rows[axis];
        planes_world_[static_cast<std::size_t>(axis) * 2 + 1] = rows[3] - rows[axis];
    }
}

bool may_touch(std::span<const Vec4f> planes_world, const Aabb& box_world) {
    if (box_world.empty()) return false;
    for (const Vec4f& plane : planes_world) {
        const Vec3f normal{plane};
        const Vec3f farthest_inside{normal.x >= 0.0F ? box_world.max.x : box_world.min.x,
                                    normal.y >= 0.0F ? box_world.max.y : box_world.min.y,
                                    normal.z >= 0.0F ? box_world.max.z : box_world.min.z};
        if (glm::dot(normal, farthest_inside) + plane.w < 0.0F) return false;
    }
    return true;
}

}  // namespace plumbline::render
