// How textures are read where that is not how they were made.
#include "engine/render/renderer_impl.h"

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

void Renderer::Impl::bind_sun_depth() {
    if ((features & feature::kContactHardening) == 0) {
        if (depth_sampler) glBindSampler(kSunDepthUnit, 0);
        depth_sampler = {};
        return;
    }
    if (!depth_sampler) depth_sampler = new_sampler(GL_NEAREST, GL_NEAREST, GL_CLAMP_TO_EDGE);
    glBindSampler(kSunDepthUnit, depth_sampler.name());
    gl::bind_texture(kSunDepthUnit, gl::TextureKind::Flat, sun_shadow.map());
}

void Renderer::Impl::bind_base_sampler() {
    const float share = static_cast<float>(post_view.image_px.height) /
                        static_cast<float>(post_view.present_px.height);
    if (share >= 1.0F) return;
    if (!base_sampler) base_sampler = new_sampler(GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, GL_REPEAT);
    glSamplerParameterf(base_sampler.name(), GL_TEXTURE_LOD_BIAS, std::log2(share));
    glBindSampler(kBaseColorUnit, base_sampler.name());
}

}  // namespace plumbline::render
