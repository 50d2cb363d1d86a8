// The models that we ship.

#include "tests/engine/assets/fixture.h"

#include <set>

namespace plumbline::assets::test {
namespace {

const fs::path kAssets = fs::path(PL_SOURCE_DIR) / "assets";

TEST(GardenModels, all_load_without_a_line_of_log) {
    std::size_t count = 0;
    for (const auto& entry : fs::recursive_directory_iterator(kAssets / "models")) {
        if (entry.is_directory()) continue;
        const Import import(entry.path(), kAssets);
        ASSERT_TRUE(import.ok()) << import.error();
        EXPECT_EQ(import.log, "");
        ++count;
        std::uint32_t next = 0;
        for (const SubMesh& run : import.mesh().sub_meshes) {
            EXPECT_EQ(run.first_index, next);
            EXPECT_LT(run.material, import.materials().size());
            next += run.index_count;
        }
        EXPECT_EQ(next, import.mesh().indices.size()) << entry.path();
        for (const Vertex& vertex : import.mesh().vertices) {
            ASSERT_NEAR(glm::length(vertex.normal_body), 1, 1e-3) << entry.path();
            ASSERT_NEAR(glm::dot(Vec3f{vertex.tangent_body}, vertex.normal_body), 0, 1e-3);
        }
    }
    EXPECT_GE(count, 10U);
}

TEST(GardenModels, house_keeps_its_materials_by_name) {
    const Import import(kAssets / "models/house.glb", kAssets);
    ASSERT_TRUE(import.ok()) << import.error();
    std::set<std::string> names;
    for (const MaterialData& material : import.materials()) names.insert(material.name);
    EXPECT_EQ(names,
              (std::set<std::string>{"brick",
                                     "glass",
                                     "iron",
                                     "oak",
                                     "plaster",
                                     "roof",
                                     "stone",
                                     "vcol_floor",
                                     "vcol_plaster",
                                     "vcol_tiles",
                                     "wood"}));
    EXPECT_EQ(import.mesh().sub_meshes.size(), 11U);
}

TEST(GardenModels, trees_are_not_tinted_by_their_wind_weights_and_flowers_have_colours) {
    const Import tree(kAssets / "models/tree_oak.glb", kAssets);
    ASSERT_TRUE(tree.ok()) << tree.error();
    for (const Vertex& vertex : tree.mesh().vertices) ASSERT_EQ(vertex.color, Vec3f(1, 1, 1));
    EXPECT_EQ(tree.materials()[1].alpha_mode, AlphaMode::Mask);
    const Import flowers(kAssets / "models/flowers_tulip.glb", kAssets);
    ASSERT_TRUE(flowers.ok()) << flowers.error();
    std::size_t coloured = 0;
    for (const Vertex& vertex : flowers.mesh().vertices) {
        if (vertex.color != Vec3f(1, 1, 1)) ++coloured;
    }
    EXPECT_EQ(coloured, flowers.mesh().vertices.size());
}

}  // namespace
}  // namespace plumbline::assets::test
