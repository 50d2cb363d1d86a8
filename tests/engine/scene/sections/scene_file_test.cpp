// What a valid scene says is what the description holds.
#include "engine/scene/accuracy.h"
#include "tests/engine/scene/sections/scene_file_fixture.h"

namespace plumbline::scene {
namespace {

TEST_F(SceneFileTest, EmptyFileGivesTheDefaults) {
    const Outcome outcome = load("");
    ASSERT_TRUE(outcome.scene.ok());
    EXPECT_TRUE(outcome.faults.empty());
    const SceneDescription& scene = *outcome.scene;
    expect_near(scene.gravity_mps2, {0, -9.81_r, 0});
    EXPECT_FALSE(scene.kill_below_m);
    EXPECT_EQ(scene.accuracy.preset, "balanced");
    EXPECT_EQ(scene.accuracy.step_hz, 60);
    EXPECT_FALSE(scene.accuracy.substeps);
    EXPECT_FALSE(scene.accuracy.iterations);
    EXPECT_EQ(scene.accuracy.solver, physics::Solver::SmallStep);
    EXPECT_FALSE(scene.player);
    EXPECT_FALSE(scene.has_camera);
    EXPECT_FALSE(scene.sun);
    EXPECT_FALSE(scene.sky);
    EXPECT_FALSE(scene.fog);
    EXPECT_FALSE(scene.flashlight);
    EXPECT_FALSE(scene.post);
    EXPECT_TRUE(scene.entities.empty());
}

TEST_F(SceneFileTest, BomAndCrlfAreAccepted) {
    const Outcome outcome = load("\xEF\xBB\xBF[scene]\r\ntitle = \"Tür\"\r\n");
    ASSERT_TRUE(outcome.scene.ok());
    EXPECT_EQ(outcome.scene->title, "Tür");
}

TEST_F(SceneFileTest, WorldPlayerCameraAndViews) {
    const Outcome outcome = load(R"([scene]
title = "T"
description = "D"
[world]
gravity_mps2 = [1, -2.5, 3]
kill_below_m = -100
[player]
position_m = [1, 2, 3]
yaw_deg = 90
pitch_deg = -30
[camera]
position_m = [4, 5, 6]
target_m = [0, 1, 0]
fov_deg = 60
near_m = 0.1
far_m = 250
clear_color = [0.1, 0.2, 0.3]
[[view]]
name = "gate"
position_m = [1, 1, 1]
target_m = [0, 0, 0]
wait_s = 2.5
flashlight = true
light_scale = 0.25
[[entity]]
primitive = { plane = [9, 9] }
body = { kind = "static" }
)");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    EXPECT_TRUE(outcome.faults.empty());
    const SceneDescription& scene = *outcome.scene;
    EXPECT_EQ(scene.title, "T");
    EXPECT_EQ(scene.description, "D");
    expect_near(scene.gravity_mps2, {1, -2.5_r, 3});
    EXPECT_EQ(scene.kill_below_m, Real{-100});
    ASSERT_TRUE(scene.player);
    expect_near(scene.player->feet_position_m, {1, 2, 3});
    EXPECT_NEAR(scene.player->yaw_rad, kPi / 2, kSlack);
    EXPECT_NEAR(scene.player->pitch_rad, -kPi / 6, kSlack);
    EXPECT_EQ(to_string(scene.player->location), "scene.toml:7");
    EXPECT_TRUE(scene.has_camera);
    expect_near(scene.camera.position_m, {4, 5, 6});
    expect_near(scene.camera.target_m, {0, 1, 0});
    EXPECT_NEAR(scene.camera.fov_y_rad, kPi / 3, kSlack);
    EXPECT_NEAR(scene.camera.near_m, 0.1_r, kSlack);
    EXPECT_NEAR(scene.camera.far_m, Real{250}, kSlack);
    expect_near_f(scene.clear_color, {0.1F, 0.2F, 0.3F});
    ASSERT_EQ(scene.views.size(), 1U);
    EXPECT_EQ(scene.views[0].name, "gate");
    EXPECT_NEAR(scene.views[0].wait_s, 2.5_r, kSlack);
    EXPECT_TRUE(scene.views[0].flashlight);
    EXPECT_FLOAT_EQ(scene.views[0].light_scale, 0.25F);
}

TEST_F(SceneFileTest, TimeMovesTheSunAndAModelMakesTheSky) {
    for (const char* face : {"px", "nx", "py", "ny", "pz", "nz"})
        write(fmt::format("assets/skies/heaps/{}.png", face), "x");
    const Outcome outcome = load(R"([sun]
direction = [0, -1, 0]
[time]
hour = 18
latitude_deg = -45
day_of_year = 81
north_deg = 90
[sky]
model = "atmosphere"
haze = 2
cloud_map = "skies/heaps"
clouds = 0.5
[[view]]
position_m = [0, 0, 1]
target_m = [0, 0, 0]
hour = 21.5
)");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    EXPECT_TRUE(outcome.faults.empty());
    const SceneDescription& scene = *outcome.scene;
    ASSERT_TRUE(scene.time);
    EXPECT_EQ(scene.time->hour, 18);
    EXPECT_NEAR(scene.time->latitude_rad, -glm::pi<double>() / 4, 1e-6);
    EXPECT_EQ(scene.time->day_of_year, 81);
    // North is -X, so west, where the sun sets that day, is +Z: light travels the other way.
    expect_near(scene.sun->direction, {0, 0, -1});
    ASSERT_TRUE(scene.sky && scene.sky->model);
    EXPECT_EQ(scene.sky->model->haze, 2.0F);
    EXPECT_EQ(scene.sky->model->clouds, 0.5F);
    EXPECT_EQ(scene.sky->folder.filename(), "heaps");
    ASSERT_TRUE(scene.views[0].hour);
    EXPECT_EQ(*scene.views[0].hour, 21.5);
}

TEST_F(SceneFileTest, LightAndAir) {
    for (const char* face : {"px", "nx", "py", "ny", "pz", "nz"})
        write(fmt::format("assets/skies/day/{}.png", face), "x");
    const Outcome outcome = load(R"([sun]
direction = [0, -2, 0]
color = [0.5, 0.25, 1]
intensity = 4
rotation_degps = 180
cube_m = 0.5
cube_distance_m = 12
shadow = { cascades = 1, size_px = 1024, distance_m = 40 }
[sky]
skybox = "skies/day"
[ambient]
color = [0.2, 0.3, 0.4]
[fog]
color_srgb = [1, 0.5, 0]
density_per_m = 0.05
[flashlight]
color = [1, 1, 0.5]
intensity = 70
radius_m = 20
inner_deg = 10
outer_deg = 25
on = true
cube_m = 0.04
[post]
bloom = 0.1
exposure = 2
[effects.fog]
)");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    EXPECT_TRUE(outcome.faults.empty());
    const SceneDescription& scene = *outcome.scene;
    ASSERT_TRUE(scene.sun && scene.sun->shadow && scene.sky && scene.fog && scene.flashlight);
    expect_near(scene.sun->direction, {0, -1, 0});
    expect_near_f(scene.sun->color, {0.5F, 0.25F, 1.0F});
    EXPECT_FLOAT_EQ(scene.sun->intensity, 4.0F);
    EXPECT_NEAR(scene.sun->rotation_radps, kPi, kSlack);
    EXPECT_EQ(scene.sun->shadow->cascades, 1);
    EXPECT_EQ(scene.sun->shadow->size_px, 1024);
    EXPECT_NEAR(scene.sun->shadow->distance_m, Real{40}, kSlack);
    EXPECT_EQ(scene.sky->folder, assets() / "skies/day");
    EXPECT_EQ(to_string(scene.sky->location), "scene.toml:9");
    expect_near_f(scene.ambient, {0.2F, 0.3F, 0.4F});
    // sRGB 0.5 is 0.21404 linear.
    EXPECT_NEAR(scene.fog->color.y, 0.21404F, 1e-5F);
    EXPECT_FLOAT_EQ(scene.fog->color.x, 1.0F);
    EXPECT_FLOAT_EQ(scene.fog->density_per_m, 0.05F);
    EXPECT_FLOAT_EQ(scene.flashlight->intensity, 70.0F);
    EXPECT_FLOAT_EQ(scene.flashlight->radius_m, 20.0F);
    EXPECT_FLOAT_EQ(scene.flashlight->inner_deg, 10.0F);
    EXPECT_FLOAT_EQ(scene.flashlight->outer_deg, 25.0F);
    EXPECT_TRUE(scene.flashlight->on);
    EXPECT_FLOAT_EQ(scene.sun->cube_m, 0.5F);
    EXPECT_FLOAT_EQ(scene.sun->cube_distance_m, 12.0F);
    EXPECT_FLOAT_EQ(scene.flashlight->cube_m, 0.04F);
    ASSERT_TRUE(scene.post);
    EXPECT_FLOAT_EQ(scene.post->bloom, 0.1F);
    EXPECT_FLOAT_EQ(scene.post->exposure, 2.0F);
    ASSERT_TRUE(scene.effect_settings.contains("fog"));
    EXPECT_EQ(scene.effect_settings.at("fog").line, 27);
}

TEST_F(SceneFileTest, SunShadowByYesAndNo) {
    EXPECT_TRUE(load("sun = { shadow = true }").scene->sun->shadow);
    EXPECT_FALSE(load("sun = { shadow = false }").scene->sun->shadow);
    EXPECT_FALSE(load("sun = {}").scene->sun->shadow);
}

TEST_F(SceneFileTest, Materials) {
    for (const char* map : {"b.jpg", "n.png", "o.jpg", "h.jpg"})
        write(fmt::format("assets/textures/{}", map), "x");
    const Outcome outcome = load(R"([[material]]
name = "leaf"
shading = "blinn_phong"
base_color = [0.1, 0.2, 0.3]
alpha = 0.5
emissive = [0, 2, 0]
base_color_map = "textures/b.jpg"
normal_map = "textures/n.png"
orm_map = "textures/o.jpg"
height_map = "textures/h.jpg"
roughness = 0.3
metallic = 0.7
alpha_mode = "mask"
alpha_cutoff = 0.4
two_sided = true
surface = "soft"
)");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    EXPECT_TRUE(outcome.faults.empty());
    const assets::MaterialData& leaf = outcome.scene->materials.at("leaf");
    EXPECT_EQ(leaf.name, "leaf");
    EXPECT_EQ(leaf.shading, assets::Shading::BlinnPhong);
    expect_near_f(leaf.base_color, {0.1F, 0.2F, 0.3F});
    EXPECT_FLOAT_EQ(leaf.alpha, 0.5F);
    expect_near_f(leaf.emissive, {0.0F, 2.0F, 0.0F});
    EXPECT_EQ(leaf.base_color_map, assets() / "textures/b.jpg");
    EXPECT_EQ(leaf.normal_map, assets() / "textures/n.png");
    EXPECT_EQ(leaf.orm_map, assets() / "textures/o.jpg");
    EXPECT_EQ(leaf.height_map, assets() / "textures/h.jpg");
    EXPECT_FLOAT_EQ(leaf.roughness, 0.3F);
    EXPECT_FLOAT_EQ(leaf.metallic, 0.7F);
    EXPECT_EQ(leaf.alpha_mode, assets::AlphaMode::Mask);
    EXPECT_FLOAT_EQ(leaf.alpha_cutoff, 0.4F);
    EXPECT_TRUE(leaf.two_sided);
    EXPECT_EQ(leaf.surface, "soft");
}

TEST_F(SceneFileTest, LightSoundAndMotion) {
    write("assets/sounds/f.ogg", "x");
    const Outcome outcome = load(R"([[entity]]
light = { kind = "spot", color = [1, 0.5, 0], intensity = 30, radius_m = 9, direction = [0, 0, -3], inner_deg = 15, outer_deg = 35, shadow = true, offset_m = [0, 0.5, 0] }
sound = { file = "sounds/f.ogg", loop = false, gain = 0.6, radius_m = 7 }
primitive = { box = [1, 1, 1] }
motion = { points_m = [[0, 0, 0], [3, 0, 0]], period_s = 6, spin_degps = [0, 90, 0] }
body = { kind = "kinematic" }
)");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    EXPECT_TRUE(outcome.faults.empty());
    const EntityDescription& entity = outcome.scene->entities.at(0);
    ASSERT_TRUE(entity.light && entity.sound && entity.motion);
    EXPECT_TRUE(entity.light->is_spot);
    expect_near_f(entity.light->color, {1.0F, 0.5F, 0.0F});
    expect_near_f(entity.light->direction, {0.0F, 0.0F, -1.0F});
    EXPECT_FLOAT_EQ(entity.light->inner_deg, 15.0F);
    EXPECT_FLOAT_EQ(entity.light->outer_deg, 35.0F);
    EXPECT_TRUE(entity.light->shadow);
    EXPECT_EQ(entity.light->offset_m, (Vec3{0, 0.5_r, 0}));
    EXPECT_FALSE(entity.sound->loop);
    EXPECT_FLOAT_EQ(entity.sound->gain, 0.6F);
    EXPECT_EQ(entity.sound->file, assets() / "sounds/f.ogg");
    ASSERT_EQ(entity.motion->points_m.size(), 2U);
    EXPECT_NEAR(entity.motion->spin_radps.y, kPi / 2, kSlack);
    EXPECT_EQ(entity.motion->period_s, Real{6});
}

TEST_F(SceneFileTest, ShippedFilesAreIncludedByTheirBareNames) {
    write("assets/scenes/materials.toml", "[[material]]\nname = \"oak\"\n");
    const Outcome bare = load("[scene]\ninclude = [\"materials.toml\"]\n");
    ASSERT_TRUE(bare.scene.ok()) << bare.scene.error().message;
    EXPECT_TRUE(bare.scene->materials.contains("oak"));
    write("materials.toml", "[[material]]\nname = \"elm\"\n");
    const Outcome beside = load("[scene]\ninclude = [\"materials.toml\"]\n");
    ASSERT_TRUE(beside.scene.ok()) << beside.scene.error().message;
    EXPECT_TRUE(beside.scene->materials.contains("elm")) << "one's own comes first";
    const Outcome neither = load("[scene]\ninclude = [\"material.toml\"]\n");
    ASSERT_EQ(neither.faults.size(), 1U);
    EXPECT_EQ(neither.faults[0],
              "scene.toml:2:12: error: scene.include[0]: \"material.toml\" does not exist beside "
              "this file, in assets or in assets/scenes");
}

TEST_F(SceneFileTest, AKeyWithoutItsUnitIsNamed) {
    const Outcome outcome =
        load("[[entity]]\nprimitive = { box = [1, 1, 1] }\n[entity.body]\nmass = 3\n");
    ASSERT_EQ(outcome.faults.size(), 1U);
    EXPECT_EQ(outcome.faults[0],
              "scene.toml:4:1: error: entity[0].body.mass: unknown key; did you mean \"mass_kg\"?");
}

TEST_F(SceneFileTest, IncludesBringMaterialsAndPrefabs) {
    write("assets/scenes/colours.toml", "[[material]]\nname = \"red\"\nroughness = 0.1\n");
    write("assets/scenes/things.toml",
          "[scene]\ninclude = [\"colours.toml\"]\n[[prefab]]\nname = \"ball\"\nmaterial = \"red\"\n"
          "primitive = { sphere = 0.2 }\n");
    write("assets/scenes/sub/main.toml",
          "[scene]\ninclude = [\"../colours.toml\", \"../things.toml\"]\n"
          "[[entity]]\nprefab = \"ball\"\n"
          "[[material]]\nname = \"red\"\nroughness = 0.9\n");
    const Outcome outcome = load_file("assets/scenes/sub/main.toml");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    EXPECT_TRUE(outcome.faults.empty());
    EXPECT_EQ(outcome.scene->entities.at(0).material, "red");
    // The scene's own word counts over an included file's.
    EXPECT_FLOAT_EQ(outcome.scene->materials.at("red").roughness, 0.9F);
}

TEST_F(SceneFileTest, FilesBesideTheSceneComeFirst) {
    write("assets/t.png", "x");
    write("mine/t.png", "x");
    write("mine/scene.toml", "[[material]]\nname = \"m\"\nbase_color_map = \"t.png\"\n");
    EXPECT_EQ(load_file("mine/scene.toml").scene->materials.at("m").base_color_map,
              folder() / "mine/t.png");
    std::filesystem::remove(folder() / "mine/t.png");
    EXPECT_EQ(load_file("mine/scene.toml").scene->materials.at("m").base_color_map,
              assets() / "t.png");
}

TEST_F(SceneFileTest, ContentHashCoversIncludes) {
    write("part.toml", "[[material]]\nname = \"a\"\n");
    const std::string main = "[scene]\ninclude = [\"part.toml\"]\n";
    const std::uint64_t first = load(main).scene->content_hash;
    EXPECT_EQ(load(main).scene->content_hash, first);
    write("part.toml", "[[material]]\nname = \"b\"\n");
    EXPECT_NE(load(main).scene->content_hash, first);
}

TEST_F(SceneFileTest, EmptyCollidesWithMeansNothing) {
    const auto filters = [&](const char* key) {
        const Outcome outcome =
            load(fmt::format("[[entity]]\nprimitive = {{ sphere = 1 }}\n[entity.body]\n{}\n", key));
        EXPECT_TRUE(outcome.faults.empty());
        return outcome.scene->entities.at(0).body->collides_with;
    };
    EXPECT_TRUE(filters("").empty());  // everything
    EXPECT_EQ(filters("collides_with = []"), std::vector<std::string>{""});
}

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

}  // namespace
}  // namespace plumbline::scene
