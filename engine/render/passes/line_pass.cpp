#include "engine/render/passes/line_pass.h"

#include <glad/gl.h>

#include <cstddef>

namespace plumbline::render {
namespace {

constexpr float kHiddenOpacity = 0.2F;

}  // namespace

void LinePass::render(const LineList& lines, PassContext context) {
    const gl::Program* program = context.program(kLineShader);
    if (program == nullptr || lines.vertices.empty()) return;
    if (!vertex_array_) {
        vertex_array_ = gl::new_vertex_array();
        vertices_ = gl::Buffer{gl::BufferUse::Vertices, gl::BufferLife::PerFrame};
    }
    vertices_.upload(lines.vertices.data(), lines.vertices.size() * sizeof(LineVertex));
    glBindVertexArray(vertex_array_.name());
    gl::float_attribute(0, 3, sizeof(LineVertex), 0);
    gl::float_attribute(1, 3, sizeof(LineVertex), offsetof(LineVertex, color));
    program->use();
    const auto count = static_cast<GLsizei>(lines.vertices.size());
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDepthFunc(GL_GREATER);
    glUniform1f(program->location("opacity"), kHiddenOpacity);
    glDrawArrays(GL_LINES, 0, count);
    glDisable(GL_BLEND);
    glDepthFunc(GL_LEQUAL);
    glUniform1f(program->location("opacity"), 1.0F);
    glDrawArrays(GL_LINES, 0, count);
    glDepthMask(GL_TRUE);
    context.stats.draw_calls += 2;
}

}  // namespace plumbline::render
