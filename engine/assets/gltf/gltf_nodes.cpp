#include "engine/assets/gltf/gltf_reader_impl.h"
#include "engine/assets/model/model_pose.h"
#include "engine/core/limits.h"
#include "engine/core/log.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace plumbline::assets {
namespace {

constexpr std::size_t kNoParent = ~std::size_t{0};
constexpr std::size_t kMaxScenes = 1'024;

/// Numbers of nodes in an array.
std::vector<std::size_t> node_list(const GltfObject& owner,
                                   const char* key,
                                   std::size_t node_count) {
    std::vector<std::size_t> numbers;
    for (const Json& entry : owner.array(key)) {
        if (!entry.is_number_unsigned()) {
            fail("{}.{} holds {}; it must name nodes by number", owner.where, key, entry.dump());
        }
        const auto number = entry.get<std::size_t>();
        if (number >= node_count) {
            fail("{}.{} names node {} of {}", owner.where, key, number, node_count);
        }
        numbers.push_back(number);
    }
    return numbers;
}

/// "node 4 > node 9 > node 4", shortened when long.
std::string chain_text(std::size_t start, const std::vector<std::size_t>& parents) {
    constexpr std::size_t kShown = 8;
    std::vector<bool> seen(parents.size(), false);
    while (!seen[start]) {  // the first node met twice lies on the cycle
        seen[start] = true;
        start = parents[start];
    }
    std::string text = fmt::format("node {}", start);
    std::size_t shown = 1;
    for (std::size_t node = parents[start]; node != start; node = parents[node]) {
        if (++shown <= kShown) text += fmt::format(" < node {}", node);
        if (shown == kShown + 1) text += " < …";
    }
    return text + fmt::format(" < node {}", start);
}

/// Depth and cycles, from the roots down, without recursion.
void check_tree(const std::vector<std::vector<std::size_t>>& children,
                const std::vector<std::size_t>& parents) {
    std::vector<std::size_t> level;
    std::vector<bool> reached(children.size(), false);
    std::size_t reached_count = 0;
    for (std::size_t i = 0; i < parents.size(); ++i) {
        if (parents[i] == kNoParent) level.push_back(i);
    }
    for (std::size_t depth = 1; !level.empty(); ++depth) {
        if (depth > limits::kModelNodeDepth) {
            fail("nodes[{}] is nested deeper than {}", level.front(), limits::kModelNodeDepth);
        }
        std::vector<std::size_t> next;
        for (const std::size_t node : level) {
            reached[node] = true;
            ++reached_count;
            next.insert(next.end(), children[node].begin(), children[node].end());
        }
        level = std::move(next);
    }
    if (reached_count == children.size()) return;
    const auto lost = std::find(reached.begin(), reached.end(), false) - reached.begin();
    fail("its nodes form a cycle: {}", chain_text(static_cast<std::size_t>(lost), parents));
}

/// The parts of a matrix; what it shears is lost.
NodeTransform parts_of(const Mat4f& matrix) {
    Mat3f axes{matrix};
    NodeTransform place{.translation = Vec3f{matrix[3]}};
    for (int axis = 0; axis < 3; ++axis) place.scale[axis] = glm::length(axes[axis]);
    if (glm::determinant(axes) < 0.0F) place.scale.x = -place.scale.x;
    for (int axis = 0; axis < 3; ++axis) {
        if (place.scale[axis] != 0.0F) axes[axis] /= place.scale[axis];
    }
    const Quatf turn = glm::quat_cast(axes);
    if (is_finite(turn) && glm::length(turn) > 1e-6F) place.rotation = glm::normalize(turn);
    return place;
}

void read_place(const GltfObject& source, ModelNode& node) {
    const std::vector<float> matrix = source.numbers("matrix", 16);
    const std::vector<float> translation = source.numbers("translation", 3);
    const std::vector<float> rotation = source.numbers("rotation", 4);
    const std::vector<float> scale = source.numbers("scale", 3);
    if (!matrix.empty()) {
        node.parent_from_node = glm::make_mat4(matrix.data());
        node.rest = parts_of(node.parent_from_node);
        return;
    }
    NodeTransform& rest = node.rest;
    if (!translation.empty()) rest.translation = glm::make_vec3(translation.data());
    if (!scale.empty()) rest.scale = glm::make_vec3(scale.data());
    if (!rotation.empty()) {
        const Quatf turn{rotation[3], rotation[0], rotation[1], rotation[2]};
        if (!(glm::length(turn) > 1e-6F)) fail("{}.rotation is zero", source.where);
        rest.rotation = glm::normalize(turn);
    }
    node.parent_from_node = matrix_of(rest);
}

ModelNode read_node(const GltfReader& reader, const GltfObject& source) {
    ModelNode node{.name = source.text("name"), .extras = own_extras(source)};
    read_place(source, node);
    const auto mesh = source.index("mesh", reader.mesh_parts.size());
    const auto skin = source.index("skin", reader.root.array("skins").size());
    node.morph_weights = source.numbers("weights", source.array("weights").size());
    if (!mesh) return node;
    node.meshes = reader.mesh_parts[*mesh];
    if (node.morph_weights.empty()) node.morph_weights = reader.mesh_weights[*mesh];
    if (skin) node.skin = static_cast<std::uint32_t>(*skin);
    return node;
}

/// What all nodes together draw, before anything is built.
void check_totals(const GltfReader& reader) {
    std::size_t vertices = 0;
    std::size_t indices = 0;
    for (const ModelNode& node : reader.model.nodes) {
        for (const std::uint32_t mesh : node.meshes) {
            vertices += reader.model.meshes[mesh].vertices.size();
            indices += reader.model.meshes[mesh].indices.size();
        }
    }
    if (vertices > limits::kVertices) {
        fail("it draws {} vertices; at most {} are read", vertices, limits::kVertices);
    }
    if (indices > limits::kIndices) {
        fail("it draws {} indices; at most {} are read", indices, limits::kIndices);
    }
}

/// The nodes that the file's scene starts from; all roots when it has no scene.
std::vector<std::size_t> scene_roots(const GltfReader& reader,
                                     const std::vector<std::size_t>& parents) {
    const std::vector<GltfObject> scenes = reader.objects("scenes", kMaxScenes);
    std::vector<std::size_t> roots;
    if (scenes.empty()) {
        for (std::size_t i = 0; i < parents.size(); ++i) {
            if (parents[i] == kNoParent) roots.push_back(i);
        }
        return roots;
    }
    const GltfObject& scene = scenes[reader.root.index("scene", scenes.size()).value_or(0)];
    roots = node_list(scene, "nodes", parents.size());
    std::set<std::size_t> named;
    for (const std::size_t root : roots) {
        if (parents[root] != kNoParent) fail("{}.nodes names node {}, a child", scene.where, root);
        if (!named.insert(root).second) fail("{}.nodes names node {} twice", scene.where, root);
    }
    return roots;
}

/// Moves what hangs on the scene's roots to the model, parents before children.
void keep_scene(GltfReader& reader,
                std::vector<ModelNode> nodes,
                const std::vector<std::vector<std::size_t>>& children,
                const std::vector<std::size_t>& parents,
                const std::vector<std::size_t>& roots) {
    reader.node_places.assign(nodes.size(), std::nullopt);
    std::vector<std::size_t> open(roots.rbegin(), roots.rend());
    while (!open.empty()) {
        const std::size_t number = open.back();
        open.pop_back();
        ModelNode node = std::move(nodes[number]);
        if (parents[number] != kNoParent) node.parent = reader.node_places[parents[number]];
        reader.node_places[number] = static_cast<std::uint32_t>(reader.model.nodes.size());
        reader.model.nodes.push_back(std::move(node));
        // Backwards, so that children come off the stack in the file's order.
        open.insert(open.end(), children[number].rbegin(), children[number].rend());
    }
}

}  // namespace

