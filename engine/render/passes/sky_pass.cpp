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
