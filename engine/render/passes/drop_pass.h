// Water in the air and the rings that it raises: one draw of quads, blended over the finished scene.
#pragma once

#include "engine/render/gl/buffer.h"
#include "engine/render/gl/object.h"
#include "engine/render/passes/pass_context.h"
#include "engine/render/setup/frame_setup.h"

#include <vector>

namespace plumbline::render {

class DropPass {
public:
    static bool has_work(const RenderFrame& frame) {
        return !frame.drops.empty() || !frame.water_rings.empty();
    }

    /// Blending is on, depth is read only.
    void render(const FrameSetup& setup, PassContext context);
    void free();
    std::uint64_t bytes() const { return instances_.size(); }

private:
    struct Instance {
        Vec4f place;  ///< w: radius; below 0: a ring
        Vec4f trail;  ///< w: opacity
    };

    gl::VertexArrayObject vertex_array_;
    gl::Buffer instances_;
    std::vector<Instance> filled_;
};

}  // namespace plumbline::render