std::string own_extras(const GltfObject& owner) {
    const auto extras = owner.json.find("extras");
    if (extras == owner.json.end() || !extras->is_object()) return {};
    const auto own = extras->find("plumbline");
    return own == extras->end() ? std::string{} : own->dump();
}

std::vector<ColliderMesh> meshes_below(const GltfReader& reader, std::size_t node) {
    const Json& list = reader.root.array("nodes");
    struct Open {
        std::size_t node;
        Mat4f collider_from_node;
    };
    std::vector<ColliderMesh> meshes;
    std::vector<Open> open{{node, Mat4f{1.0F}}};
    while (!open.empty()) {
        const Open next = open.back();
        open.pop_back();
        const GltfObject here = object_at(list, next.node, "nodes");
        if (const auto mesh = here.index("mesh", reader.mesh_parts.size())) {
            for (const std::uint32_t part : reader.mesh_parts[*mesh])
                meshes.push_back({.mesh = part, .collider_from_mesh = next.collider_from_node});
        }
        for (const std::size_t child : node_list(here, "children", list.size())) {
            ModelNode below;
            read_place(object_at(list, child, "nodes"), below);
            open.push_back({child, next.collider_from_node * below.parent_from_node});
        }
    }
    return meshes;
}

void read_nodes(GltfReader& reader) {
    const std::vector<GltfObject> list = reader.objects("nodes", limits::kModelNodes);
    std::vector<std::size_t> parents(list.size(), kNoParent);
    std::vector<std::vector<std::size_t>> children(list.size());
    std::vector<ModelNode> nodes;
    for (std::size_t i = 0; i < list.size(); ++i) {
        nodes.push_back(read_node(reader, list[i]));
        children[i] = node_list(list[i], "children", list.size());
        for (const std::size_t child : children[i]) {
            if (parents[child] != kNoParent) {
                fail("node {} is a child of node {} and of node {}", child, parents[child], i);
            }
            parents[child] = i;
        }
    }
    check_tree(children, parents);
    const std::vector<std::size_t> roots = scene_roots(reader, parents);
    keep_scene(reader, std::move(nodes), children, parents, roots);
    reader.model.extras = own_extras(reader.root);
    check_totals(reader);
}

}  // namespace plumbline::assets
