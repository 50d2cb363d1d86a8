#include "engine/render/culling/mesh_lods.h"

#include "engine/assets/primitives.h"
#include "tests/engine/render/card_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace plumbline::render {
namespace {

using assets::MeshData;

std::uint32_t triangles_of(const MeshLod& lod) {
    std::uint32_t count = 0;
    for (const assets::SubMesh& part : lod.sub_meshes) count += part.index_count / 3;
    return count;
}

float area_of(const MeshData& mesh, const std::vector<assets::SubMesh>& parts) {
    float area = 0.0F;
    for (const assets::SubMesh& part : parts) {
        for (std::uint32_t i = part.first_index; i < part.first_index + part.index_count; i += 3) {
            const Vec3f a = mesh.vertices[mesh.indices[i]].position_body;
            const Vec3f b = mesh.vertices[mesh.indices[i + 1]].position_body;
            const Vec3f c = mesh.vertices[mesh.indices[i + 2]].position_body;
            area += 0.5F * glm::length(glm::cross(b - a, c - a));
        }
    }
    return area;
}

/// In rows.
MeshData cards(int count) {
    std::vector<Vec3f> corners_m;
    for (int i = 0; i < count; ++i)
        corners_m.push_back(
            {0.37F * static_cast<float>(i % 20), 0.41F * static_cast<float>(i / 20), 0.0F});
    return card_mesh(corners_m);
}

TEST(MeshLods, CheapMeshesHaveNone) {
    MeshData box = assets::box_mesh(Vec3f{1.0F});
    const std::size_t before = box.indices.size();
    EXPECT_TRUE(add_lods(box, {}).empty());
    EXPECT_EQ(box.indices.size(), before);
}

TEST(MeshLods, EachIsCoarserAndTheFullMeshStays) {
    MeshData ball = assets::sphere_mesh(1.0F);
    const MeshData before = ball;
    const auto lods = add_lods(ball, {});
    EXPECT_TRUE(std::equal(before.indices.begin(), before.indices.end(), ball.indices.begin()));
    std::size_t triangles = before.indices.size() / 3;
    float error_m = 0.0F;
    for (const MeshLod& lod : lods) {
        EXPECT_LT(triangles_of(lod), triangles);
        EXPECT_GT(lod.error_m, error_m);
        triangles = triangles_of(lod);
        error_m = lod.error_m;
        // It is still that ball: no corner is off it, and little of its skin is lost.
        for (const assets::SubMesh& part : lod.sub_meshes) {
            for (std::uint32_t i = 0; i < part.index_count; ++i) {
                const std::uint32_t vertex = ball.indices[part.first_index + i];
                EXPECT_NEAR(glm::length(ball.vertices[vertex].position_body), 1.0F, 1e-4F);
            }
        }
        EXPECT_GT(area_of(ball, lod.sub_meshes), 0.9F * area_of(before, before.sub_meshes));
    }
}

TEST(MeshLods, AFineGridLosesWhatCannotBeSeen) {
    // 100 x 100 squares of 1 cm: 1.41 m across. The coarsest version may be 3.8 cm off.
    MeshData sheet;
    for (std::uint32_t z = 0; z <= 100; ++z) {
        for (std::uint32_t x = 0; x <= 100; ++x) {
            assets::Vertex vertex;
            vertex.position_body =
                Vec3f{0.01F * static_cast<float>(x), 0.0F, 0.01F * static_cast<float>(z)};
            sheet.vertices.push_back(vertex);
        }
    }
    for (std::uint32_t z = 0; z < 100; ++z) {
        for (std::uint32_t x = 0; x < 100; ++x) {
            const std::uint32_t i = z * 101 + x;
            for (const std::uint32_t k : {0U, 101U, 1U, 1U, 101U, 102U})
                sheet.indices.push_back(i + k);
        }
    }
    sheet.sub_meshes = {{0, static_cast<std::uint32_t>(sheet.indices.size()), 0}};
    sheet.bounds = assets::bounds_of(sheet);
    const auto lods = add_lods(sheet, {});
    ASSERT_FALSE(lods.empty());
    EXPECT_LT(triangles_of(lods.back()), 20'000U / 3U);
    EXPECT_GT(area_of(sheet, lods.back().sub_meshes), 0.9F);
}

TEST(MeshLods, FewerCardsAreLargerAndCoverAsMuch) {
    MeshData crown = cards(1000);
    const float full = area_of(crown, crown.sub_meshes);
    const auto lods = add_lods(crown, {true});
    ASSERT_EQ(lods.size(), 4U);
    const std::array<float, 4> kept{0.4F, 0.25F, 0.15F, 0.09F};
    for (std::size_t i = 0; i < lods.size(); ++i) {
        EXPECT_NEAR(static_cast<float>(triangles_of(lods[i])) / 2000.0F, kept[i], 0.04F);
        const float covered = area_of(crown, lods[i].sub_meshes) / full;
        EXPECT_GT(covered, 0.55F);
        EXPECT_LT(covered, 1.1F);
    }
}

TEST(MeshLods, FewCardsAllStay) {
    MeshData tuft = cards(200);
    const float full = area_of(tuft, tuft.sub_meshes);
    for (const MeshLod& lod : add_lods(tuft, {true})) {
        if (lod.error_m > 0.04F) break;
        EXPECT_NEAR(area_of(tuft, lod.sub_meshes), full, 1e-3F * full);
    }
}

TEST(MeshLods, WhatIsPaintedOnVerticesStays) {
    MeshData ball = assets::sphere_mesh(1.0F);
    ball.vertices[ball.indices[100]].color = Vec3f{0.5F};
    EXPECT_TRUE(add_lods(ball, {}).empty());
}

TEST(MeshLods, LoosePiecesOfWhatIsNoFoliageAllStay) {
    // Tiles of a roof: none may be missing, however coarse. Cards of 10 cm are cells of their own.
    MeshData roof = cards(400);
    const float full = area_of(roof, roof.sub_meshes);
    for (const MeshLod& lod : add_lods(roof, {false})) {
        if (lod.error_m > 0.04F) break;
        EXPECT_NEAR(area_of(roof, lod.sub_meshes), full, 1e-3F * full);
    }
}

TEST(MeshLods, WhatHasNoSizeHasNone) {
    MeshData point = cards(400);
    for (auto& vertex : point.vertices) vertex.position_body = Vec3f{0.0F};
    point.bounds = assets::bounds_of(point);
    EXPECT_TRUE(add_lods(point, {true}).empty());
}

}  // namespace
}  // namespace plumbline::render
