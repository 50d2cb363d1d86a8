// Nodes, animations, bones and targets at instants that are known beforehand. EXPERIENCE G22.

#include "engine/assets/model/model_pose.h"

#include "tests/engine/assets/animation_files.h"

namespace plumbline::assets::test {
namespace {

Vec3f place_at(const ModelData& model, float time_s, std::size_t node) {
    return Vec3f{pose_at(model, model.animations.at(0), time_s).model_from_node.at(node)[3]};
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
    const Aabb end = bounds_of(model, pose_at(model, model.animations[0], 3));
    expect_near(end.min, {10, 8, 0});
    expect_near(end.max, {11, 9, 0});
}

TEST(ModelAnimation, turns_the_short_way_round_at_an_even_rate) {
    TriangleFile file = two_nodes();
    file.json["animations"] = Json::array({Json::object()});
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
    file.json["animations"] = Json::array({Json::object()});
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

TEST(ModelParts, tell_what_moves_from_what_stands) {
    TriangleFile file = two_nodes();
    file.json["nodes"].push_back({{"name", "floor"}, {"mesh", 0}});
    file.json["scenes"][0]["nodes"] = {0, 2};
    file.json["animations"] = Json::array({Json::object()});
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

}  // namespace
}  // namespace plumbline::assets::test
