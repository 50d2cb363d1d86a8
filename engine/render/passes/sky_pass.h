// The sky behind all that is opaque.
#pragma once

#include "engine/render/gl/object.h"
#include "engine/render/passes/scene_resources.h"

namespace plumbline::render {

/// An empty vertex array and one triangle: what full-screen passes draw.
class FullscreenTriangle {
public:
    FullscreenTriangle();
    void draw() const;

private:
    gl::VertexArrayObject vertex_array_;
};

/// At the far plane, where nothing was drawn. `writes_codes`: the target holds sRGB codes.
void render_sky(const FullscreenTriangle& triangle,
                bool writes_codes,
                SceneResources& resources,
                FrameStats& stats);

}  // namespace plumbline::render
