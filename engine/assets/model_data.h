// A model file's content as the file has it: nodes, meshes, materials, animations and skins.
#pragma once

#include "engine/assets/material_data.h"
#include "engine/assets/mesh_data.h"
#include "engine/assets/model_physics.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace plumbline::assets {

/// Scale first, then rotation, then translation.
struct NodeTransform {
    Vec3f translation{0.0F};
    Quatf rotation{1.0F, 0.0F, 0.0F, 0.0F};  ///< unit
    Vec3f scale{1.0F};
};

/// Parents stand before their children.
struct ModelNode {
    std::string name;
    std::optional<std::uint32_t> parent;  ///< nothing: the node stands in the file's frame
    Mat4f parent_from_node{1.0F};         ///< at rest; may shear
    NodeTransform rest{};  ///< the same, as far as it goes: where channels begin to replace parts
    std::vector<std::uint32_t> meshes;
    std::optional<std::uint32_t> skin;
    std::vector<float> morph_weights;  ///< at rest; empty: none of them
    std::string extras;  ///< JSON of what a file of ours says of it beyond glTF; empty: nothing
};

/// Offsets of every vertex at weight 1.
struct MorphTarget {
    std::vector<Vec3f> positions;
    std::vector<Vec3f> normals;  ///< as many, or none
};

/// The joints that move a vertex, by their place in ModelSkin::joints; weights add up to 1.
struct JointInfluence {
    std::array<std::uint16_t, 4> joints{};
    std::array<float, 4> weights{};
};

/// Triangles of one material in the frame of the nodes that show them.
struct ModelMesh {
    std::string name;
    std::uint32_t material{0};     ///< index into ModelData::materials
    std::vector<Vertex> vertices;  ///< a zero normal: to be made from the triangles
    std::vector<std::uint32_t> indices;
    std::vector<JointInfluence> influences;  ///< one a vertex, or none
    std::vector<MorphTarget> targets;
};

struct ModelSkin {
    std::vector<std::uint32_t> joints;   ///< nodes
    std::vector<Mat4f> joint_from_mesh;  ///< inverse bind matrices, one a joint
};

enum class ChannelPath : std::uint8_t { Translation, Rotation, Scale, MorphWeights };
enum class Interpolation : std::uint8_t { Step, Linear, CubicSpline };

/// One property of one node over time.
struct AnimationChannel {
    std::uint32_t node{0};
    ChannelPath path{ChannelPath::Translation};
    Interpolation interpolation{Interpolation::Linear};
    std::vector<float> times_s;  ///< at least one, rising
    /// For each time 3, 4 (x y z w) or as many numbers as there are targets; with CubicSpline three
    /// such groups: slope before, value, slope after.
    std::vector<float> values;
};

struct ModelAnimation {
    std::string name;
    float duration_s{0.0F};
    std::vector<AnimationChannel> channels;
};

/// An image that lies in the model file itself: PNG, JPEG or EXR bytes.
struct EmbeddedImage {
    std::filesystem::path name;  ///< what materials call it: below the model file's own path
    std::string bytes;
};

struct ModelData {
    std::vector<ModelNode> nodes;
    std::vector<ModelMesh> meshes;
    std::vector<MaterialData> materials;  ///< at least one when there are triangles
    std::vector<ModelAnimation> animations;
    std::vector<ModelSkin> skins;
    ModelPhysics physics;
    std::vector<EmbeddedImage> images;
    MeshData mesh;       ///< all of it in the file's own frame, at rest: see merged_mesh
    std::string extras;  ///< as ModelNode::extras, of the whole
    std::vector<std::filesystem::path> files;  ///< that were read, the model's own first
};

}  // namespace plumbline::assets
