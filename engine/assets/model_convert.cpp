#include "engine/assets/model_convert_impl.h"
#include "engine/core/limits.h"
#include "engine/core/log.h"

#include <assimp/material.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>
#include <unordered_map>

namespace plumbline::assets {
namespace {

/// A mesh at one place in the file's frame.
struct Instance {
    const aiMesh* mesh;
    Mat4f file_from_mesh;
    std::size_t material;
};

struct FaceCounts {
    std::size_t degenerate{0};
    std::size_t out_of_range{0};
};

Mat4f matrix_of(const aiMatrix4x4& m) {
    // assimp keeps rows, GLM columns.
    return {{m.a1, m.b1, m.c1, m.d1},
            {m.a2, m.b2, m.c2, m.d2},
            {m.a3, m.b3, m.c3, m.d3},
            {m.a4, m.b4, m.c4, m.d4}};
}

Vec3f vec_of(const aiVector3D& v) {
    return {v.x, v.y, v.z};
}

/// Which of ours a mesh wears: see CheckedModel::materials.
std::size_t material_of(const aiScene& scene, const aiMesh& mesh, std::size_t known) {
    aiString name;
    if (mesh.mMaterialIndex < scene.mNumMaterials) {
        scene.mMaterials[mesh.mMaterialIndex]->Get(AI_MATKEY_NAME, name);
    }
    const std::string_view digits(name.C_Str(), name.length);
    std::size_t number = known;
    const auto [end, fault] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    return fault == std::errc{} && end == digits.data() + digits.size() && number < known ? number
                                                                                          : known;
}

std::vector<Instance> instances_of(const aiScene& scene, std::size_t known_materials) {
    struct Visit {
        const aiNode* node;
        Mat4f file_from_parent;
    };
    std::vector<Instance> instances;
    std::vector<Visit> open{{scene.mRootNode, Mat4f{1.0F}}};
    while (!open.empty()) {
        const Visit visit = open.back();
        open.pop_back();
        const Mat4f file_from_node =
            visit.file_from_parent * matrix_of(visit.node->mTransformation);
        for (unsigned i = 0; i < visit.node->mNumMeshes; ++i) {
            const aiMesh* mesh = scene.mMeshes[visit.node->mMeshes[i]];
            instances.push_back({mesh, file_from_node, material_of(scene, *mesh, known_materials)});
        }
        // Backwards, so that children come off the stack in the file's order.
        for (unsigned i = visit.node->mNumChildren; i-- > 0;) {
            open.push_back({visit.node->mChildren[i], file_from_node});
        }
    }
    return instances;
}

/// Vertices in the file's frame; empty, with the reason, when the mesh cannot be used.
std::vector<Vertex> vertices_of(const Instance& instance, bool keep_colors, std::string& fault) {
    const aiMesh& mesh = *instance.mesh;
    const Mat3f linear{instance.file_from_mesh};
    const float determinant = glm::determinant(linear);
    // Transforms that flatten have no inverse; such normals are made anew from the triangles.
    const Mat3f normal_matrix =
        std::abs(determinant) > 1e-20F ? glm::transpose(glm::inverse(linear)) : Mat3f{0.0F};
    std::vector<Vertex> vertices(mesh.mNumVertices);
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
        Vertex& vertex = vertices[i];
        vertex.position_body =
            Vec3f{instance.file_from_mesh * Vec4f{vec_of(mesh.mVertices[i]), 1.0F}};
        if (!is_finite(vertex.position_body)) {
            fault = fmt::format("its vertex {} is not finite", i);
            return {};
        }
        const Vec3f distance = glm::abs(vertex.position_body);
        if (std::max({distance.x, distance.y, distance.z}) >
            static_cast<float>(limits::kPosition_m)) {
            fault = fmt::format("its vertex {} lies beyond {} m", i, limits::kPosition_m);
            return {};
        }
        vertex.normal_body = Vec3f{0.0F};  // zero: to be made
        if (mesh.mNormals != nullptr) {
            const Vec3f normal = normal_matrix * vec_of(mesh.mNormals[i]);
            if (is_finite(normal)) vertex.normal_body = normalize_or(normal, Vec3f{0.0F});
        }
        if (mesh.mTextureCoords[0] != nullptr) {
            const aiVector3D& uv = mesh.mTextureCoords[0][i];
            // assimp lets v run up the image.
            if (std::isfinite(uv.x) && std::isfinite(uv.y)) vertex.uv = {uv.x, 1.0F - uv.y};
        }
        if (keep_colors && mesh.mColors[0] != nullptr) {
            const aiColor4D& color = mesh.mColors[0][i];
            const Vec3f rgb{color.r, color.g, color.b};
            if (is_finite(rgb)) vertex.color = glm::max(rgb, Vec3f{0.0F});
        }
    }
    return vertices;
}

/// The triangles worth drawing, wound for the transform.
std::vector<std::uint32_t> indices_of(const Instance& instance,
                                      const std::vector<Vertex>& vertices,
                                      FaceCounts& dropped) {
    const bool mirrored = glm::determinant(Mat3f{instance.file_from_mesh}) < 0.0F;
    std::vector<std::uint32_t> indices;
    indices.reserve(std::size_t{instance.mesh->mNumFaces} * 3);
    for (unsigned i = 0; i < instance.mesh->mNumFaces; ++i) {
        const aiFace& face = instance.mesh->mFaces[i];
        if (face.mNumIndices != 3) continue;  // points and lines
        const std::uint32_t a = face.mIndices[0];
        const std::uint32_t b = face.mIndices[mirrored ? 2 : 1];
        const std::uint32_t c = face.mIndices[mirrored ? 1 : 2];
        if (std::max({a, b, c}) >= vertices.size()) {
            ++dropped.out_of_range;
            continue;
        }
        const Vec3f& corner = vertices[a].position_body;
        const Vec3f area =
            glm::cross(vertices[b].position_body - corner, vertices[c].position_body - corner);
        if (area == Vec3f{0.0F}) {
            ++dropped.degenerate;
            continue;
        }
        indices.insert(indices.end(), {a, b, c});
    }
    return indices;
}

/// Gives every triangle vertices of its own with the triangle's normal, as glTF asks for when a
/// file has no normals.
void make_flat(MeshData& part) {
    MeshData flat;
    flat.vertices.reserve(part.indices.size());
    flat.indices.resize(part.indices.size());
    for (std::size_t i = 0; i < part.indices.size(); ++i) {
        flat.vertices.push_back(part.vertices[part.indices[i]]);
        flat.indices[i] = static_cast<std::uint32_t>(i);
    }
    compute_normals(flat);
    part = std::move(flat);
}

/// Replaces normals that are zero or not finite by the mean of their triangles'.
void mend_normals(MeshData& part) {
    const auto missing = [](const Vertex& vertex) { return vertex.normal_body == Vec3f{0.0F}; };
    const auto count = std::count_if(part.vertices.begin(), part.vertices.end(), missing);
    if (count == 0) return;
    if (static_cast<std::size_t>(count) == part.vertices.size()) {
        make_flat(part);
        return;
    }
    MeshData made = part;
    compute_normals(made);
    for (std::size_t i = 0; i < part.vertices.size(); ++i) {
        if (missing(part.vertices[i])) part.vertices[i].normal_body = made.vertices[i].normal_body;
    }
}

/// OBJ comes with vertices of their own for every corner: equal ones become one.
void weld(MeshData& part) {
    static_assert(sizeof(Vertex) == 15 * sizeof(float), "no padding: equal bytes, equal vertices");
    std::unordered_map<std::string_view, std::uint32_t> places;
    places.reserve(part.vertices.size());
    std::vector<std::uint32_t> new_index(part.vertices.size());
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < part.vertices.size(); ++i) {
        const std::string_view bytes(
            static_cast<const char*>(static_cast<const void*>(&part.vertices[i])), sizeof(Vertex));
        const auto [place, is_new] =
            places.try_emplace(bytes, static_cast<std::uint32_t>(kept.size()));
        if (is_new) kept.push_back(i);
        new_index[i] = place->second;
    }
    std::vector<Vertex> vertices;
    vertices.reserve(kept.size());
    for (const std::size_t i : kept) vertices.push_back(part.vertices[i]);
    for (std::uint32_t& index : part.indices) index = new_index[index];
    part.vertices = std::move(vertices);
}

