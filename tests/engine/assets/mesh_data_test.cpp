// Normals and tangents of hand-made triangles.

#include "engine/assets/mesh_data.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::assets {
namespace {

/// A unit square in the xy plane, facing +z, with texture coordinates as given for its corners
/// (0,0) (1,0) (1,1) (0,1).
MeshData square(const std::array<Vec2f, 4>& uv) {
    MeshData mesh;
    const std::array<Vec3f, 4> corners{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}};
    for (std::size_t i = 0; i < 4; ++i) {
        mesh.vertices.push_back(
            {.position_body = corners[i], .normal_body = {0, 0, 1}, .uv = uv[i]});
    }
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

TEST(Tangents, follow_u_with_plus_one_where_the_image_stands_upright) {
    MeshData mesh = square({{{0, 1}, {1, 1}, {1, 0}, {0, 0}}});
    compute_tangents(mesh);
    for (const Vertex& vertex : mesh.vertices) {
        EXPECT_NEAR(glm::length(vertex.tangent_body - Vec4f(1, 0, 0, 1)), 0, 1e-6);
    }
}

TEST(Tangents, have_minus_one_where_the_image_is_mirrored) {
    MeshData mesh = square({{{1, 1}, {0, 1}, {0, 0}, {1, 0}}});
    compute_tangents(mesh);
    for (const Vertex& vertex : mesh.vertices) {
        EXPECT_NEAR(glm::length(vertex.tangent_body - Vec4f(-1, 0, 0, -1)), 0, 1e-6);
    }
}

TEST(Tangents, turn_with_the_image) {
    // The image lies on its side: u runs up.
    MeshData mesh = square({{{0, 0}, {0, 1}, {1, 1}, {1, 0}}});
    compute_tangents(mesh);
    for (const Vertex& vertex : mesh.vertices) {
        EXPECT_NEAR(glm::length(vertex.tangent_body - Vec4f(0, 1, 0, 1)), 0, 1e-6);
    }
}

TEST(Tangents, are_orthogonal_to_the_normal_without_texture_coordinates) {
    MeshData mesh = square({});
    mesh.vertices[0].normal_body = {1, 0, 0};
    compute_tangents(mesh);
    for (const Vertex& vertex : mesh.vertices) {
        const Vec3f tangent{vertex.tangent_body};
        EXPECT_NEAR(glm::length(tangent), 1, 1e-6);
        EXPECT_NEAR(glm::dot(tangent, vertex.normal_body), 0, 1e-6);
    }
}

TEST(Normals, are_weighted_by_area) {
    // Two triangles share the edge on the z axis: one of area 1 facing +y, one of area 2 facing +x.
    MeshData mesh;
    for (const Vec3f& corner : {Vec3f{0, 0, 0}, Vec3f{0, 0, 1}, Vec3f{2, 0, 0}, Vec3f{0, 4, 0}}) {
        mesh.vertices.push_back({.position_body = corner});
    }
    mesh.indices = {0, 1, 2, 0, 3, 1};
    compute_normals(mesh);
    const Vec3f shared = mesh.vertices[0].normal_body;
    EXPECT_NEAR(shared.x, 2 / std::sqrt(5.0), 1e-6);
    EXPECT_NEAR(shared.y, 1 / std::sqrt(5.0), 1e-6);
    EXPECT_NEAR(shared.z, 0, 1e-6);
    EXPECT_EQ(mesh.vertices[2].normal_body, Vec3f(0, 1, 0));
    EXPECT_EQ(mesh.vertices[3].normal_body, Vec3f(1, 0, 0));
}

TEST(Bounds, hold_every_vertex) {
    const Aabb bounds = bounds_of(square({}));
    EXPECT_EQ(bounds.min, Vec3f(0, 0, 0));
    EXPECT_EQ(bounds.max, Vec3f(1, 1, 0));
    EXPECT_TRUE(bounds_of(MeshData{}).empty());
}

}  // namespace
}  // namespace plumbline::assets
