// assimp's scenes, made by hand, as nodes and triangles of ours.
#include "engine/assets/foreign/model_convert_impl.h"
#include "tests/engine/assets/fixture.h"
#include "tests/engine/assets/foreign/foreign_scenes.h"

#include <limits>

namespace plumbline::assets::test {
namespace {

TEST(ModelConvert, keeps_the_tree_in_the_files_order_with_places_and_lets_v_run_down) {
    const auto scene = foreign_scene({foreign_mesh("plate", 0)});
    const ConvertedScene converted = convert_tree(*scene, {{.name = "paint"}}, "m.dae");
    const ModelData& model = converted.model;
    ASSERT_EQ(model.nodes.size(), 3U);
    EXPECT_EQ(model.nodes[0].name, "root");
    EXPECT_EQ(model.nodes[1].name, "first");
    EXPECT_EQ(model.nodes[2].name, "second");
    EXPECT_EQ(model.nodes[2].parent, 0U);
    EXPECT_EQ(model.nodes[2].meshes, std::vector<std::uint32_t>{0});
    EXPECT_EQ(model.nodes[2].rest.translation, Vec3f(5, 6, 7));
    EXPECT_EQ(model.nodes[2].rest.scale, Vec3f(1, 2, 1));
    EXPECT_EQ(Vec3f{model.nodes[2].parent_from_node[3]}, Vec3f(5, 6, 7));
    ASSERT_EQ(model.meshes.size(), 1U);
    EXPECT_EQ(model.meshes[0].indices, (std::vector<std::uint32_t>{0, 1, 2})) << "the line goes";
    EXPECT_EQ(model.meshes[0].vertices[0].uv, Vec2f(0.25F, 0.75F));
    EXPECT_EQ(model.meshes[0].vertices[1].uv, Vec2f(0, 0)) << "not finite";
    EXPECT_EQ(model.meshes[0].vertices[0].normal_body, Vec3f(0)) << "to be made";
    EXPECT_FALSE(model.materials[0].vertex_colors);
}

TEST(ModelConvert, leaves_out_meshes_that_are_no_good_and_keeps_the_others_numbers) {
    aiMesh* absent = foreign_mesh("absent", 0);
    absent->mFaces[0].mIndices[2] = 3;
    aiMesh* nan = foreign_mesh("nan", 0);
    nan->mVertices[1].x = std::numeric_limits<float>::quiet_NaN();
    const auto scene = foreign_scene({absent, nan, foreign_mesh("good", 0)});
    ::testing::internal::CaptureStderr();
    const ConvertedScene converted = convert_tree(*scene, {{.name = "paint"}}, "m.dae");
    const std::string log = ::testing::internal::GetCapturedStderr();
    EXPECT_TRUE(
        contains(log, "model m.dae: mesh \"absent\" is left out: it has no usable triangles"))
        << log;
    EXPECT_TRUE(contains(log, "mesh \"nan\" is left out: its vertex 1 is not finite")) << log;
    ASSERT_EQ(converted.model.meshes.size(), 1U);
    EXPECT_EQ(converted.meshes,
              (std::vector<std::optional<std::uint32_t>>{std::nullopt, std::nullopt, 0U}));
    EXPECT_EQ(converted.model.nodes[2].meshes, std::vector<std::uint32_t>{0});
}

TEST(ModelConvert, gives_one_plain_material_to_meshes_without_their_own) {
    aiMesh* colored = foreign_mesh("colored", 9);
    colored->mColors[0] = new aiColor4D[3]{{1, 1, 1, 1}, {-1, 0.5F, 2, 1}, {NAN, 0, 0, 1}};
    const auto scene = foreign_scene({foreign_mesh("a", 0), foreign_mesh("b", 1), colored});
    const ModelData model = convert_tree(*scene, {{.name = "paint"}}, "m.dae").model;
    ASSERT_EQ(model.materials.size(), 2U);
    EXPECT_EQ(model.materials[1].name, "default");
    EXPECT_EQ(model.meshes[0].material, 0U);
    EXPECT_EQ(model.meshes[1].material, 1U);
    EXPECT_EQ(model.meshes[2].material, 1U);
    EXPECT_EQ(model.meshes[2].vertices[1].color, Vec3f(0, 0.5F, 2));
    EXPECT_EQ(model.meshes[2].vertices[2].color, Vec3f(1)) << "not finite";
    EXPECT_FALSE(model.materials[0].vertex_colors);
    EXPECT_TRUE(model.materials[1].vertex_colors);
}

}  // namespace
}  // namespace plumbline::assets::test
