#include "engine/assets/foreign/model_convert_impl.h"
#include "engine/core/log.h"

#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>

namespace plumbline::assets {

Mat4f matrix_of(const aiMatrix4x4& m) {
    return {{m.a1, m.b1, m.c1, m.d1},
            {m.a2, m.b2, m.c2, m.d2},
            {m.a3, m.b3, m.c3, m.d3},
            {m.a4, m.b4, m.c4, m.d4}};
}

namespace {

Vec3f vec_of(const aiVector3D& v) {
    return {v.x, v.y, v.z};
}

std::vector<Vertex> vertices_of(const aiMesh& mesh) {
    std::vector<Vertex> vertices(mesh.mNumVertices);
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
        Vertex& vertex = vertices[i];
        vertex.position_body = vec_of(mesh.mVertices[i]);
        vertex.normal_body = mesh.mNormals != nullptr ? vec_of(mesh.mNormals[i]) : Vec3f{0.0F};
        if (mesh.mTextureCoords[0] != nullptr) {
            const aiVector3D& uv = mesh.mTextureCoords[0][i];
            // assimp lets v run up the image.
            if (std::isfinite(uv.x) && std::isfinite(uv.y)) vertex.uv = {uv.x, 1.0F - uv.y};
        }
        if (mesh.mColors[0] != nullptr) {
            const aiColor4D& color = mesh.mColors[0][i];
            const Vec3f rgb{color.r, color.g, color.b};
            if (is_finite(rgb)) vertex.color = glm::max(rgb, Vec3f{0.0F});
        }
    }
    return vertices;
}

/// Triangles; points and lines are dropped. Nothing when a face names a vertex that is not there.
std::vector<std::uint32_t> indices_of(const aiMesh& mesh) {
    std::vector<std::uint32_t> indices;
    indices.reserve(std::size_t{mesh.mNumFaces} * 3);
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
        const aiFace& face = mesh.mFaces[i];
        if (face.mNumIndices != 3) continue;
        for (unsigned k = 0; k < 3; ++k) {
            if (face.mIndices[k] >= mesh.mNumVertices) return {};
            indices.push_back(face.mIndices[k]);
        }
    }
    return indices;
}

bool has_colors(const ModelMesh& mesh) {
    return std::any_of(mesh.vertices.begin(), mesh.vertices.end(), [](const Vertex& vertex) {
        return vertex.color != Vec3f{1.0F};
    });
}

std::string fault_of(const ModelMesh& mesh) {
    if (mesh.indices.empty()) return "it has no usable triangles";
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        if (!is_finite(mesh.vertices[i].position_body)) {
            return fmt::format("its vertex {} is not finite", i);
        }
    }
    return {};
}

/// assimp's tree flat, parents first, in the file's order; `places` tells where each node went.
std::vector<ModelNode> nodes_of(const aiScene& scene,
                                std::map<const aiNode*, std::uint32_t>& places) {
    std::vector<ModelNode> nodes;
    std::vector<const aiNode*> open;
    if (scene.mRootNode != nullptr) open.push_back(scene.mRootNode);
    while (!open.empty()) {
        const aiNode* source = open.back();
        open.pop_back();
        ModelNode node{.name = source->mName.C_Str(),
                       .parent_from_node = matrix_of(source->mTransformation)};
        if (source->mParent != nullptr) node.parent = places.at(source->mParent);
        aiVector3D scale;
        aiQuaternion turn;
        aiVector3D place;
        source->mTransformation.Decompose(scale, turn, place);
        node.rest = {.translation = vec_of(place),
                     .rotation = {turn.w, turn.x, turn.y, turn.z},
                     .scale = vec_of(scale)};
        places.emplace(source, static_cast<std::uint32_t>(nodes.size()));
        nodes.push_back(std::move(node));
        // Backwards, so that children come off the stack in the file's order.
        for (unsigned i = source->mNumChildren; i-- > 0;) open.push_back(source->mChildren[i]);
    }
    return nodes;
}

}  // namespace

ConvertedScene convert_tree(const aiScene& scene,
                            std::vector<MaterialData> materials,
                            const std::string& name) {
    ConvertedScene converted;
    ModelData& model = converted.model;
    model.materials = std::move(materials);
    const std::size_t known = model.materials.size();
    model.nodes = nodes_of(scene, converted.places);
    converted.meshes.resize(scene.mNumMeshes);
    for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
        const aiMesh& source = *scene.mMeshes[i];
        ModelMesh mesh{.name = source.mName.C_Str(),
                       .vertices = vertices_of(source),
                       .indices = indices_of(source)};
        const std::string fault = fault_of(mesh);
        if (!fault.empty()) {
            log_warning("model {}: mesh \"{}\" is left out: {}", name, mesh.name, fault);
            continue;
        }
        const std::size_t material = std::min(std::size_t{source.mMaterialIndex}, known);
        if (material == known && model.materials.size() == known) {
            model.materials.push_back({.name = "default"});
        }
        mesh.material = static_cast<std::uint32_t>(material);
        if (has_colors(mesh)) model.materials[material].vertex_colors = true;
        converted.meshes[i] = static_cast<std::uint32_t>(model.meshes.size());
        model.meshes.push_back(std::move(mesh));
    }
    for (const auto& [source, place] : converted.places) {
        for (unsigned i = 0; i < source->mNumMeshes; ++i) {
            const std::optional<std::uint32_t> number = converted.meshes[source->mMeshes[i]];
            if (number) model.nodes[place].meshes.push_back(*number);
        }
    }
    return converted;
}

}  // namespace plumbline::assets
