// What all passes draw with.
#pragma once

#include "engine/render/gl/object.h"
#include "engine/render/gl/pass_timer.h"
#include "engine/render/passes/scene_resources.h"

namespace plumbline::render {

/// An empty vertex array and one triangle: what full-screen passes draw.
class FullscreenTriangle {
public:
    FullscreenTriangle() : vertex_array_(gl::new_vertex_array()) {}
    void draw() const;

private:
    gl::VertexArrayObject vertex_array_;
};

/// What passes draw with, and where they say what it took.
struct PassContext {
    SceneResources& resources;
    const FullscreenTriangle& triangle;
    gl::PassTimers& timers;
    FrameStats& stats;

    /// Null if it does not compile.
    const gl::Program* program(const ShaderPair& files, FeatureSet features = 0) const {
        return resources.shaders.find(files, features);
    }
    /// The whole of what is drawn into, once.
    void draw_triangle() const {
        triangle.draw();
        ++stats.draw_calls;
    }
};

}  // namespace plumbline::render
