// How textures are read where that is not how they were made.
#pragma once

#include "engine/render/gl/object.h"
#include "engine/render/gl/texture.h"

namespace plumbline::render {

class Samplers {
public:
    /// The sun's shadow map as depths that are read, not compared; null frees the sampler.
    void bind_sun_depth(const gl::Texture* map);
    /// Base colours as sharp as the finished image shows them, whose height the scene's image has that
    /// share of. 1: as they were made.
    void bind_base(float share);
    static void unbind_base();

private:
    gl::SamplerObject depth_;
    gl::SamplerObject base_;
};

}  // namespace plumbline::render
