// Surfaces of water: flat grids that look upwards, and the waves on them.
#include "engine/scene/build/water_mesh.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::scene {
namespace {

TEST(WaterMesh, LooksUpwards) {
    const assets::MeshData mesh = water_mesh({-2, -1, -1}, {2, 0.5, 1}, 4);
    EXPECT_EQ(mesh.vertices.size(), 25U);
    EXPECT_EQ(mesh.sub_meshes[0].index_count, 4U * 4U * 6U);
    double area_m2 = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Vec3f& a = mesh.vertices[mesh.indices[i]].position_body;
        const Vec3f up = glm::cross(mesh.vertices[mesh.indices[i + 1]].position_body - a,
                                    mesh.vertices[mesh.indices[i + 2]].position_body - a);
        EXPECT_GT(up.y, 0);
        EXPECT_FLOAT_EQ(a.y, 0.5F);
        area_m2 += static_cast<double>(glm::length(up)) / 2;
    }
    EXPECT_NEAR(area_m2, 8, 1e-5);
}

TEST(WaterMesh, TakesTheShapeOfTheWaves) {
    const WaterDescription water{.name = "w",
                                 .min_m = {-2, -1, -1},
                                 .max_m = {2, 0.5_r, 1},
                                 .surface = WaterSurface::Waves,
                                 .start = {.amplitude_m = 0.1_r, .nx = 1, .nz = 0}};
    const WaveField waves(water, 16, 9.81);
    assets::MeshData mesh = water_mesh(Vec3d(water.min_m), Vec3d(water.max_m), 8);
    const std::uint32_t version = mesh.version;
    std::vector<double> heights_m(81);
    waves.sample(9, 1, heights_m);
    shape_water_mesh(heights_m, 0.5, mesh);
    EXPECT_EQ(mesh.version, version + 1);
    for (const assets::Vertex& vertex : mesh.vertices) {
        const double x = static_cast<double>(vertex.position_body.x);
        const double z = static_cast<double>(vertex.position_body.z);
        EXPECT_NEAR(vertex.position_body.y, 0.5 + waves.height_m(x, z), 1e-6);
        const glm::dvec2 slope = waves.slope(x, z);
        if (std::abs(x) < 1.9) {
            EXPECT_NEAR(vertex.normal_body.x / vertex.normal_body.y, -slope.x, 0.003);
        }
        EXPECT_NEAR(vertex.normal_body.z, 0, 1e-5);
    }
}

}  // namespace
}  // namespace plumbline::scene