void append(MeshData& mesh, const MeshData& part) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), part.vertices.begin(), part.vertices.end());
    for (const std::uint32_t index : part.indices) mesh.indices.push_back(first + index);
}

/// Adds one instance to the merged mesh. False when it was left out.
bool add_instance(MeshData& mesh,
                  const Instance& instance,
                  bool keep_colors,
                  const std::string& name) {
    FaceCounts dropped;
    std::string fault;
    MeshData part;
    part.vertices = vertices_of(instance, keep_colors, fault);
    if (!fault.empty()) {
        log_warning(
            "model {}: mesh \"{}\" is left out: {}", name, instance.mesh->mName.C_Str(), fault);
        return false;
    }
    part.indices = indices_of(instance, part.vertices, dropped);
    if (dropped.out_of_range > 0) {
        log_warning("model {}: mesh \"{}\" is left out: {} faces name vertices that it lacks",
                    name,
                    instance.mesh->mName.C_Str(),
                    dropped.out_of_range);
        return false;
    }
    if (dropped.degenerate > 0) {
        // A few come with most models; many mean that something is wrong with this one.
        const bool many = dropped.degenerate * 10 > instance.mesh->mNumFaces;
        log_line(many ? LogLevel::Warning : LogLevel::Debug,
                 fmt::format("model {}: mesh \"{}\": {} faces without area are left out",
                             name,
                             instance.mesh->mName.C_Str(),
                             dropped.degenerate));
    }
    mend_normals(part);
    if (part.vertices.size() >= part.indices.size()) weld(part);
    append(mesh, part);
    return !part.indices.empty();
}

}  // namespace

