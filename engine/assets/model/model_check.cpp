// Whether a model that came from elsewhere keeps the promises of model_data.h.
#include "engine/assets/foreign/model_wire.h"
#include "engine/core/limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline::assets {
namespace {

bool all_finite(const Mat4f& matrix) {
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            if (!std::isfinite(matrix[column][row])) return false;
        }
    }
    return true;
}

bool all_below(const std::vector<std::uint32_t>& numbers, std::size_t count) {
    return std::all_of(
        numbers.begin(), numbers.end(), [&](std::uint32_t number) { return number < count; });
}

std::string node_fault(const ModelData& model) {
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        const ModelNode& node = model.nodes[i];
        if (node.parent && *node.parent >= i)
            return fmt::format("node {} stands before its parent", i);
        if (!all_below(node.meshes, model.meshes.size()))
            return fmt::format("node {} names no mesh", i);
        if (node.skin && *node.skin >= model.skins.size())
            return fmt::format("node {} names no skin", i);
        if (!all_finite(node.parent_from_node)) return fmt::format("node {} stands nowhere", i);
    }
    return {};
}

std::string mesh_fault(const ModelData& model) {
    std::size_t vertices = 0;
    std::size_t indices = 0;
    for (std::size_t i = 0; i < model.meshes.size(); ++i) {
        const ModelMesh& mesh = model.meshes[i];
        vertices += mesh.vertices.size();
        indices += mesh.indices.size();
        const std::size_t count = mesh.vertices.size();
        if (mesh.material >= model.materials.size())
            return fmt::format("mesh {} has no material", i);
        if (mesh.indices.size() % 3 != 0 || !all_below(mesh.indices, count)) {
            return fmt::format("mesh {} names vertices that it lacks", i);
        }
        if (!mesh.influences.empty() && mesh.influences.size() != count) {
            return fmt::format("mesh {} has another number of influences", i);
        }
        for (const MorphTarget& target : mesh.targets) {
            if (target.positions.size() != count ||
                (!target.normals.empty() && target.normals.size() != count)) {
                return fmt::format("mesh {} has a target of another size", i);
            }
        }
        for (const Vertex& vertex : mesh.vertices) {
            if (!is_finite(vertex.position_body) || !is_finite(vertex.color)) {
                return fmt::format("mesh {} has numbers that are not finite", i);
            }
        }
    }
    if (vertices > limits::kVertices || indices > limits::kIndices) return "it is too large";
    return {};
}

std::string channel_fault(const ModelData& model, const AnimationChannel& channel) {
    if (channel.node >= model.nodes.size() || channel.times_s.empty())
        return "names no node or no time";
    for (std::size_t i = 0; i < channel.times_s.size(); ++i) {
        const bool rises = i == 0 || channel.times_s[i] > channel.times_s[i - 1];
        if (!std::isfinite(channel.times_s[i]) || !rises) return "has times that do not rise";
    }
    const std::size_t groups = channel.interpolation == Interpolation::CubicSpline ? 3 : 1;
    const std::size_t keys = channel.times_s.size() * groups;
    const std::size_t width = channel.values.size() / keys;
    const bool fits = (channel.path == ChannelPath::Rotation && width == 4) ||
                      (channel.path == ChannelPath::MorphWeights && width > 0) ||
                      (channel.path < ChannelPath::Rotation && width == 3) ||
                      (channel.path == ChannelPath::Scale && width == 3);
    if (!fits || width * keys != channel.values.size()) return "has another number of values";
    const bool finite = std::all_of(
        channel.values.begin(), channel.values.end(), [](float v) { return std::isfinite(v); });
    return finite ? "" : "has numbers that are not finite";
}

std::string motion_fault(const ModelData& model) {
    for (const ModelSkin& skin : model.skins) {
        if (!all_below(skin.joints, model.nodes.size()) ||
            skin.joint_from_mesh.size() != skin.joints.size()) {
            return "a skin names nodes that are not there";
        }
    }
    for (const ModelAnimation& animation : model.animations) {
        for (const AnimationChannel& channel : animation.channels) {
            const std::string fault = channel_fault(model, channel);
            if (!fault.empty()) return fmt::format("animation \"{}\" {}", animation.name, fault);
        }
    }
    return {};
}

}  // namespace

std::string fault_of(const ModelData& model) {
    if (model.nodes.size() > limits::kModelNodes) return "it has too many nodes";
    if (model.meshes.size() > limits::kModelMeshes) return "it has too many meshes";
    if (model.materials.size() > limits::kModelMaterials) return "it has too many materials";
    for (const auto& fault : {node_fault(model), mesh_fault(model), motion_fault(model)}) {
        if (!fault.empty()) return fault;
    }
    return {};
}

}  // namespace plumbline::assets
