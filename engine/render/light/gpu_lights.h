// The frame's local lights and their bits by cluster, as the shaders read them.
#pragma once

#include "engine/render/gl/buffer.h"
#include "engine/render/gl/object.h"
#include "engine/render/light/light_clusters.h"

#include <span>

namespace plumbline::render {

class GpuLights {
public:
    /// Uploads the first PL_MAX_LIGHTS lights and makes them what the next draws read.
    /// `shadows`: LocalLightEntry::shadow of the first ones.
    void upload(std::span<const LocalLight> lights,
                std::span<const Vec4f> shadows,
                const ClusterView& view);
    /// For frames without lights.
    void free();

private:
    gl::Buffer lights_;
    gl::Buffer masks_;
    gl::TextureObject masks_texture_;
};

}  // namespace plumbline::render
