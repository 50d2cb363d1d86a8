#include "engine/assets/mesh_data.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plumbline::assets {
namespace {

/// Some unit vector orthogonal to a unit normal.
Vec3f any_tangent(const Vec3f& normal) {
    const Vec3f axis = std::abs(normal.x) < 0.9F ? Vec3f{1, 0, 0} : Vec3f{0, 0, 1};
    return glm::normalize(axis - normal * glm::dot(axis, normal));
}

float angle_between(const Vec3f& a, const Vec3f& b) {
    const float lengths = glm::length(a) * glm::length(b);
    if (!(lengths > 0.0F)) return 0.0F;
    return std::acos(std::clamp(glm::dot(a, b) / lengths, -1.0F, 1.0F));
}

/// Which way +u and -v run over one triangle; both zero where its texture area is.
struct TriangleFrame {
    Vec3f along_u{0.0F};
    Vec3f up_image{0.0F};
};

TriangleFrame frame_of(const Vertex& a, const Vertex& b, const Vertex& c) {
    const Vec3f edge_b = b.position_body - a.position_body;
    const Vec3f edge_c = c.position_body - a.position_body;
    const Vec2f uv_b = b.uv - a.uv;
    const Vec2f uv_c = c.uv - a.uv;
    const float area = uv_b.x * uv_c.y - uv_c.x * uv_b.y;
    if (area == 0.0F) return {};
    const float sign = area > 0.0F ? 1.0F : -1.0F;
    const Vec3f along_u = (edge_b * uv_c.y - edge_c * uv_b.y) * sign;
    const Vec3f along_v = (edge_c * uv_b.x - edge_b * uv_c.x) * sign;
    return {.along_u = normalize_or(along_u, Vec3f{0.0F}),
            .up_image = -normalize_or(along_v, Vec3f{0.0F})};
}

}  // namespace

bool sways(const MeshData& mesh) {
    return std::ranges::any_of(mesh.vertices,
                               [](const Vertex& vertex) { return vertex.wind != WindWeights{}; });
}

Aabb bounds_of(const MeshData& mesh) {
    Aabb bounds;
    for (const Vertex& vertex : mesh.vertices) bounds.include(vertex.position_body);
    return bounds;
}

void compute_normals(MeshData& mesh) {
    for (Vertex& vertex : mesh.vertices) vertex.normal_body = Vec3f{0.0F};
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        Vertex& a = mesh.vertices[mesh.indices[i]];
        Vertex& b = mesh.vertices[mesh.indices[i + 1]];
        Vertex& c = mesh.vertices[mesh.indices[i + 2]];
        const Vec3f twice_area =
            glm::cross(b.position_body - a.position_body, c.position_body - a.position_body);
        a.normal_body += twice_area;
        b.normal_body += twice_area;
        c.normal_body += twice_area;
    }
    for (Vertex& vertex : mesh.vertices) {
        vertex.normal_body = normalize_or(vertex.normal_body, Vec3f{0, 1, 0});
    }
}

void compute_tangents(MeshData& mesh) {
    const bool has_uv = std::any_of(mesh.vertices.begin(),
                                    mesh.vertices.end(),
                                    [](const Vertex& vertex) { return vertex.uv != Vec2f{0.0F}; });
    if (!has_uv) {
        for (Vertex& vertex : mesh.vertices) {
            vertex.tangent_body = Vec4f{any_tangent(vertex.normal_body), 1.0F};
        }
        return;
    }
    std::vector<TriangleFrame> sums(mesh.vertices.size());
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const std::array<std::uint32_t, 3> corner{
            mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]};
        const TriangleFrame frame =
            frame_of(mesh.vertices[corner[0]], mesh.vertices[corner[1]], mesh.vertices[corner[2]]);
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3f& here = mesh.vertices[corner[k]].position_body;
            const float weight =
                angle_between(mesh.vertices[corner[(k + 1) % 3]].position_body - here,
                              mesh.vertices[corner[(k + 2) % 3]].position_body - here);
            sums[corner[k]].along_u += frame.along_u * weight;
            sums[corner[k]].up_image += frame.up_image * weight;
        }
    }
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        Vertex& vertex = mesh.vertices[i];
        const Vec3f& normal = vertex.normal_body;
        const Vec3f flat = sums[i].along_u - normal * glm::dot(normal, sums[i].along_u);
        const Vec3f tangent =
            glm::length(flat) > 1e-6F ? glm::normalize(flat) : any_tangent(normal);
        const float side = glm::dot(glm::cross(normal, tangent), sums[i].up_image);
        vertex.tangent_body = Vec4f{tangent, side < 0.0F ? -1.0F : 1.0F};
    }
}

MeshData finished(MeshData mesh) {
    mesh.sub_meshes = {{.index_count = static_cast<std::uint32_t>(mesh.indices.size())}};
    mesh.bounds = bounds_of(mesh);
    compute_tangents(mesh);
    return mesh;
}

}  // namespace plumbline::assets
