#include "engine/render/resources/samplers.h"

#include "engine/render/shader_blocks.h"

#include <glad/gl.h>

#include <cmath>

namespace plumbline::render {
namespace {

gl::SamplerObject new_sampler(GLint min_filter, GLint mag_filter, GLint wrap) {
    GLuint name = 0;
    glGenSamplers(1, &name);
    glSamplerParameteri(name, GL_TEXTURE_MIN_FILTER, min_filter);
    glSamplerParameteri(name, GL_TEXTURE_MAG_FILTER, mag_filter);
    glSamplerParameteri(name, GL_TEXTURE_WRAP_S, wrap);
    glSamplerParameteri(name, GL_TEXTURE_WRAP_T, wrap);
    return gl::SamplerObject{name};
}

}  // namespace

void Samplers::bind_sun_depth(const gl::Texture* map) {
    if (map == nullptr) {
        if (depth_) glBindSampler(kSunDepthUnit, 0);
        depth_ = {};
        return;
    }
    if (!depth_) depth_ = new_sampler(GL_NEAREST, GL_NEAREST, GL_CLAMP_TO_EDGE);
    glBindSampler(kSunDepthUnit, depth_.name());
    gl::bind_texture(kSunDepthUnit, *map);
}

void Samplers::bind_base(float share) {
    if (share >= 1.0F) return;
    if (!base_) base_ = new_sampler(GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, GL_REPEAT);
    glSamplerParameterf(base_.name(), GL_TEXTURE_LOD_BIAS, std::log2(share));
    glBindSampler(kBaseColorUnit, base_.name());
}

void Samplers::unbind_base() {
    glBindSampler(kBaseColorUnit, 0);
}

}  // namespace plumbline::render
