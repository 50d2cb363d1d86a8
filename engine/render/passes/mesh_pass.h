// Draws a list of meshes with their materials: the opaque and the translucent pass.
#pragma once

#include "engine/render/gl/buffer.h"
#include "engine/render/passes/scene_resources.h"

#include <vector>

namespace plumbline::render {

class MeshPass {
public:
    /// `frame_features`: the shader code that this frame's lights and air need.
    void render(const DrawList& draws,
                FeatureSet frame_features,
                const std::vector<LocalLight>& lights,
                SceneResources& resources,
                FrameStats& stats);

private:
    InstanceStream instances_;
};

/// Features of the frame that a material makes use of; unlit ones need no lights.
FeatureSet variant_of(FeatureSet material_features, FeatureSet frame_features);

}  // namespace plumbline::render
