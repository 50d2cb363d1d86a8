// From a posed model to triangles to draw or to collide with.
#include "engine/assets/model/model_pose.h"
#include "engine/core/limits.h"
#include "engine/core/log.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline::assets {
namespace {

/// A mesh at one place.
struct Instance {
    const ModelMesh* mesh{nullptr};
    Mat4f model_from_mesh{1.0F};
    const std::vector<float>* morph_weights{nullptr};
    std::vector<Mat4f> model_from_joint;  ///< empty: the mesh stands still in its node
};

Instance instance_of(const ModelData& model, const ModelPart& part, const ModelPose& pose) {
    const ModelNode& node = model.nodes[part.node];
    Instance instance{.mesh = &model.meshes[part.mesh],
                      .model_from_mesh = pose.model_from_node[part.node],
                      .morph_weights = &pose.morph_weights[part.node]};
    if (!node.skin || instance.mesh->influences.empty()) return instance;
    const ModelSkin& skin = model.skins[*node.skin];
    for (std::size_t i = 0; i < skin.joints.size(); ++i) {
        instance.model_from_joint.push_back(pose.model_from_node[skin.joints[i]] *
                                            skin.joint_from_mesh[i]);
    }
    return instance;
}

/// Inverse transpose; zero for transforms that flatten: such normals are made from the triangles.
Mat3f normal_matrix_of(const Mat4f& matrix) {
    const Mat3f linear{matrix};
    return std::abs(glm::determinant(linear)) > 1e-20F ? glm::transpose(glm::inverse(linear))
                                                       : Mat3f{0.0F};
}

/// The matrix that moves vertex i: its joints' mean, or the node's.
Mat4f matrix_at(const Instance& instance, std::size_t i) {
    if (instance.model_from_joint.empty()) return instance.model_from_mesh;
    const JointInfluence& influence = instance.mesh->influences[i];
    Mat4f sum{0.0F};
    for (std::size_t k = 0; k < 4; ++k) {
        // Files may name joints that their skin lacks; those weigh nothing.
        const std::size_t joint = influence.joints[k];
        if (influence.weights[k] <= 0.0F || joint >= instance.model_from_joint.size()) continue;
        sum += instance.model_from_joint[joint] * influence.weights[k];
    }
    return sum[3][3] > 0.0F ? sum / sum[3][3] : instance.model_from_mesh;
}

/// Position and normal of vertex i with its targets mixed in, in the mesh's frame.
Vertex morphed(const Instance& instance, std::size_t i) {
    Vertex vertex = instance.mesh->vertices[i];
    const std::vector<float>& weights = *instance.morph_weights;
    for (std::size_t t = 0; t < std::min(weights.size(), instance.mesh->targets.size()); ++t) {
        if (weights[t] == 0.0F) continue;
        const MorphTarget& target = instance.mesh->targets[t];
        vertex.position_body += target.positions[i] * weights[t];
        if (!target.normals.empty()) vertex.normal_body += target.normals[i] * weights[t];
    }
    return vertex;
}

/// Vertices in the model's frame.
std::vector<Vertex> vertices_of(const Instance& instance) {
    const bool skinned = !instance.model_from_joint.empty();
    const Mat3f node_normals = normal_matrix_of(instance.model_from_mesh);
    std::vector<Vertex> vertices(instance.mesh->vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        Vertex& vertex = vertices[i];
        vertex = morphed(instance, i);
        const Mat4f matrix = skinned ? matrix_at(instance, i) : instance.model_from_mesh;
        const Mat3f normals = skinned ? normal_matrix_of(matrix) : node_normals;
        vertex.position_body = Vec3f{matrix * Vec4f{vertex.position_body, 1.0F}};
        const Vec3f normal = normals * vertex.normal_body;
        vertex.normal_body = is_finite(normal) ? normalize_or(normal, Vec3f{0.0F}) : Vec3f{0.0F};
    }
    return vertices;
}

/// Why vertices cannot be used; empty when they can.
std::string position_fault(const std::vector<Vertex>& vertices) {
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const Vec3f& position = vertices[i].position_body;
        if (!is_finite(position)) return fmt::format("its vertex {} is not finite", i);
        const Vec3f distance = glm::abs(position);
        if (std::max({distance.x, distance.y, distance.z}) >
            static_cast<float>(limits::kPosition_m)) {
            return fmt::format("its vertex {} lies beyond {} m", i, limits::kPosition_m);
        }
    }
    return {};
}

/// The triangles worth drawing, wound for the transform.
std::vector<std::uint32_t> indices_of(const Instance& instance,
                                      const std::vector<Vertex>& vertices,
                                      std::size_t& without_area) {
    const bool mirrored = instance.model_from_joint.empty() &&
                          glm::determinant(Mat3f{instance.model_from_mesh}) < 0.0F;
    const std::vector<std::uint32_t>& source = instance.mesh->indices;
    std::vector<std::uint32_t> indices;
    indices.reserve(source.size());
    for (std::size_t i = 0; i + 2 < source.size(); i += 3) {
        const std::uint32_t a = source[i];
        const std::uint32_t b = source[i + (mirrored ? 2 : 1)];
        const std::uint32_t c = source[i + (mirrored ? 1 : 2)];
        const Vec3f& corner = vertices[a].position_body;
        const Vec3f area =
            glm::cross(vertices[b].position_body - corner, vertices[c].position_body - corner);
        if (area == Vec3f{0.0F}) {
            ++without_area;
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

enum class MissingNormals { FlatWhereAll, Smooth };

/// Replaces normals that are zero or not finite by the mean of their triangles'.
void mend_normals(MeshData& part, MissingNormals how) {
    const auto missing = [](const Vertex& vertex) { return vertex.normal_body == Vec3f{0.0F}; };
    const auto count = std::count_if(part.vertices.begin(), part.vertices.end(), missing);
    if (count == 0) return;
    if (how == MissingNormals::FlatWhereAll &&
        static_cast<std::size_t>(count) == part.vertices.size()) {
        make_flat(part);
        return;
    }
    MeshData made{.vertices = part.vertices, .indices = part.indices};
    compute_normals(made);
    for (std::size_t i = 0; i < part.vertices.size(); ++i) {
        if (missing(part.vertices[i])) part.vertices[i].normal_body = made.vertices[i].normal_body;
    }
}

void append(MeshData& mesh, const MeshData& part) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), part.vertices.begin(), part.vertices.end());
    for (const std::uint32_t index : part.indices) mesh.indices.push_back(first + index);
}

