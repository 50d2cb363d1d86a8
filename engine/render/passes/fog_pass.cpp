#include "engine/render/passes/fog_pass.h"

#include "engine/render/shader_blocks.h"

#include <glad/gl.h>

namespace plumbline::render {

void render_fog(const FrameSetup& setup, SceneTarget& scene, PassContext context) {
    const gl::Program* program = context.program(kFogShader);
    if (program == nullptr) return;
    const bool has_sky = setup.frame->sky && context.resources.sky.ready();
    scene.bind_light();
    program->use();
    gl::bind_texture(kDepthUnit, scene.depth());
    const Vec2f& depth_line = setup.screen.depth_line;
    glUniform2f(program->location("depth_line"), depth_line.x, depth_line.y);
    glUniform1f(program->location("has_sky"), has_sky ? 1.0F : 0.0F);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    // Alpha, the share of the light that can be occluded, shrinks as the light does.
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE_MINUS_SRC_ALPHA);
    context.draw_triangle();
    glDisable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
    scene.bind();
}

}  // namespace plumbline::render
