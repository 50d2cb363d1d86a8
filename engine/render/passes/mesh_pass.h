// Draws a list of meshes with their materials: the opaque and the translucent pass.
#pragma once

#include "engine/render/gl/buffer.h"
#include "engine/render/passes/pass_context.h"
#include "engine/render/passes/refraction_pass.h"
#include "engine/render/setup/frame_setup.h"

#include <optional>
#include <set>
#include <span>

namespace plumbline::render {

class MeshPass {
public:
    /// `behind`: what was copied for water to show; none: the water does not show it.
    void render(const DrawList& draws,
                DrawKind kind,
                const FrameSetup& setup,
                const std::optional<PixelPart>& behind,
                PassContext context);

private:
    InstanceStream instances_;
};

/// Features of the frame, and those that the mesh adds.
FeatureSet features_with(FeatureSet frame_features, const GpuMesh& mesh);
/// Features of frame and mesh that a material makes use of; unlit ones need no lights. A look in
/// `smooth_looks` has no variant of its own for faceted meshes.
FeatureSet variant_of(FeatureSet material_features,
                      FeatureSet frame_features,
                      const std::set<FeatureSet>& smooth_looks = {});

}  // namespace plumbline::render
