// Where a model's nodes are at an instant of an animation, and what that makes of its meshes.
#pragma once

#include "engine/assets/model_data.h"

#include <optional>
#include <string>
#include <vector>

namespace plumbline::assets {

struct ModelPose {
    std::vector<Mat4f> model_from_node;             ///< by node
    std::vector<std::vector<float>> morph_weights;  ///< by node; empty: none
};

Mat4f matrix_of(const NodeTransform& place);

/// As the file stands.
ModelPose rest_pose(const ModelData& model);
/// `time_s` is clamped to the animation; the last key holds beyond its channel's end.
ModelPose pose_at(const ModelData& model, const ModelAnimation& animation, float time_s);

/// A mesh shown by a node, to be drawn on its own.
struct ModelPart {
    std::uint32_t node{0};
    std::uint32_t mesh{0};
    bool deforms{false};  ///< by bones or targets: its vertices change, in the model's frame
};
/// Everything in the model's own frame as one mesh, sub-meshes in the order of materials. Meshes
/// that are no good (numbers not finite, beyond limits::kPosition_m) are left out with a warning;
/// `name` is the file's, for that. Empty when nothing is left.
MeshData merged_mesh(const ModelData& model, const ModelPose& pose, const std::string& name);

/// The same of these parts alone.
MeshData merged_mesh(const ModelData& model,
                     std::vector<ModelPart> parts,
                     const ModelPose& pose,
                     const std::string& name);

/// What the model takes up in a pose, in its own frame.
Aabb bounds_of(const ModelData& model, const ModelPose& pose);

/// What moves in some animation, part by part, and what never does.
struct ModelParts {
    std::vector<ModelPart> moving;
    std::vector<ModelPart> still;
};
ModelParts parts_of(const ModelData& model);

/// One part's triangles: in its node's frame, or, if it deforms, in the model's at this pose.
MeshData part_mesh(const ModelData& model, const ModelPart& part, const ModelPose& pose);
/// The still parts as one mesh, as merged_mesh.
MeshData still_mesh(const ModelData& model, const ModelParts& parts, const std::string& name);
/// Moves vertices, normals and bounds of a deforming part's mesh to another pose.
void deform(const ModelData& model, const ModelPart& part, const ModelPose& pose, MeshData& mesh);

}  // namespace plumbline::assets
