// A computed sky on the GPU: a dome whose vertices carry the air's light, clouds before it, and points
// of light: sun, moon, stars.
#pragma once

#include "engine/render/gl/buffer.h"
#include "engine/render/gl/object.h"
#include "engine/render/sky/computed_sky.h"

#include <cstddef>

namespace plumbline::render {

class GpuSkyDome {
public:
    /// Once the sky is other than before.
    void update(const ComputedSky& sky);
    void draw_dome() const;
    void draw_points() const;
    std::size_t bytes() const { return vertices_.size() + indices_.size() + points_.size(); }

private:
    gl::VertexArrayObject dome_array_;
    gl::VertexArrayObject point_array_;
    gl::Buffer vertices_;
    gl::Buffer indices_;
    gl::Buffer points_;
    std::size_t index_count_{0};
    std::size_t point_count_{0};
};

}  // namespace plumbline::render
