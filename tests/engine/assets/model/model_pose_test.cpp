// Nodes, animations, bones and targets at instants that are known beforehand. EXPERIENCE G22.

#include "engine/assets/model/model_pose.h"

#include "tests/engine/assets/fixture.h"

namespace plumbline::assets::test {
namespace {

/// The triangle in a node of its own ("arm") below another ("base", at x = 10).
TriangleFile two_nodes() {
    TriangleFile file;
    file.json["nodes"] = {{{"name", "base"}, {"translation", {10, 0, 0}}, {"children", {1}}},
                          {{"name", "arm"}, {"mesh", 0}}};
    return file;
}

/// A sampler of the numbers given; its number.
std::size_t add_sampler(TriangleFile& file,
                        std::initializer_list<float> times,
                        std::initializer_list<float> values,
                        const char* type,
                        const char* interpolation = "LINEAR") {
    std::string input;
    std::string output;
    append_bytes<float>(input, times);
    append_bytes<float>(output, values);
    const std::size_t width = type == std::string_view("VEC4") ? 4 : type[0] == 'V' ? 3 : 1;
    const std::size_t in = file.add_accessor(input, 5126, static_cast<int>(times.size()), "SCALAR");
    const std::size_t out =
        file.add_accessor(output, 5126, static_cast<int>(values.size() / width), type);
    Json& samplers = file.json["animations"][0]["samplers"];
    samplers.push_back({{"input", in}, {"output", out}, {"interpolation", interpolation}});
    return samplers.size() - 1;
}

void add_channel(TriangleFile& file, std::size_t sampler, int node, const char* path) {
    file.json["animations"][0]["channels"].push_back(
        {{"sampler", sampler}, {"target", {{"node", node}, {"path", path}}}});
}

Vec3f place_at(const ModelData& model, float time_s, std::size_t node) {
    return Vec3f{pose_at(model, model.animations.at(0), time_s).model_from_node.at(node)[3]};
}

void expect_near(const Vec3f& value, const Vec3f& expected) {
    EXPECT_NEAR(glm::length(value - expected), 0, 1e-5)
        << value.x << ' ' << value.y << ' ' << value.z;
}

TEST(ModelNodes, keep_names_parents_and_places) {
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

TEST(ModelNodes, come_parents_first_whatever_the_order_of_the_file) {
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

TEST(ModelAnimation, moves_a_child_with_its_parent_linearly_and_stops_at_both_ends) {
    TriangleFile file = two_nodes();
    file.json["animations"] = {{{"name", "slide"}}};
    add_channel(file, add_sampler(file, {1, 3}, {10, 0, 0, 10, 8, 0}, "VEC3"), 0, "translation");
    const Import import = import_bytes(file.gltf());
    ASSERT_TRUE(import.ok()) << import.error();
    const ModelData& model = import.model.value();
    ASSERT_EQ(model.animations.size(), 1U);
    EXPECT_EQ(model.animations[0].name, "slide");
    EXPECT_EQ(model.animations[0].duration_s, 3.0F);
    expect_near(place_at(model, 0, 1), {10, 0, 0});
    expect_near(place_at(model, 1.5F, 1), {10, 2, 0});
    expect_near(place_at(model, 3, 1), {10, 8, 0});
    expect_near(place_at(model, 99, 1), {10, 8, 0});
    // The triangle is 1 m wide and high.
    expect_near(bounds_over(model, model.animations[0]).min, {10, 0, 0});
    expect_near(bounds_over(model, model.animations[0]).max, {11, 9, 0});
}

TEST(ModelAnimation, turns_the_short_way_round_at_an_even_rate) {
    TriangleFile file = two_nodes();
    file.json["animations"] = {Json::object()};
    const float half = std::sqrt(0.5F);
    // A quarter turn about y, its end written with the other sign.
    add_channel(
        file, add_sampler(file, {0, 1}, {0, 0, 0, 1, 0, -half, 0, -half}, "VEC4"), 1, "rotation");
    const Import import = import_bytes(file.gltf());
    ASSERT_TRUE(import.ok()) << import.error();
    const ModelData& model = import.model.value();
    EXPECT_EQ(model.animations[0].name, "animation 1");
    const Mat4f third = pose_at(model, model.animations[0], 1.0F / 3).model_from_node[1];
    expect_near(Vec3f{third[0]},
                {std::cos(static_cast<float>(kPi) / 6), 0, -std::sin(static_cast<float>(kPi) / 6)});
}

TEST(ModelAnimation, steps_hold_and_splines_are_smooth) {
    TriangleFile file = two_nodes();
    file.json["animations"] = {Json::object()};
    add_channel(file, add_sampler(file, {0, 1}, {1, 1, 1, 3, 3, 3}, "VEC3", "STEP"), 1, "scale");
    // From 0 to 1 m with no slope at either end: half way at half time, 3t2 - 2t3 between.
    add_channel(file,
                add_sampler(file,
                            {0, 1},
                            {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0},
                            "VEC3",
                            "CUBICSPLINE"),
                1,
                "translation");
    const Import import = import_bytes(file.gltf());
    ASSERT_TRUE(import.ok()) << import.error();
    const ModelData& model = import.model.value();
    const Mat4f quarter = pose_at(model, model.animations[0], 0.25F).model_from_node[1];
    EXPECT_FLOAT_EQ(quarter[0][0], 1.0F);
    EXPECT_NEAR(quarter[3].x, 10 + 3.0 / 16 - 2.0 / 64, 1e-5);
    EXPECT_FLOAT_EQ(pose_at(model, model.animations[0], 1).model_from_node[1][0][0], 3.0F);
}

TEST(ModelAnimation, that_is_no_good_is_left_out_alone) {
    TriangleFile file = two_nodes();
    file.json["animations"] = {Json::object()};
    add_channel(file, add_sampler(file, {1, 1}, {0, 0, 0, 1, 1, 1}, "VEC3"), 1, "translation");
    const Import import = import_bytes(file.gltf());
    ASSERT_TRUE(import.ok()) << import.error();
    EXPECT_TRUE(import.model.value().animations.empty());
    EXPECT_TRUE(contains(import.log,
                         "animation \"animation 1\" is left out: animations[0].samplers[0].input: "
                         "times must rise from 0; number 1 is 1"))
        << import.log;
}

TEST(ModelParts, tell_what_moves_from_what_stands) {
    TriangleFile file = two_nodes();
    file.json["nodes"].push_back({{"name", "floor"}, {"mesh", 0}});
    file.json["scenes"][0]["nodes"] = {0, 2};
    file.json["animations"] = {Json::object()};
    add_channel(file, add_sampler(file, {0, 1}, {0, 0, 0, 1, 0, 0}, "VEC3"), 0, "translation");
    const Import import = import_bytes(file.gltf());
    ASSERT_TRUE(import.ok()) << import.error();
    const ModelData& model = import.model.value();
    const ModelParts parts = parts_of(model);
    ASSERT_EQ(parts.moving.size(), 1U);
    ASSERT_EQ(parts.still.size(), 1U);
    EXPECT_EQ(model.nodes[parts.moving[0].node].name, "arm");
    EXPECT_FALSE(parts.moving[0].deforms);
    EXPECT_EQ(model.nodes[parts.still[0].node].name, "floor");
    // In its node's frame, to be drawn where the node is.
    EXPECT_EQ(part_mesh(model, parts.moving[0], rest_pose(model)).bounds.max, Vec3f(1, 1, 0));
    EXPECT_EQ(still_mesh(model, parts, "m").bounds.max, Vec3f(1, 1, 0));
}

/// The triangle held by two bones at the origin: corner 0 by the first, 1 by the second, 2 by both.
TriangleFile skinned() {
    TriangleFile file;
    std::string joints;
    std::string weights;
    append_bytes<std::uint8_t>(joints, {0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0});
    append_bytes<float>(weights, {1, 0, 0, 0, 1, 0, 0, 0, 0.5F, 0.5F, 0, 0});
    file.attributes()["JOINTS_0"] = file.add_accessor(joints, 5121, 3, "VEC4");
    file.attributes()["WEIGHTS_0"] = file.add_accessor(weights, 5126, 3, "VEC4");
    file.json["nodes"] = {{{"mesh", 0}, {"skin", 0}, {"translation", {5, 5, 5}}},
                          {{"name", "still bone"}},
                          {{"name", "moving bone"}, {"translation", {0, 0, 2}}}};
    file.json["scenes"][0]["nodes"] = {0, 1, 2};
    std::string matrices;
    append_bytes<float>(matrices, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
    append_bytes<float>(matrices, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -2, 1});
    file.json["skins"] = {{{"joints", {1, 2}},
                           {"inverseBindMatrices", file.add_accessor(matrices, 5126, 2, "MAT4")}}};
    file.json["animations"] = {Json::object()};
    add_channel(file, add_sampler(file, {0, 1}, {0, 0, 2, 0, 4, 2}, "VEC3"), 2, "translation");
    return file;
}

/// The one part that moves, as the first animation has it at that time.
MeshData deformed_at(const ModelData& model, float time_s) {
    const ModelParts parts = parts_of(model);
    EXPECT_EQ(parts.moving.size(), 1U);
    EXPECT_TRUE(parts.moving.at(0).deforms);
    MeshData mesh = part_mesh(model, parts.moving.at(0), rest_pose(model));
    deform(model, parts.moving.at(0), pose_at(model, model.animations.at(0), time_s), mesh);
    return mesh;
}

TEST(ModelSkin, carries_vertices_by_the_mean_of_their_bones_and_not_by_the_node) {
    const Import import = import_bytes(skinned().gltf());
    ASSERT_TRUE(import.ok()) << import.error();
    // At rest the bones undo their inverse bind matrices: the triangle as it was made.
    EXPECT_EQ(import.mesh().vertices[1].position_body, Vec3f(1, 0, 0));
    const MeshData mesh = deformed_at(import.model.value(), 0.5F);
    expect_near(mesh.vertices[0].position_body, {0, 0, 0});
    expect_near(mesh.vertices[1].position_body, {1, 2, 0});
    expect_near(mesh.vertices[2].position_body, {0, 2, 0});
    expect_near(mesh.bounds.max, {1, 2, 0});
}

TEST(ModelSkin, ignores_joints_that_its_skin_lacks) {
    TriangleFile file = skinned();
    std::string joints;
    append_bytes<std::uint8_t>(joints, {0, 0, 0, 0, 1, 0, 0, 0, 0, 9, 0, 0});
    file.attributes()["JOINTS_0"] = file.add_accessor(joints, 5121, 3, "VEC4");
    const Import import = import_bytes(file.gltf());
    ASSERT_TRUE(import.ok()) << import.error();
    expect_near(import.mesh().vertices[2].position_body, {0, 1, 0});
}

TEST(ModelSkin, that_names_a_node_which_is_not_there_is_refused) {
    TriangleFile file = skinned();
    file.json["skins"][0]["joints"] = {1, 7};
    const Import import = import_bytes(file.gltf());
    EXPECT_TRUE(contains(import.error(), "skins[0].joints names node 7 of 3")) << import.error();
}

TEST(ModelMorph, adds_targets_by_their_weights) {
    TriangleFile file;
    std::string offsets;
    append_bytes<float>(offsets, {0, 0, 0, 0, 0, 4, 0, 0, 0});
    file.primitive()["targets"] = {{{"POSITION", file.add_accessor(offsets, 5126, 3, "VEC3")}}};
    file.json["meshes"][0]["weights"] = {0.25};
    file.json["animations"] = {Json::object()};
    add_channel(file, add_sampler(file, {0, 2}, {0, 1}, "SCALAR"), 0, "weights");
    const Import import = import_bytes(file.gltf());
    ASSERT_TRUE(import.ok()) << import.error();
    EXPECT_EQ(import.mesh().vertices[1].position_body, Vec3f(1, 0, 1));
    const MeshData mesh = deformed_at(import.model.value(), 1.5F);
    expect_near(mesh.vertices[1].position_body, {1, 0, 3});
}

}  // namespace
}  // namespace plumbline::assets::test
