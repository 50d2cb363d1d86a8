// Draws a list of meshes with their materials: the opaque and the translucent pass.
#pragma once

#include "engine/render/gl/buffer.h"
#include "engine/render/passes/refraction_pass.h"
#include "engine/render/passes/scene_resources.h"
#include "engine/render/passes/scene_target.h"

#include <set>
#include <span>

namespace plumbline::render {

/// What is the same for all draws of a frame.
struct MeshView {
    FeatureSet features{0};  ///< the shader code that this frame's lights and air need
    std::span<const LocalLight> lights;
    std::size_t shadowed_lights{0};     ///< so many of the first cast shadows
    const ConvexVolume* beam{nullptr};  ///< the flashlight's
    const RenderFrame* frame{nullptr};
    Vec3f light_direction_world{0.0F};  ///< of the sun
    float shadow_margin_m{
        0.0F};  ///< the sun's shadows end so near beside what casts them; 0: unknown
    Mat4f clip_from_world{1.0F};
    Vec3f eye_world{0.0F};
    PixelSize size_px;       ///< of what is drawn into
    Vec2f depth_line{0.0F};  ///< 1 / metres = x + y * depth
    PixelPart behind;        ///< what was copied for water to show; with kRefraction
};

class MeshPass {
public:
    void render(const DrawList& draws,
                DrawKind kind,
                const MeshView& view,
                SceneResources& resources,
                FrameStats& stats);

private:
    /// Shader code that only a part of the image needs.
    struct Local {
        ClipRect part;
        FeatureSet features{0};
    };
    /// What of a large plain thing needs less than all features.
    static std::vector<Local> locals_of(const DrawRun& run,
                                        FeatureSet features,
                                        const MeshView& view,
                                        const SceneResources& resources);
    /// First where all locals are needed, last where none is: where one drew, the next is no nearer.
    void draw_in_parts(const DrawRun& run,
                       FeatureSet features,
                       std::span<const Local> locals,
                       const ClipRect& within,
                       const MeshView& view,
                       SceneResources& resources,
                       FrameStats& stats) const;
    void draw(const DrawRun& run,
              FeatureSet features,
              const MeshView& view,
              SceneResources& resources,
              FrameStats& stats) const;

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
