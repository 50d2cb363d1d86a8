// Numbers and transforms of JSON scenes.
#include "tests/engine/scene/json_scene/json_scene_fixture.h"

namespace plumbline::scene {
namespace {

TEST_F(JsonFault, OfTransforms) {
    const auto said = [&](std::string_view element) {
        return said_of_object(fmt::format(R"("transform": [{{}}, {}])", element));
    };
    const std::string at = "a.json: error: objects[1].transform[1]";
    EXPECT_EQ(said("3"),
              at + ": expected an object with scale, rotate, translate or lookat, found number");
    EXPECT_EQ(said(R"({"rotate": [90, 0, 0, 0]})"),
              at + ".rotate: the axis is zero; expected [degrees, x, y, z]");
    EXPECT_EQ(said(R"({"rotate": [90, 0, 1]})"), at + ".rotate: expected 4 numbers, found 3");
    EXPECT_EQ(said(R"({"scale": [1, null, 1]})"),
              at + ".scale[1]: expected a finite number, found null");
    EXPECT_EQ(said(R"({"translate": 4})"),
              at + ".translate: expected an array of numbers, found number");
    EXPECT_EQ(said(R"({"lookat": {"position": [1, 2, 3], "target": [1, 2, 3]}})"),
              at + ".lookat: the target lies on the position: there is nowhere to look");
    EXPECT_EQ(said(R"({"lookat": {"target": [0, 5, 0]}})"),
              at + ".lookat: up runs along the view; expected a direction across it");
    EXPECT_EQ(said(R"({"lookat": {"up": [0, 0, 0]}})"),
              at + ".lookat: up is zero; expected a direction");
    EXPECT_EQ(said(R"({"scale": [1e300, 1, 1]}, {"scale": [1e300, 1, 1]})"),
              "a.json: error: objects[1].transform[2]: the transform grows beyond all numbers");
}

// SOURCES C4: rotate, scale, translate in the list's order; normals by the inverse transpose.
TEST_F(JsonFault, TransformsActInTheOrderOfTheList) {
    write("a.json", one_object(R"("vertices": [0,0,0, 1,0,0, 0,1,0], "faces": [0,1,2],
            "transform": [{"rotate": [90, 0, 0, 5]}, {"scale": [2, 3, 1]}, {"rotate": [90, 1, 0, 0]},
                          {"scale": [1, 1, 4]}, {"translate": [7, 8, 9]}, {}])"));
    const Outcome outcome = load_file("a.json");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    const assets::MeshData& mesh = mesh_of(*outcome.scene, 0);
    expect_near(outcome.scene->entities[0].world_from_body.position, {7, 8, 9});
    // x: to y, three long, to z, four times that; y: to -x, two long.
    expect_near_f(mesh.vertices[1].position_body, {0, 0, 12});
    expect_near_f(mesh.vertices[2].position_body, {-2, 0, 0});
    expect_near_f(mesh.vertices[0].normal_body, {0, -1, 0});
}

TEST_F(JsonFault, OfSeveralKeysInOneElementTheFirstOfTheSourcesOrderCounts) {
    write("a.json",
          one_object(R"("vertices": [0,0,0, 1,0,0, 0,1,0], "faces": [0,1,2], "transform": [
            {"translate": [5, 5, 5], "scale": [2, 2, 2]}, {"lookat": {}, "translate": [0, 0, 1]},
            {"unknown": 1}])"));
    const Outcome outcome = load_file("a.json");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    expect_near(outcome.scene->entities[0].world_from_body.position, {0, 0, 1});
    expect_near_f(mesh_of(*outcome.scene, 0).vertices[1].position_body, {2, 0, 0});
}

}  // namespace
}  // namespace plumbline::scene