bool has_vertex_colors(const MaterialData& material) {
    return material.name == "vcol" || material.name.starts_with("vcol_");
}

Result<ModelData> convert_scene(const aiScene& scene,
                                std::vector<MaterialData> materials,
                                const std::string& name) {
    if (scene.mRootNode == nullptr) return model_error(name, "it holds no triangles");
    ModelData model{.mesh = {}, .materials = std::move(materials)};
    std::vector<Instance> instances = instances_of(scene, model.materials.size());
    std::stable_sort(instances.begin(), instances.end(), [](const Instance& a, const Instance& b) {
        return a.material < b.material;
    });
    for (const Instance& instance : instances) {
        if (instance.material == model.materials.size()) {
            model.materials.push_back({.name = "default"});  // sorted: only the last can lack one
        }
        const auto first = static_cast<std::uint32_t>(model.mesh.indices.size());
        const MaterialData& material = model.materials[instance.material];
        if (!add_instance(model.mesh, instance, has_vertex_colors(material), name)) continue;
        const auto count = static_cast<std::uint32_t>(model.mesh.indices.size()) - first;
        std::vector<SubMesh>& runs = model.mesh.sub_meshes;
        if (!runs.empty() && runs.back().material == instance.material) {
            runs.back().index_count += count;
        } else {
            runs.push_back({.first_index = first,
                            .index_count = count,
                            .material = static_cast<std::uint32_t>(instance.material)});
        }
    }
    if (model.mesh.indices.empty()) return model_error(name, "it holds no triangles");
    if (model.mesh.vertices.size() > limits::kVertices ||
        model.mesh.indices.size() > limits::kIndices) {
        return model_error(name, "it is too large");
    }
    model.mesh.bounds = bounds_of(model.mesh);
    compute_tangents(model.mesh);
    return model;
}

}  // namespace plumbline::assets
