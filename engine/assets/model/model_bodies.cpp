#include "engine/assets/model/model_bodies.h"

#include "engine/assets/model/model_pose.h"

#include <utility>

namespace plumbline::assets {
namespace {

/// The node's own turn is taken out of its matrix; with no shear the rest is its scale.
glm::dmat3 own_stretch(const ModelNode& node, const Quatd& turn) {
    if (matrix_of(node.rest) == node.parent_from_node) {
        glm::dmat3 scale{1.0};
        for (int axis = 0; axis < 3; ++axis)
            scale[axis][axis] = static_cast<double>(node.rest.scale[axis]);
        return scale;
    }
    return glm::transpose(glm::mat3_cast(turn)) * glm::dmat3{Mat3f{node.parent_from_node}};
}

bool is_uniform(const glm::dmat3& stretch) {
    return stretch == glm::dmat3{stretch[0][0]};
}

NodePlace placed_on(const NodePlace& parent, const ModelNode& node) {
    const Quatd own = glm::normalize(Quatd{node.rest.rotation});
    const glm::dmat3 turn = glm::mat3_cast(own);
    // A stretch that is the same every way needs no turning.
    const glm::dmat3 stretch =
        is_uniform(parent.stretch) ? parent.stretch : glm::transpose(turn) * parent.stretch * turn;
    const Vec3d shift{Vec3f{node.parent_from_node[3]}};
    return {.position_m = parent.position_m + parent.turn * (parent.stretch * shift),
            .turn = node.parent ? glm::normalize(parent.turn * own) : own,
            .stretch = stretch * own_stretch(node, own)};
}

/// The affine map of a place, as seen from another one without its stretch.
Mat4f seen_from(const NodePlace& frame, const NodePlace& place) {
    const Quatd back = glm::conjugate(frame.turn);
    const glm::dmat3 linear = back == glm::conjugate(place.turn)
                                  ? place.stretch
                                  : glm::mat3_cast(back * place.turn) * place.stretch;
    Mat4f matrix{Mat3f{linear}};
    matrix[3] = Vec4f{Vec3f{back * (place.position_m - frame.position_m)}, 1.0F};
    return matrix;
}

}  // namespace

std::vector<NodePlace> node_places(const ModelData& model) {
    std::vector<NodePlace> places;
    places.reserve(model.nodes.size());
    for (const ModelNode& node : model.nodes)
        places.push_back(placed_on(node.parent ? places[*node.parent] : NodePlace{}, node));
    return places;
}

std::vector<std::size_t> bodies_of_nodes(const ModelData& model) {
    const std::vector<ModelMotion>& motions = model.physics.motions;
    std::vector<std::size_t> bodies(model.nodes.size(), motions.size());
    for (std::size_t i = 0; i < motions.size(); ++i) bodies[motions[i].node] = i;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const auto& parent = model.nodes[i].parent;
        if (bodies[i] == motions.size() && parent) bodies[i] = bodies[*parent];
    }
    return bodies;
}

std::vector<MeshData> body_meshes(const ModelData& model, const std::string& name) {
    const std::vector<NodePlace> places = node_places(model);
    const std::vector<std::size_t> bodies = bodies_of_nodes(model);
    const std::vector<ModelMotion>& motions = model.physics.motions;
    std::vector<std::vector<ModelPart>> parts(motions.size() + 1);
    ModelPose pose = rest_pose(model);
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        const bool moves = bodies[i] < motions.size();
        const NodePlace frame = moves ? places[motions[bodies[i]].node] : NodePlace{};
        pose.model_from_node[i] = seen_from(frame, places[i]);
        for (const std::uint32_t mesh : model.nodes[i].meshes)
            parts[bodies[i]].push_back({.node = static_cast<std::uint32_t>(i), .mesh = mesh});
    }
    std::vector<MeshData> meshes;
    meshes.reserve(parts.size());
    for (std::vector<ModelPart>& part : parts)
        meshes.push_back(merged_mesh(model, std::move(part), pose, name));
    return meshes;
}

}  // namespace plumbline::assets
