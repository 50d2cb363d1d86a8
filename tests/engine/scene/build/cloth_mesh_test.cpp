// What is drawn of a sheet: both faces, half of its thickness out, without torn cells.
#include "engine/scene/build/cloth_mesh.h"

#include <gtest/gtest.h>

namespace plumbline::scene {
namespace {

TEST(ClothMesh, HasBothFaces) {
    const physics::Sheet sheet({.size_m = {2, 1}, .cells = {4, 2}});
    assets::MeshData mesh = cloth_mesh(sheet);
    const std::uint32_t version = mesh.version;
    shape_cloth_mesh(sheet, sheet.positions_m(), 0.02F, mesh);
    EXPECT_EQ(mesh.version, version + 1);
    ASSERT_EQ(mesh.vertices.size(), 30U);
    EXPECT_EQ(mesh.indices.size(), 8U * 2U * 2U * 3U);
    EXPECT_EQ(mesh.sub_meshes[0].index_count, mesh.indices.size());
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const float side = i < 15 ? 1.0F : -1.0F;
        EXPECT_NEAR(mesh.vertices[i].position_body.z, 0.01F * side, 1e-6F);
        EXPECT_NEAR(mesh.vertices[i].normal_body.z, side, 1e-6F);
    }
    // Counter-clockwise from outside.
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto& a = mesh.vertices[mesh.indices[i]];
        const Vec3f across =
            glm::cross(mesh.vertices[mesh.indices[i + 1]].position_body - a.position_body,
                       mesh.vertices[mesh.indices[i + 2]].position_body - a.position_body);
        EXPECT_GT(glm::dot(across, a.normal_body), 0);
    }
    EXPECT_NEAR(mesh.bounds.max.x, 1, 1e-6);
}

TEST(ClothMesh, TornCellsAreHoles) {
    physics::Sheet sheet({.cells = {2, 2}, .tear_Npm = 100});
    assets::MeshData mesh = cloth_mesh(sheet);
    sheet.plan(1e-3, 1);
    sheet.change_velocity(0, {-100, 0, 0});
    sheet.move(sheet.substep_s());
    EXPECT_EQ(sheet.torn(), 1U);
    shape_cloth_mesh(sheet, sheet.positions_m(), 0.01F, mesh);
    EXPECT_EQ(mesh.indices.size(), 3U * 2U * 2U * 3U);
}

}  // namespace
}  // namespace plumbline::scene
