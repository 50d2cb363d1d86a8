// What is drawn of a soft body: its faces, or a model that its cells carry along.
#include "engine/scene/build/soft_mesh.h"

#include "engine/physics/soft_grid.h"

#include <gtest/gtest.h>

namespace plumbline::scene {
namespace {

// A box's faces keep their edges, an ellipsoid's are smooth.
TEST(SoftMesh, FacesOfOneSideShareTheirNormals) {
    const physics::SoftGrid box = physics::box_grid({1, 1, 1}, {2, 2, 2});
    const SoftFaces faces(box);
    assets::MeshData mesh = faces.mesh();
    faces.shape(box.points_m, mesh);
    EXPECT_EQ(mesh.vertices.size(), 6U * 9U);
    for (const assets::Vertex& vertex : mesh.vertices) {
        EXPECT_NEAR(glm::length(vertex.normal_body), 1, 1e-5);
        EXPECT_NEAR(glm::dot(vertex.normal_body, vertex.position_body), 0.5, 1e-5);
    }
    const physics::SoftGrid ball = physics::ellipsoid_grid({1, 1, 1}, {4, 4, 4});
    EXPECT_EQ(SoftFaces(ball).mesh().vertices.size(), 98U);
}

TEST(SoftMesh, AModelMovesWithItsCells) {
    const physics::SoftGrid grid = physics::box_grid({1, 1, 1}, {2, 2, 2});
    assets::MeshData model = SoftFaces(physics::box_grid({0.8, 0.8, 0.8}, {1, 1, 1})).mesh();
    const SoftModel skin(grid, model);
    std::vector<Vec3d> points = grid.points_m;
    for (Vec3d& point : points) point = Vec3d{2 * point.x, point.y, point.z + 3};
    assets::MeshData moved = model;
    skin.shape(points, moved);
    for (std::size_t i = 0; i < model.vertices.size(); ++i) {
        const Vec3f rest = model.vertices[i].position_body;
        EXPECT_NEAR(
            glm::distance(moved.vertices[i].position_body, Vec3f{2 * rest.x, rest.y, rest.z + 3}),
            0,
            1e-5);
    }
}

TEST(SoftMesh, KnowsInsideFromOutside) {
    const assets::MeshData box = SoftFaces(physics::box_grid({1, 1, 1}, {3, 3, 3})).mesh();
    EXPECT_TRUE(is_inside(box, {0.01, 0.02, 0.03}));
    EXPECT_FALSE(is_inside(box, {0.61, 0.02, 0.03}));
    EXPECT_FALSE(is_inside(box, {-0.61, 0.02, 0.03}));
    EXPECT_FALSE(is_inside(box, {0, 0.62, 0.03}));
}

}  // namespace
}  // namespace plumbline::scene
