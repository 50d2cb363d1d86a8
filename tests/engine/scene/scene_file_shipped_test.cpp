// The scenes in assets/ load without a word.
#include "engine/scene/scene_file.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace plumbline::scene {
namespace {

namespace fs = std::filesystem;

Result<SceneDescription> load_shipped(const fs::path& file, std::string& said) {
    Diagnostics faults;
    auto scene = load_scene(file, fs::path(PL_SOURCE_DIR) / "assets", faults);
    for (const Diagnostic& fault : faults.list()) said += to_string(fault) + "\n";
    return scene;
}

const fs::path kScenes = fs::path(PL_SOURCE_DIR) / "assets/scenes";

TEST(ShippedScenes, LoadWithoutAWord) {
    int scenes = 0;
    for (const auto& entry : fs::recursive_directory_iterator(kScenes)) {
        if (entry.path().extension() != ".toml") continue;
        std::string said;
        EXPECT_TRUE(load_shipped(entry.path(), said).ok()) << entry.path();
        EXPECT_EQ(said, "") << entry.path();
        ++scenes;
    }
    EXPECT_GE(scenes, 8);
}

TEST(ShippedScenes, TheCubeHasEightMetresToFall) {
    std::string said;
    const auto scene = load_shipped(kScenes / "falling_cube.toml", said);
    ASSERT_TRUE(scene.ok()) << said;
    const EntityDescription* cube = nullptr;
    for (const auto& entity : scene->entities) {
        if (entity.name == "cube") cube = &entity;
    }
    ASSERT_NE(cube, nullptr);
    const auto size = std::get<physics::BoxShape>(std::get<Primitive>(cube->visual)).size_m;
    EXPECT_EQ(cube->world_from_body.position.y - size.y / 2, Real{8});
    EXPECT_FALSE(scene->sun->shadow);
    EXPECT_FALSE(scene->sky || scene->fog || scene->post || scene->flashlight);
}

TEST(ShippedScenes, ThePileIsAThousandCrates) {
    std::string said;
    const auto scene = load_shipped(kScenes / "pile.toml", said);
    ASSERT_TRUE(scene.ok()) << said;
    ASSERT_EQ(scene->arrays.size(), 1U);
    EXPECT_EQ(scene->arrays[0].count, (std::array<int, 3>{10, 10, 10}));
    EXPECT_EQ(scene->arrays[0].prefab.body->mass_kg, Real{1000});
}

// Integer arithmetic of the published scene, box by box.
TEST(ShippedScenes, BenchBoxesAreWhereOtherEnginesHaveThem) {
    for (const int count : {100, 1000, 3000}) {
        std::string said;
        const auto scene =
            load_shipped(kScenes / "bench" / ("boxes_" + std::to_string(count) + ".toml"), said);
        ASSERT_TRUE(scene.ok()) << said;
        ASSERT_EQ(scene->entities.size(), static_cast<std::size_t>(count) + 1);
        for (int i = 0; i < count; ++i) {
            const int layer = i / 100;
            const double x = (i % 10 - 4.5) * 1.6 + 0.28 * ((i * 7 + layer * 3) % 11 - 5) / 5.0;
            const double z =
                (i / 10 % 10 - 4.5) * 1.6 + 0.28 * ((i * 5 + layer * 4) % 13 - 6) / 6.0;
            const Vec3 position =
                scene->entities[static_cast<std::size_t>(i) + 1].world_from_body.position;
            EXPECT_NEAR(static_cast<double>(position.x), x, 1e-5);
            EXPECT_NEAR(static_cast<double>(position.y), 3 + 1.25 * layer, 1e-5);
            EXPECT_NEAR(static_cast<double>(position.z), z, 1e-5);
        }
    }
}

TEST(ShippedScenes, ThingsOfferWhatTheNumberKeysChoose) {
    std::string said;
    const auto scene = load_shipped(kScenes / "things.toml", said);
    ASSERT_TRUE(scene.ok()) << said;
    for (const char* name : {"crate", "ball", "barrel", "brick", "plank", "stone", "domino"}) {
        ASSERT_TRUE(scene->prefabs.contains(name)) << name;
        EXPECT_TRUE(scene->prefabs.at(name).body->mass_kg) << name;
    }
}

}  // namespace
}  // namespace plumbline::scene
