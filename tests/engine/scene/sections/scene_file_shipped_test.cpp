// The scenes in assets/ load without a word.
#include "engine/core/io/files.h"
#include "engine/scene/paths/scene_list.h"
#include "engine/scene/scene_file.h"
#include "tests/engine/scene/sections/scene_file_fixture.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace plumbline::scene {
namespace {

namespace fs = std::filesystem;

Result<SceneDescription> load_shipped(const fs::path& file, std::string& said) {
    Diagnostics faults;
    auto scene = read_description(file, fs::path(PL_SOURCE_DIR) / "assets", faults);
    for (const Diagnostic& fault : faults.list()) said += to_string(fault) + "\n";
    return scene;
}

const fs::path kScenes = fs::path(PL_SOURCE_DIR) / "assets/scenes";

TEST(ShippedScenes, LoadWithoutAWord) {
    int scenes = 0;
    for (const auto& entry : fs::recursive_directory_iterator(kScenes)) {
        const fs::path extension = entry.path().extension();
        if (extension != ".toml" && extension != ".json") continue;
        std::string said;
        EXPECT_TRUE(load_shipped(entry.path(), said).ok()) << entry.path();
        EXPECT_EQ(said, "") << entry.path();
        ++scenes;
    }
    EXPECT_GE(scenes, 8);
}

// SOURCES C2: about the axis of view, an eighth of a turn a second.
TEST(ShippedScenes, TheTriangleTurnsInThePlaneOfTheImage) {
    std::string said;
    const auto scene = load_shipped(kScenes / "viewer/triangle.toml", said);
    ASSERT_TRUE(scene.ok()) << said;
    const EntityDescription& triangle = scene->entities.at(0);
    ASSERT_TRUE(triangle.motion.has_value());
    const Vec3 view = glm::normalize(scene->camera.target_m - scene->camera.position_m);
    EXPECT_NEAR(glm::length(glm::cross(triangle.motion->spin_radps, view)), 0, 1e-6);
    EXPECT_NEAR(glm::length(triangle.motion->spin_radps), kPi / 4, 1e-6);
    EXPECT_EQ(scene->materials.at(triangle.material).shading, assets::Shading::Unlit);
}

// SOURCES B29, B26: the garden, from the report's own place, its fog off at first.
TEST(ShippedScenes, TheReportsSceneStartsWhereTheReportDoes) {
    std::string said;
    const auto scene = load_shipped(kScenes / "nature.toml", said);
    const auto garden = load_shipped(kScenes / "garden.toml", said);
    ASSERT_TRUE(scene.ok() && garden.ok()) << said;
    EXPECT_EQ(scene->controls, "nature");
    EXPECT_FALSE(scene->player) << "it flies at first";
    EXPECT_EQ(scene->camera.position_m, Vec3(9.81_r, 3.01_r, -20.23_r));
    EXPECT_EQ(scene->camera.target_m, Vec3(0, 0, 0));
    EXPECT_NEAR(scene->camera.fov_y_rad, kPi / 4, 1e-6);
    EXPECT_EQ(scene->fog->color, Vec3f(0.486F, 0.737F, 0.8F));
    EXPECT_FALSE(scene->fog->on);
    EXPECT_GT(scene->entities.size(), garden->entities.size()) << "all of the garden, and more";
    EXPECT_EQ(scene->sky->folder, garden->sky->folder);
}

TEST(ShippedScenes, TheDocsNameWhatMayBeIncluded) {
    std::string said;
    const auto things = load_shipped(kScenes / "things.toml", said);
    ASSERT_TRUE(things.ok()) << said;
    const Result<std::string> docs =
        read_file(fs::path(PL_SOURCE_DIR) / "docs/SCENE-FORMAT.md", std::size_t{1} << 20);
    ASSERT_TRUE(docs.ok());
    const std::size_t start = docs->find("Two files are shipped to be included");
    ASSERT_NE(start, std::string::npos);
    const std::string list = docs->substr(start, docs->find("\n#", start) - start);
    std::size_t named = 0;
    for (std::size_t tick = list.find('`'); tick != std::string::npos;
         tick = list.find('`', list.find('`', tick + 1) + 1)) {
        const std::string name = list.substr(tick + 1, list.find('`', tick + 1) - tick - 1);
        if (name.find(' ') != std::string::npos) continue;  // include = …
        EXPECT_TRUE(things->materials.contains(name) || things->prefabs.contains(name)) << name;
        ++named;
    }
    EXPECT_GE(named, 25U);
    for (const auto& [name, prefab] : things->prefabs)
        EXPECT_NE(list.find("`" + name + "`"), std::string::npos) << name;
}

TEST(ShippedScenes, AreListedByName) {
    const SceneFolders folders{.assets = fs::path(PL_SOURCE_DIR) / "assets", .user_scenes = {}};
    const std::vector<ListedScene> scenes = list_scenes(folders);
    std::vector<std::string> names;
    for (const ListedScene& scene : scenes) {
        names.push_back(scene.name);
        EXPECT_FALSE(scene.title.empty() || scene.description.empty()) << scene.name;
        EXPECT_FALSE(scene.is_users_own);
        const auto found = find_scene(scene.name, folders);
        ASSERT_TRUE(found.ok()) << scene.name;
        EXPECT_EQ(*found, scene.file);
    }
    const auto has = [&](const char* name) {
        return std::ranges::find(names, name) != names.end();
    };
    EXPECT_TRUE(has("garden") && has("playroom") && has("hard/H05") && has("viewer/rings"));
    EXPECT_EQ(names.front(), kFirstScene);
    EXPECT_FALSE(has("materials") || has("things")) << "there to be included";
}

TEST(ShippedScenes, TheNearestIsNamed) {
    const SceneFolders assets{.assets = fs::path(PL_SOURCE_DIR) / "assets", .user_scenes = {}};
    EXPECT_EQ(nearest_scene("gardn", assets), "garden");
    EXPECT_EQ(nearest_scene("Garden", assets), "garden");
    EXPECT_EQ(nearest_scene("assets/scenes/gardn.toml", assets), "garden");
    EXPECT_EQ(nearest_scene("H05", assets), "hard/H05");
    EXPECT_EQ(nearest_scene("hard/H5", assets), "hard/H05");
    EXPECT_EQ(nearest_scene("entirely_elsewhere", assets), "");
    const auto missing = find_scene("gardn", assets);
    ASSERT_FALSE(missing.ok());
    EXPECT_EQ(missing.error().message,
              "there is no scene \"gardn\" here or in " + (assets.assets / "scenes").string() +
                  "; the nearest is \"garden\"; plumbline scenes lists them");
    const auto folder = find_scene(PL_SOURCE_DIR "/docs", assets);
    ASSERT_FALSE(folder.ok());
    EXPECT_NE(folder.error().message.find(": it is a folder"), std::string::npos);
}

// Copies that were adopted lie there.
TEST(UserScenes, AreFoundByNameAndStandForShippedOnes) {
    const test::TemporaryFolder folder;
    const std::string text = "[scene]\ntitle = \"mine\"\n[[entity]]\nname = \"a\"\n";
    const fs::path copy = folder.write("scenes/pile-adopted.toml", text);
    const fs::path deeper = folder.write("scenes/tries/one.toml", text);
    const fs::path garden = folder.write("scenes/garden.toml", text);
    const SceneFolders folders{.assets = fs::path(PL_SOURCE_DIR) / "assets",
                               .user_scenes = folder.path() / "scenes"};
    for (const auto& [name, file] : {std::pair{"pile-adopted", copy},
                                     {"pile-adopted.toml", copy},
                                     {"tries/one", deeper},
                                     {"garden", garden}}) {
        const auto found = find_scene(name, folders);
        ASSERT_TRUE(found.ok()) << name;
        EXPECT_EQ(*found, file) << name;
    }
    EXPECT_EQ(nearest_scene("pile-adoptd", folders), "pile-adopted");
    std::vector<std::string> own;
    std::size_t gardens = 0;
    for (const ListedScene& scene : list_scenes(folders)) {
        gardens += scene.name == "garden" ? 1U : 0U;
        if (!scene.is_users_own) continue;
        own.push_back(scene.name);
        EXPECT_EQ(scene.title, "mine");
    }
    EXPECT_EQ(own, (std::vector<std::string>{"garden", "pile-adopted", "tries/one"}));
    EXPECT_EQ(gardens, 1U);
    EXPECT_TRUE(find_scene("pile", folders).ok());
    EXPECT_FALSE(find_scene("pile-adopted", {folders.assets, {}}).ok());
}

// A level that was exported is a scene like one that was saved; a model that a scene shows is none.
TEST(UserScenes, GltfFilesAreListedWhereBodiesMoveInThem) {
    const test::TemporaryFolder folder;
    const auto gltf = [](const char* extension) {
        return fmt::format(R"({{"asset":{{"version":"2.0"}},"extensionsUsed":["{}"]}})", extension);
    };
    const fs::path level = folder.write("level.gltf", gltf("KHR_physics_rigid_bodies"));
    folder.write("draft.glb", gltf("KHR_rigid_bodies"));
    folder.write("chair.gltf", gltf("KHR_materials_unlit"));
    const fs::path both = folder.write("both.toml", "[scene]\ntitle = \"both\"\n[sky]\n");
    folder.write("both.gltf", gltf("KHR_physics_rigid_bodies"));
    const SceneFolders folders{.assets = folder.path() / "assets", .user_scenes = folder.path()};
    std::vector<std::string> titles;
    for (const ListedScene& scene : list_scenes(folders)) titles.push_back(scene.title);
    EXPECT_EQ(titles, (std::vector<std::string>{"both", "draft", "level"}));
    const auto found = find_scene("level", folders);
    ASSERT_TRUE(found.ok());
    EXPECT_EQ(*found, level);
    EXPECT_EQ(*find_scene("both", folders), both);
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

// SOURCES A3, A12: numbers as the screen showed them.
TEST(ShippedScenes, TheBooksColoursAreOfTheScreen) {
    Diagnostics faults;
    const std::filesystem::path assets = std::filesystem::path(PL_SOURCE_DIR) / "assets";
    const auto scene = read_description(assets / "scenes/book/box.toml", assets, faults);
    ASSERT_TRUE(scene.ok());
    const auto shown = [](float linear) {
        const double value = static_cast<double>(linear);
        return std::lround(255 * (1.055 * std::pow(value, 1 / 2.4) - 0.055));
    };
    EXPECT_EQ(shown(scene->camera.clear_color.x), 153);
    EXPECT_EQ(shown(scene->camera.clear_color.y), 166);
    EXPECT_EQ(shown(scene->camera.clear_color.z), 217);
    EXPECT_EQ(shown(scene->materials.at("red").base_color.y), 51);
    expect_near(scene->camera.position_m, {10, 5, 0});
    expect_near(scene->camera.target_m, {0, 0, 0});
    expect_near(scene->camera.up, {0, 1, 0});
    EXPECT_NEAR(scene->camera.fov_y_rad, kPi / 2, kSlack);
    EXPECT_NEAR(scene->camera.near_m, 1, kSlack);
    EXPECT_NEAR(scene->camera.far_m, 1000, 1e-3);
}

}  // namespace
}  // namespace plumbline::scene
