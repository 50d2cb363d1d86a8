#include "engine/render/passes/scene_light.h"

#include "engine/render/shader_blocks.h"

#include <glad/gl.h>

namespace plumbline::render {

void bind_scene_light(const SceneLight& light, const gl::Program& program) {
    if (light.features == 0) return;
    gl::bind_texture(kDepthUnit, *light.depth);
    if (light.occlusion != nullptr) gl::bind_texture(kOcclusionUnit, *light.occlusion);
    if (light.shafts != nullptr) gl::bind_texture(kShaftsUnit, *light.shafts);
    glUniform2f(program.location("depth_line"), light.depth_line.x, light.depth_line.y);
}

}  // namespace plumbline::render
