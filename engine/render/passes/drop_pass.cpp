#include "engine/render/passes/drop_pass.h"

#include <glad/gl.h>

#include <cmath>
#include <cstddef>

namespace plumbline::render {
void DropPass::render(const FrameSetup& setup, SceneResources& resources, FrameStats& stats) {
    const RenderFrame& frame = *setup.frame;
    const gl::Program* program = resources.shaders.find(kDropShader, 0);
    if (program == nullptr) return;
    if (!vertex_array_) {
        GLuint name = 0;
        glGenVertexArrays(1, &name);
        vertex_array_ = gl::VertexArrayObject{name};
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
    for (const GLuint location : {0U, 1U}) {
        glEnableVertexAttribArray(location);
        glVertexAttribPointer(location,
                              4,
                              GL_FLOAT,
                              GL_FALSE,
                              sizeof(Instance),
                              reinterpret_cast<const void*>(location * sizeof(Vec4f)));
        glVertexAttribDivisor(location, 1);
    }
    program->use();
    glUniform1f(program->location("pixel_rad"),
                2.0F * std::tan(frame.camera.fov_y_rad * 0.5F) /
                    static_cast<float>(setup.image.scene_px.height));
    glDisable(GL_CULL_FACE);
    const auto count = static_cast<GLsizei>(filled_.size());
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count);
    ++stats.draw_calls;
    stats.instances += static_cast<std::uint32_t>(count);
    stats.triangles += 2 * static_cast<std::uint64_t>(count);
}

void DropPass::free() {
    vertex_array_ = {};
    instances_ = {};
}

}  // namespace plumbline::render
