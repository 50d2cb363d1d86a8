#include "engine/assets/gltf_check_impl.h"
#include "engine/core/limits.h"
#include "engine/core/log.h"

#include <algorithm>

namespace plumbline::assets {
namespace {

constexpr std::size_t kNoParent = ~std::size_t{0};
constexpr std::size_t kMaxScenes = 1'024;

/// Numbers of nodes in an array; a fault leaves it short.
std::vector<std::size_t> node_list(GltfCheck& check,
                                   const Json& owner,
                                   const char* key,
                                   const std::string& where,
                                   std::size_t node_count) {
    std::vector<std::size_t> numbers;
    for (const Json& entry : check.array(owner, key, where)) {
        if (!entry.is_number_unsigned()) {
            check.fail("{}.{} holds {}; it must name nodes by number", where, key, entry.dump());
            return {};
        }
        const auto number = entry.get<std::size_t>();
        if (number >= node_count) {
            check.fail("{}.{} names node {} of {}", where, key, number, node_count);
            return {};
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
void check_tree(GltfCheck& check,
                const std::vector<std::vector<std::size_t>>& children,
                const std::vector<std::size_t>& parents) {
    std::vector<std::size_t> level;
    std::vector<bool> reached(children.size(), false);
    std::size_t reached_count = 0;
    for (std::size_t i = 0; i < parents.size(); ++i) {
        if (parents[i] == kNoParent) level.push_back(i);
    }
    for (std::size_t depth = 1; !level.empty(); ++depth) {
        if (depth > limits::kModelNodeDepth) {
            check.fail(
                "nodes[{}] is nested deeper than {}", level.front(), limits::kModelNodeDepth);
            return;
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
    check.fail("its nodes form a cycle: {}", chain_text(static_cast<std::size_t>(lost), parents));
}

Json clean_node(GltfCheck& check, const Json& source, const std::string& where) {
    Json node = Json::object();
    const std::vector<float> matrix = check.numbers(source, "matrix", where, 16);
    const std::vector<float> translation = check.numbers(source, "translation", where, 3);
    const std::vector<float> rotation = check.numbers(source, "rotation", where, 4);
    const std::vector<float> scale = check.numbers(source, "scale", where, 3);
    const auto mesh = check.index(source, "mesh", where, check.vertex_counts.size());
    if (check.failed()) return node;
    if (!matrix.empty()) {
        node["matrix"] = matrix;
    } else {
        if (!translation.empty()) node["translation"] = translation;
        if (!scale.empty()) node["scale"] = scale;
        if (!rotation.empty()) {
            const Quatf turn{rotation[3], rotation[0], rotation[1], rotation[2]};
            if (!(glm::length(turn) > 1e-6F)) {
                check.fail("{}.rotation is zero", where);
                return node;
            }
            const Quatf unit = glm::normalize(turn);
            node["rotation"] = {unit.x, unit.y, unit.z, unit.w};
        }
    }
    if (mesh && check.vertex_counts[*mesh] > 0) node["mesh"] = *mesh;
    return node;
}

/// What all nodes together draw, before anything is built.
void check_totals(GltfCheck& check) {
    std::size_t vertices = 0;
    std::size_t indices = 0;
    for (const Json& node : check.clean["nodes"]) {
        if (!node.contains("mesh")) continue;
        const auto mesh = node["mesh"].get<std::size_t>();
        vertices += check.vertex_counts[mesh];
        indices += check.index_counts[mesh];
    }
    if (vertices > limits::kVertices) {
        check.fail("it draws {} vertices; at most {} are read", vertices, limits::kVertices);
    }
    if (indices > limits::kIndices) {
        check.fail("it draws {} indices; at most {} are read", indices, limits::kIndices);
    }
}

/// The nodes that the file's scene starts from; all roots when it has no scene.
std::vector<std::size_t> scene_roots(GltfCheck& check, const std::vector<std::size_t>& parents) {
    const Json& scenes = check.objects("scenes", kMaxScenes);
    std::vector<std::size_t> roots;
    if (scenes.empty()) {
        for (std::size_t i = 0; i < parents.size(); ++i) {
            if (parents[i] == kNoParent) roots.push_back(i);
        }
        return roots;
    }
    const std::size_t scene = check.index(check.document, "scene", "", scenes.size()).value_or(0);
    if (check.failed()) return roots;
    const std::string where = fmt::format("scenes[{}]", scene);
    roots = node_list(check, scenes[scene], "nodes", where, parents.size());
    std::set<std::size_t> named;
    for (const std::size_t root : roots) {
        if (parents[root] != kNoParent) check.fail("{}.nodes names node {}, a child", where, root);
        if (!named.insert(root).second) check.fail("{}.nodes names node {} twice", where, root);
    }
    return roots;
}

}  // namespace

void check_nodes(GltfCheck& check) {
    const Json& list = check.objects("nodes", limits::kModelNodes);
    if (check.failed()) return;
    std::vector<std::size_t> parents(list.size(), kNoParent);
    std::vector<std::vector<std::size_t>> children(list.size());
    check.clean["nodes"] = Json::array();
    bool skinned = false;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const std::string where = fmt::format("nodes[{}]", i);
        Json node = clean_node(check, list[i], where);
        children[i] = node_list(check, list[i], "children", where, list.size());
        if (check.failed()) return;
        for (const std::size_t child : children[i]) {
            if (parents[child] != kNoParent) {
                check.fail(
                    "node {} is a child of node {} and of node {}", child, parents[child], i);
                return;
            }
            parents[child] = i;
        }
        if (!children[i].empty()) node["children"] = children[i];
        skinned = skinned || list[i].contains("skin");
        check.clean["nodes"].push_back(std::move(node));
    }
    check_tree(check, children, parents);
    if (!check.failed()) check_totals(check);
    const std::vector<std::size_t> roots = scene_roots(check, parents);
    if (check.failed()) return;
    check.clean["scene"] = 0;
    check.clean["scenes"] = Json::array({Json{{"nodes", roots}}});
    if (skinned) {
        log_note("model {} is shown as it stands; bones are not read", check.name);
    }
}

}  // namespace plumbline::assets
