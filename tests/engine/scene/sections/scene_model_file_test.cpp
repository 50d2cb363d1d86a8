// A model by itself as a scene.
#include "engine/core/limits.h"
#include "engine/scene/sections/scene_parts.h"
#include "tests/engine/assets/fixture.h"
#include "tests/engine/scene/sections/scene_file_fixture.h"

#include <cmath>

namespace plumbline::scene {
namespace {

TEST_F(SceneFileTest, AModelIsAScene) {
    write("assets/models/m.glb", "x");
    const Outcome outcome = load_file("assets/models/m.glb");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    EXPECT_FALSE(outcome.scene->has_camera);
    ASSERT_TRUE(outcome.scene->sun && outcome.scene->sun->shadow);
    ASSERT_EQ(outcome.scene->entities.size(), 2U);
    const EntityDescription& model = outcome.scene->entities[1];
    EXPECT_EQ(model.name, "model");
    EXPECT_EQ(std::get<ModelVisual>(model.visual).root, assets());
    EXPECT_EQ(model.body->kind, physics::BodyKind::Static);
}

// A cube of 2 m from (4, 0, -1) on: a ball of sqrt(3) m around (5, 1, 0).
TEST(SceneOfModel, TheStageFitsItsBounds) {
    SceneDescription scene = scene_of_model("m.glb", ".");
    place_on_stage(scene, {.min = {4, 0, -1}, .max = {6, 2, 1}});
    const double radius_m = std::sqrt(3.0);
    EXPECT_NEAR(scene.model_radius_m, radius_m, 1e-6);
    expect_near(scene.camera.target_m, {5, 1, 0});
    // The ball just touches the edges of the image.
    EXPECT_NEAR(glm::distance(scene.camera.position_m, scene.camera.target_m),
                radius_m / std::sin(static_cast<double>(scene.camera.fov_y_rad) / 2),
                1e-5);
    EXPECT_NEAR(scene.camera.near_m, 0.002 * radius_m, 1e-6);
    EXPECT_NEAR(scene.camera.far_m, 100 * radius_m, 1e-4);
    EXPECT_NEAR(scene.sun->shadow->distance_m, 10 * radius_m, 1e-5);
    const EntityDescription& ground = scene.entities.at(0);
    expect_near(ground.world_from_body.position, {5, 0, 0});
    const auto plane = std::get<physics::PlaneShape>(std::get<Primitive>(ground.visual));
    EXPECT_NEAR(plane.size_m.x, 20 * radius_m, 1e-5);
    EXPECT_NEAR(plane.thickness_m, radius_m, 1e-6);
}

TEST(SceneOfModel, TheStageKeepsTheSizesThatShapesMayHave) {
    SceneDescription point = scene_of_model("m.glb", ".");
    place_on_stage(point, {.min = {0, 0, 0}, .max = {0, 0, 0}});
    EXPECT_NEAR(point.model_radius_m, 1e-5, 1e-9) << "never none";
    const auto small =
        std::get<physics::PlaneShape>(std::get<Primitive>(point.entities.at(0).visual));
    EXPECT_NEAR(small.thickness_m, limits::kSizeMin_m, 1e-9);
    SceneDescription land = scene_of_model("m.glb", ".");
    place_on_stage(land, {.min = {-4e3F, 0, -4e3F}, .max = {4e3F, 1, 4e3F}});
    const auto wide =
        std::get<physics::PlaneShape>(std::get<Primitive>(land.entities.at(0).visual));
    EXPECT_NEAR(wide.size_m.x, limits::kSizeMax_m, 1e-3);
}

// A triangle of 1 m that goes 1 km within its animation.
TEST_F(SceneFileTest, AnAnimatedModelFillsTheImageWhereItStarts) {
    assets::test::TriangleFile file;
    std::string places;
    std::string times;
    assets::test::append_bytes<float>(times, {0, 1});
    assets::test::append_bytes<float>(places, {0, 0, 5, 1000, 0, 5});
    file.animate(0,
                 "translation",
                 file.add_accessor(times, 5126, 2, "SCALAR"),
                 file.add_accessor(places, 5126, 2, "VEC3"));
    write("assets/m.glb", file.glb());
    SceneDescription scene = scene_of_model(assets() / "m.glb", assets());
    assets::AssetLibrary library;
    ASSERT_TRUE(fit_stage(scene, library).ok());
    EXPECT_NEAR(scene.model_radius_m, std::sqrt(0.5), 1e-6);
    expect_near(scene.camera.target_m, {0.5_r, 0.5_r, 5});
}

}  // namespace
}  // namespace plumbline::scene
