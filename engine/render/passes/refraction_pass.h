// What was drawn before the water, for the water to show.
#pragma once

#include "engine/core/bounds.h"
#include "engine/render/passes/scene_target.h"

#include <cstddef>

namespace plumbline::render {

/// Pixels from the lower left corner; `last` is within.
struct PixelPart {
    Vec2f first{0.0F};
    Vec2f last{0.0F};
};

class RefractionPass {
public:
    /// Copies light and depth of the scene where it shows the box. False: the driver has no memory.
    bool copy(const SceneTarget& scene, const Aabb& box_world, const Mat4f& clip_from_world);
    /// Bound to the units of the scene's image and its depth.
    void bind() const;
    const PixelPart& part() const { return part_; }
    std::size_t bytes() const { return behind_.bytes(); }
    void free() { *this = {}; }

private:
    SceneTarget behind_;
    PixelPart part_;
};

}  // namespace plumbline::render
