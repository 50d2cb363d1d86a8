// The tree of glTF nodes: places, order, depth and cycles.
#include "engine/assets/model/model_pose.h"
#include "engine/core/limits.h"
#include "tests/engine/assets/animation_files.h"
#include "tests/engine/assets/gltf/spoiled.h"

namespace plumbline::assets::test {
namespace {

TEST(GltfNodes, applies_transforms_down_the_tree) {
    TriangleFile file;
    // Turned a quarter about y, moved by 10 along the turned x, and both doubled by the parent.
    const double half = std::sqrt(0.5);
    file.json["nodes"] = {
        {{"scale", {2, 2, 2}}, {"children", {1}}},
        {{"mesh", 0}, {"translation", {10, 0, 0}}, {"rotation", {0, half, 0, half}}}};
    const Import import = import_bytes(file.gltf());
    ASSERT_TRUE(import.ok()) << import.error();
    const Vertex& corner = import.mesh().vertices[1];  // (1, 0, 0) goes to (0, 0, -1)
    EXPECT_NEAR(glm::length(corner.position_body - Vec3f(20, 0, -2)), 0, 1e-5);
    EXPECT_NEAR(glm::length(corner.normal_body - Vec3f(1, 0, 0)), 0, 1e-6);
}

TEST(GltfNodes, of_a_chain_of_100000_nodes) {
    Json nodes = Json::array();
    for (int i = 0; i < 99'999; ++i) nodes.push_back({{"children", {i + 1}}});
    nodes.push_back({{"mesh", 0}});
    TriangleFile file;
    file.json["nodes"] = std::move(nodes);
    expect_refused(file, "it has 100000 nodes; at most 65536 are read");
}

TEST(GltfNodes, of_nodes_nested_too_deep) {
    for (const std::size_t depth : {limits::kModelNodeDepth, limits::kModelNodeDepth + 1}) {
        TriangleFile file;
        file.json["nodes"] = Json::array();
        for (std::size_t i = 0; i + 1 < depth; ++i) {
            file.json["nodes"].push_back({{"children", {i + 1}}});
        }
        file.json["nodes"].push_back({{"mesh", 0}});
        const Import import = import_bytes(file.gltf());
        EXPECT_EQ(import.ok(), depth == limits::kModelNodeDepth) << import.error();
        if (depth > limits::kModelNodeDepth) {
            expect_refused(import, "nodes[256] is nested deeper than 256");
        }
    }
}

TEST(GltfNodes, of_more_vertices_drawn_than_the_limit_before_they_are_built) {
    TriangleFile file;
    // 200 vertices, drawn by 50,001 nodes: ten million and two hundred.
    file.primitive()["attributes"] = {
        {"POSITION", file.add_accessor(std::string(200 * 12, '\0'), 5126, 200, "VEC3")}};
    file.json["nodes"] = Json::array();
    Json& roots = file.json["scenes"][0]["nodes"] = Json::array();
    for (int i = 0; i < 50'001; ++i) {
        file.json["nodes"].push_back({{"mesh", 0}});
        roots.push_back(i);
    }
    expect_refused(file, "it draws 10000200 vertices; at most 10000000 are read");
}

std::vector<Spoiled> node_faults() {
    return {
        {"cycle",
         [](TriangleFile& f) {
             f.json["nodes"] = {{{"mesh", 0}}, {{"children", {2}}}, {{"children", {1}}}};
         },
         "its nodes form a cycle: node 1 < node 2 < node 1"},
        {"own_child",
         [](TriangleFile& f) { f.json["nodes"][0]["children"] = {0}; },
         "its nodes form a cycle: node 0 < node 0"},
        {"child_of_two",
         [](TriangleFile& f) {
             f.json["nodes"] = {{{"children", {2}}}, {{"children", {2}}}, {{"mesh", 0}}};
         },
         "node 2 is a child of node 0 and of node 1"},
        {"child_twice",
         [](TriangleFile& f) {
             f.json["nodes"] = {{{"children", {1, 1}}}, {{"mesh", 0}}};
         },
         "node 1 is a child of node 0 and of node 0"},
        {"node_7_of_1",
         [](TriangleFile& f) { f.json["nodes"][0]["children"] = {7}; },
         "nodes[0].children names node 7 of 1"},
        {"negative_child",
         [](TriangleFile& f) { f.json["nodes"][0]["children"] = {-1}; },
         "nodes[0].children holds -1; it must name nodes by number"},
        {"mesh_out_of_range",
         [](TriangleFile& f) { f.json["nodes"][0]["mesh"] = 1; },
         "nodes[0].mesh names number 1 of 1"},
        {"scene_names_a_child",
         [](TriangleFile& f) {
             f.json["nodes"] = {{{"children", {1}}}, {{"mesh", 0}}};
             f.json["scenes"][0]["nodes"] = {1};
         },
         "scenes[0].nodes names node 1, a child"},
        {"scene_names_a_node_twice",
         [](TriangleFile& f) {
             f.json["scenes"][0]["nodes"] = {0, 0};
         },
         "scenes[0].nodes names node 0 twice"},
        {"scene_out_of_range",
         [](TriangleFile& f) { f.json["scene"] = 1; },
         ".scene names number 1 of 1"},
        {"short_matrix",
         [](TriangleFile& f) {
             f.json["nodes"][0]["matrix"] = {1, 0, 0};
         },
         "nodes[0].matrix must be 16 numbers"},
        {"zero_rotation",
         [](TriangleFile& f) {
             f.json["nodes"][0]["rotation"] = {0, 0, 0, 0};
         },
         "nodes[0].rotation is zero"},
        {"huge_translation",
         [](TriangleFile& f) {
             f.json["nodes"][0]["translation"] = {1e300, 0, 0};
         },
         "nodes[0].translation must be 3 numbers"},
        {"nodes_no_array", [](TriangleFile& f) { f.json["nodes"] = 3; }, "nodes is not an array"},
        {"node_no_object",
         [](TriangleFile& f) { f.json["nodes"] = {3}; },
         "nodes[0] is not an object"}};
}

TEST(GltfNodes, come_parents_first_whatever_the_order_of_the_file) {
    TriangleFile file;
    file.json["nodes"] = {{{"name", "leaf"}, {"mesh", 0}, {"translation", {0, 1, 0}}},
                          {{"name", "root"}, {"children", {2}}, {"translation", {0, 0, 7}}},
                          {{"name", "twig"}, {"children", {0}}, {"scale", {2, 2, 2}}}};
    file.json["scenes"][0]["nodes"] = {1};
    const Import import = import_bytes(file.gltf());
    ASSERT_TRUE(import.ok()) << import.error();
    const ModelData& model = import.model.value();
    EXPECT_EQ(model.nodes[0].name, "root");
    EXPECT_EQ(model.nodes[1].name, "twig");
    EXPECT_EQ(model.nodes[2].name, "leaf");
    expect_near(Vec3f{rest_pose(model).model_from_node[2][3]}, {0, 2, 7});
}

TEST(GltfNodes, keep_names_parents_and_places) {
    const Import import = import_bytes(two_nodes().gltf());
    ASSERT_TRUE(import.ok()) << import.error();
    const ModelData& model = import.model.value();
    ASSERT_EQ(model.nodes.size(), 2U);
    EXPECT_EQ(model.nodes[0].name, "base");
    EXPECT_EQ(model.nodes[1].name, "arm");
    EXPECT_EQ(model.nodes[1].parent, 0U);
    EXPECT_EQ(model.nodes[1].meshes, (std::vector<std::uint32_t>{0}));
    EXPECT_EQ(import.mesh().vertices[1].position_body, Vec3f(11, 0, 0));
    EXPECT_EQ(model.meshes[0].vertices[1].position_body, Vec3f(1, 0, 0));
}

TEST(GltfNodes, take_a_matrix_apart_for_what_animations_replace) {
    TriangleFile file;
    // Columns: x doubled and mirrored, y three times as long, and a place.
    file.json["nodes"][0]["matrix"] = {-2, 0, 0, 0, 0, 3, 0, 0, 0, 0, 1, 0, 4, 5, 6, 1};
    const Import import = import_bytes(file.gltf());
    ASSERT_TRUE(import.ok()) << import.error();
    const ModelNode& node = import.model.value().nodes[0];
    EXPECT_EQ(node.rest.translation, Vec3f(4, 5, 6));
    EXPECT_EQ(node.rest.scale, Vec3f(-2, 3, 1));
    EXPECT_NEAR(std::abs(node.rest.rotation.w), 1.0F, 1e-6F);
    EXPECT_EQ(import.mesh().bounds.min, Vec3f(2, 5, 6));
    EXPECT_EQ(import.mesh().bounds.max, Vec3f(4, 8, 6));
}

TEST(GltfNodes, outside_the_files_scene_are_not_shown) {
    TriangleFile file;
    file.json["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}, {"translation", {0, 0, 9}}}};
    const Import one = import_bytes(file.gltf());
    ASSERT_TRUE(one.ok()) << one.error();
    EXPECT_EQ(one.model.value().nodes.size(), 1U);
    EXPECT_EQ(one.mesh().bounds.max.z, 0.0F);
    // Without scenes all roots are shown.
    file.json.erase("scenes");
    file.json.erase("scene");
    const Import both = import_bytes(file.gltf());
    ASSERT_TRUE(both.ok()) << both.error();
    EXPECT_EQ(both.model.value().nodes.size(), 2U);
    EXPECT_EQ(both.mesh().bounds.max.z, 9.0F);
}

TEST(GltfNodes, of_a_long_cycle_are_named_as_far_as_a_line_holds) {
    TriangleFile file;
    file.json["nodes"] = Json::array({{{"mesh", 0}}});
    for (int i = 1; i <= 12; ++i) file.json["nodes"].push_back({{"children", {i % 12 + 1}}});
    expect_refused(file,
                   "its nodes form a cycle: node 1 < node 12 < node 11 < node 10 < node 9 < node 8 "
                   "< node 7 < node 6 < … < node 1");
}

class SpoiledNodes : public ::testing::TestWithParam<Spoiled> {};

TEST_P(SpoiledNodes, are_refused) {
    expect_refused(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Gltf, SpoiledNodes, ::testing::ValuesIn(node_faults()), name_of);

}  // namespace
}  // namespace plumbline::assets::test
