#include "engine/render/passes/sky_pass.h"

#include "engine/render/shader_blocks.h"

#include <glad/gl.h>

namespace plumbline::render {

void FullscreenTriangle::draw() const {
    glBindVertexArray(vertex_array_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

namespace {

void render_image(FeatureSet features, PassContext context) {
    const gl::Program* program = context.program(kSkyShader, features);
    if (program == nullptr) return;
    program->use();
    gl::bind_texture(kSkyUnit, context.resources.sky.background());
    context.draw_triangle();
}

void render_computed(FeatureSet features, PassContext context) {
    const gl::Program* dome = context.program(kSkyDomeShader, features);
    const gl::Program* points = context.program(kSkyPointShader, features);
    if (dome == nullptr || points == nullptr) return;
    const GpuSky& all = context.resources.sky;
    const GpuSkyDome& gpu = all.dome();
    const ComputedSky& sky = *all.computed();
    dome->use();
    if ((features & sky_feature::kClouds) != 0) {
        const Vec3f& key = sky.to_cloud_light();
        gl::bind_texture(kSkyUnit, all.background());
        glUniform3f(dome->location("cloud_key"), key.x, key.z, sky.model().clouds);
    }
    gpu.draw_dome();
    points->use();
    if ((features & sky_feature::kClouds) != 0)
        glUniform1f(points->location("cloud_share"), sky.model().clouds);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    gpu.draw_points();
    glDisable(GL_BLEND);
    context.stats.draw_calls += 2;
}

}  // namespace

void render_sky(bool writes_codes, PassContext context) {
    const GpuSky& sky = context.resources.sky;
    FeatureSet features = sky_feature::kCodes.when(writes_codes);
    glDisable(GL_CULL_FACE);
    glDepthFunc(GL_LEQUAL);
    glDepthMask(GL_FALSE);
    if (sky.computed() != nullptr) {
        if (sky.background()) features |= sky_feature::kClouds;
        render_computed(features, context);
    } else {
        if (sky.is_srgb()) features |= sky_feature::kSkyCodes;
        render_image(features, context);
    }
    glDepthMask(GL_TRUE);
}

}  // namespace plumbline::render
