#include "engine/render/passes/sky_pass.h"

#include "engine/render/shader_blocks.h"

#include <glad/gl.h>

namespace plumbline::render {

FullscreenTriangle::FullscreenTriangle() {
    GLuint name = 0;
    glGenVertexArrays(1, &name);
    vertex_array_ = gl::VertexArrayObject{name};
}

void FullscreenTriangle::draw() const {
    glBindVertexArray(vertex_array_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void render_sky(const FullscreenTriangle& triangle,
                FeatureSet frame_features,
                SceneResources& resources,
                FrameStats& stats) {
    FeatureSet features = frame_features & feature::kFog;
    if (resources.sky.is_srgb()) features |= feature::kSkyCodes;
    const gl::Program* program = resources.shaders.find(kSkyShader, features);
    if (program == nullptr) return;
    program->use();
    gl::bind_texture(kSkyUnit, gl::TextureKind::Cube, resources.sky.background());
    glDisable(GL_CULL_FACE);
    glDepthFunc(GL_LEQUAL);
    glDepthMask(GL_FALSE);
    triangle.draw();
    glDepthMask(GL_TRUE);
    ++stats.draw_calls;
}

}  // namespace plumbline::render