/// Adds one instance to the merged mesh. False when it was left out.
bool add_instance(MeshData& mesh, const Instance& instance, const std::string& name) {
    std::size_t without_area = 0;
    MeshData part;
    part.vertices = vertices_of(instance);
    const std::string fault = position_fault(part.vertices);
    if (!fault.empty()) {
        log_warning("model {}: mesh \"{}\" is left out: {}", name, instance.mesh->name, fault);
        return false;
    }
    part.indices = indices_of(instance, part.vertices, without_area);
    if (without_area > 0) {
        // A few come with most models; many mean that something is wrong with this one.
        const bool many = without_area * 30 > instance.mesh->indices.size();
        log_line(many ? LogLevel::Warning : LogLevel::Debug,
                 fmt::format("model {}: mesh \"{}\": {} faces without area are left out",
                             name,
                             instance.mesh->name,
                             without_area));
    }
    mend_normals(part, MissingNormals::FlatWhereAll);
    append(mesh, part);
    return !part.indices.empty();
}

}  // namespace

MeshData merged_mesh(const ModelData& model,
                     std::vector<ModelPart> parts,
                     const ModelPose& pose,
                     const std::string& name) {
    const auto material = [&](const ModelPart& part) { return model.meshes[part.mesh].material; };
    std::stable_sort(parts.begin(), parts.end(), [&](const ModelPart& a, const ModelPart& b) {
        return material(a) < material(b);
    });
    MeshData mesh;
    for (const ModelPart& part : parts) {
        const auto first = static_cast<std::uint32_t>(mesh.indices.size());
        if (!add_instance(mesh, instance_of(model, part, pose), name)) continue;
        const auto count = static_cast<std::uint32_t>(mesh.indices.size()) - first;
        std::vector<SubMesh>& runs = mesh.sub_meshes;
        if (!runs.empty() && runs.back().material == material(part)) {
            runs.back().index_count += count;
        } else {
            runs.push_back(
                {.first_index = first, .index_count = count, .material = material(part)});
        }
    }
    mesh.bounds = bounds_of(mesh);
    compute_tangents(mesh);
    return mesh;
}

MeshData merged_mesh(const ModelData& model, const ModelPose& pose, const std::string& name) {
    std::vector<ModelPart> parts;
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        for (const std::uint32_t mesh : model.nodes[i].meshes) {
            parts.push_back({.node = static_cast<std::uint32_t>(i), .mesh = mesh});
        }
    }
    return merged_mesh(model, std::move(parts), pose, name);
}

Aabb bounds_of(const ModelData& model, const ModelPose& pose) {
    Aabb bounds;
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        for (const std::uint32_t mesh : model.nodes[i].meshes) {
            const ModelPart part{.node = static_cast<std::uint32_t>(i), .mesh = mesh};
            const std::vector<Vertex> vertices = vertices_of(instance_of(model, part, pose));
            if (!position_fault(vertices).empty()) continue;  // is not drawn either
            for (const Vertex& vertex : vertices) bounds.include(vertex.position_body);
        }
    }
    return bounds;
}

MeshData still_mesh(const ModelData& model, const ModelParts& parts, const std::string& name) {
    return merged_mesh(model, parts.still, rest_pose(model), name);
}

MeshData part_mesh(const ModelData& model, const ModelPart& part, const ModelPose& pose) {
    const ModelMesh& source = model.meshes[part.mesh];
    Instance instance = instance_of(model, part, pose);
    if (!part.deforms) instance.model_from_mesh = Mat4f{1.0F};
    MeshData mesh{.vertices = vertices_of(instance), .indices = source.indices};
    // Vertices of a deforming mesh stay one for one with the file's.
    mend_normals(mesh, part.deforms ? MissingNormals::Smooth : MissingNormals::FlatWhereAll);
    mesh = finished(std::move(mesh));
    mesh.sub_meshes.front().material = source.material;
    return mesh;
}

void deform(const ModelData& model, const ModelPart& part, const ModelPose& pose, MeshData& mesh) {
    const std::vector<Vertex> posed = vertices_of(instance_of(model, part, pose));
    for (std::size_t i = 0; i < std::min(posed.size(), mesh.vertices.size()); ++i) {
        if (!is_finite(posed[i].position_body)) continue;  // a pose that overflows is not drawn
        mesh.vertices[i].position_body = posed[i].position_body;
        if (posed[i].normal_body != Vec3f{0.0F}) {
            mesh.vertices[i].normal_body = posed[i].normal_body;
        }
    }
    mesh.bounds = bounds_of(mesh);
}

}  // namespace plumbline::assets
