#include "engine/render/passes/drop_pass.h"

#include <glad/gl.h>

#include <cmath>
#include <cstddef>

namespace plumbline::render {
void DropPass::render(const FrameSetup& setup, PassContext context) {
    const RenderFrame& frame = *setup.frame;
    const gl::Program* program = context.program(kDropShader);
    if (program == nullptr) return;
    if (!vertex_array_) {
        vertex_array_ = gl::new_vertex_array();
        instances_ = gl::Buffer{gl::BufferUse::Vertices, gl::BufferLife::PerFrame};
    }
    filled_.clear();
    for (const WaterRingMark& ring : frame.water_rings)
        filled_.push_back(
            {Vec4f{ring.center_world, -ring.radius_m}, Vec4f{Vec3f{0.0F}, ring.opacity}});
    for (const DropStreak& drop : frame.drops)
        filled_.push_back(
            {Vec4f{drop.position_world, drop.radius_m}, Vec4f{drop.trail_m, drop.opacity}});
    instances_.upload(filled_.data(), filled_.size() * sizeof(Instance));

    glBindVertexArray(vertex_array_.name());
    gl::float_attribute(0, 4, sizeof(Instance), offsetof(Instance, place), 1);
    gl::float_attribute(1, 4, sizeof(Instance), offsetof(Instance, trail), 1);
    program->use();
    glUniform1f(program->location("pixel_rad"),
                2.0F * std::tan(frame.camera.fov_y_rad * 0.5F) /
                    static_cast<float>(setup.image.scene_px.height));
    glDisable(GL_CULL_FACE);
    const auto count = static_cast<GLsizei>(filled_.size());
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count);
    ++context.stats.draw_calls;
    context.stats.instances += static_cast<std::uint32_t>(count);
    context.stats.triangles += 2 * static_cast<std::uint64_t>(count);
}

void DropPass::free() {
    vertex_array_ = {};
    instances_ = {};
}

}  // namespace plumbline::render
