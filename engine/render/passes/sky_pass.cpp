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

namespace {

void render_image(const FullscreenTriangle& triangle,
                  FeatureSet features,
                  SceneResources& resources,
                  FrameStats& stats) {
    const gl::Program* program = resources.shaders.find(kSkyShader, features);
    if (program == nullptr) return;
    program->use();
    gl::bind_texture(kSkyUnit, gl::TextureKind::Cube, resources.sky.background());
    triangle.draw();
    ++stats.draw_calls;
}

void render_computed(FeatureSet features, SceneResources& resources, FrameStats& stats) {
    const gl::Program* dome = resources.shaders.find(kSkyDomeShader, features);
    const gl::Program* points = resources.shaders.find(kSkyPointShader, features);
    if (dome == nullptr || points == nullptr) return;
    const GpuSkyDome& gpu = resources.sky.dome();
    dome->use();
    if ((features & sky_feature::kClouds) != 0) {
        const ComputedSky& sky = *resources.sky.computed();
        const Vec3f& key = sky.to_cloud_light();
        gl::bind_texture(kSkyUnit, gl::TextureKind::Cube, resources.sky.background());
        glUniform3f(dome->location("cloud_key"), key.x, key.z, sky.model().clouds);
    }
    gpu.draw_dome();
    points->use();
    if ((features & sky_feature::kClouds) != 0)
        glUniform1f(points->location("cloud_share"), resources.sky.computed()->model().clouds);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    gpu.draw_points();
    glDisable(GL_BLEND);
    stats.draw_calls += 2;
}

}  // namespace

void render_sky(const FullscreenTriangle& triangle,
                bool writes_codes,
                SceneResources& resources,
                FrameStats& stats) {
    FeatureSet features = writes_codes ? sky_feature::kCodes : 0;
    glDisable(GL_CULL_FACE);
    glDepthFunc(GL_LEQUAL);
    glDepthMask(GL_FALSE);
    if (resources.sky.computed() != nullptr) {
        if (resources.sky.background()) features |= sky_feature::kClouds;
        render_computed(features, resources, stats);
    } else {
        if (resources.sky.is_srgb()) features |= sky_feature::kSkyCodes;
        render_image(triangle, features, resources, stats);
    }
    glDepthMask(GL_TRUE);
}

}  // namespace plumbline::render
