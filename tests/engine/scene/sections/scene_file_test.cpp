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

}  // namespace
}  // namespace plumbline::scene
