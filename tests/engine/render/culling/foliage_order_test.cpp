#include "engine/render/culling/foliage_order.h"

#include "tests/engine/render/card_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <vector>

namespace plumbline::render {
namespace {

/// A crown: cards of two triangles, spread over a ball of radius 2 m.
assets::MeshData crown_of_cards(std::uint32_t count) {
    std::vector<Vec3f> corners_m;
    for (std::uint32_t i = 0; i < count; ++i) {
        const float height = 2.0F * static_cast<float>(i) / static_cast<float>(count) - 1.0F;
        const float turn = 2.4F * static_cast<float>(i);
        const float flat = std::sqrt(1.0F - height * height);
        corners_m.push_back(
            {2.0F * flat * std::cos(turn), 2.0F * height, 2.0F * flat * std::sin(turn)});
    }
    return card_mesh(corners_m);
}

std::multiset<std::uint32_t> set_of(const std::vector<std::uint32_t>& indices,
                                    const assets::SubMesh& part) {
    const auto first = indices.begin() + part.first_index;
    return {first, first + part.index_count};
}

TEST(FoliageOrder, ASideIsTheNearestOfEight) {
    EXPECT_EQ(side_seen_from({1, 0, 0}), 0U);
    EXPECT_EQ(side_seen_from({1, 5, 0}), 0U);
    EXPECT_EQ(side_seen_from({1, 0, 1}), 1U);
    EXPECT_EQ(side_seen_from({0, 0, 9}), 2U);
    EXPECT_EQ(side_seen_from({-1, 0, 0}), 4U);
    EXPECT_EQ(side_seen_from({-1, 0, -0.01F}), 4U);
    EXPECT_EQ(side_seen_from({1, 0, -0.01F}), 0U);
}

TEST(FoliageOrder, EachSideHasAllCardsNearToFar) {
    assets::MeshData mesh = crown_of_cards(1000);
    std::vector<MeshLod> lods{{.error_m = 0.0F, .sub_meshes = mesh.sub_meshes}};
    add_foliage_order(mesh.vertices, {true}, mesh.indices, lods);
    ASSERT_EQ(lods[0].by_side.size(), kFoliageSides);
    for (std::size_t side = 0; side < kFoliageSides; ++side) {
        const assets::SubMesh& part = lods[0].by_side[side][0];
        EXPECT_EQ(set_of(mesh.indices, part), set_of(mesh.indices, mesh.sub_meshes[0]));
        const float turn = glm::two_pi<float>() * static_cast<float>(side) / kFoliageSides;
        const Vec3f to_eye{std::cos(turn), 0.0F, std::sin(turn)};
        float before = 1e9F;
        for (std::uint32_t i = 0; i < part.index_count; i += 6) {
            Vec3f center{0.0F};
            for (std::uint32_t k = 0; k < 6; ++k)
                center +=
                    mesh.vertices[mesh.indices[part.first_index + i + k]].position_body / 6.0F;
            const float nearness = glm::dot(center, to_eye);
            EXPECT_LE(nearness, before + 1e-4F);
            before = nearness;
        }
    }
}

TEST(FoliageOrder, VersionsThatShareTheirLeavesShareTheirOrder) {
    assets::MeshData mesh = crown_of_cards(600);
    std::vector<MeshLod> lods{{.error_m = 0.0F, .sub_meshes = mesh.sub_meshes},
                              {.error_m = 0.1F, .sub_meshes = mesh.sub_meshes}};
    add_foliage_order(mesh.vertices, {true}, mesh.indices, lods);
    EXPECT_EQ(mesh.indices.size(), 3600U * (1 + kFoliageSides));
    EXPECT_EQ(lods[0].by_side[3][0].first_index, lods[1].by_side[3][0].first_index);
}

TEST(FoliageOrder, WhatIsNoFoliageOrSparseStays) {
    assets::MeshData mesh = crown_of_cards(1000);
    std::vector<MeshLod> lods{{.error_m = 0.0F, .sub_meshes = mesh.sub_meshes}};
    add_foliage_order(mesh.vertices, {false}, mesh.indices, lods);
    EXPECT_TRUE(lods[0].by_side.empty());
    assets::MeshData tuft = crown_of_cards(30);
    lods = {{.error_m = 0.0F, .sub_meshes = tuft.sub_meshes}};
    add_foliage_order(tuft.vertices, {true}, tuft.indices, lods);
    EXPECT_TRUE(lods[0].by_side.empty());
}

}  // namespace
}  // namespace plumbline::render
