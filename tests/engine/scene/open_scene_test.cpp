#include "engine/scene/open_scene.h"

#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

namespace plumbline::scene {
namespace {
namespace fs = std::filesystem;

constexpr const char* kScene = R"([scene]
title = "one cube"
include = ["wood.toml"]
[accuracy]
preset = "auto"
tolerance = 0.01
[[entity]]
name = "cube"
position_m = [0, 5, 0]
primitive = { box = [1, 1, 1] }
material = "oak"
[entity.body]
kind = "dynamic"
[[entity]]
name = "chair"
model = "chair.obj"
[entity.body]
kind = "static"
shape = { mesh = "model" }
)";

class OpenScene : public testing::Test {
protected:
    OpenScene() {
        write("one.toml", kScene);
        write("wood.toml", "[[material]]\nname = \"oak\"\nbase_color_map = \"oak.png\"\n");
        write("chair.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        write("oak.png", "no image");
        write("config/surfaces.toml", "[wood]\nfriction = 0.5\n");
    }
    void write(const std::string& name, const std::string& text) {
        const fs::path file = folder_.path() / name;
        fs::create_directories(file.parent_path());
        std::ofstream(file, std::ios::binary) << text;
    }
    OpenOptions options() const {
        return {.folders = {
                    .assets = folder_.path(), .shaders = {}, .config = folder_.path() / "config"}};
    }
    OpenedScene open(const OpenOptions& how) {
        Diagnostics faults;
        Result<OpenedScene> opened = open_scene(folder_.path() / "one.toml", how, faults);
        EXPECT_TRUE(opened.ok()) << (opened.ok() ? "" : opened.error().message);
        return opened ? std::move(*opened) : OpenedScene{};
    }

    test::TemporaryFolder folder_;
};

TEST_F(OpenScene, NamesEveryFileThatTakesPart) {
    std::vector<std::pair<std::string, FileUse>> files;
    for (const FileStamp& file : open(options()).files)
        files.emplace_back(file.path.lexically_relative(folder_.path()).string(), file.use);
    const std::vector<std::pair<std::string, FileUse>> expected{
        {"one.toml", FileUse::Scene},
        {"wood.toml", FileUse::Scene},
        {"config/surfaces.toml", FileUse::Surfaces},
        {"chair.obj", FileUse::Model},
        {"oak.png", FileUse::Image}};
    EXPECT_EQ(files, expected);
}

TEST_F(OpenScene, TellsWhenOneOfItsFilesIsAnother) {
    for (const char* name : {"one.toml", "wood.toml", "config/surfaces.toml", "chair.obj"}) {
        const OpenedScene scene = open(options());
        ASSERT_TRUE(unchanged(scene.files)) << name;
        std::ofstream(folder_.path() / name, std::ios::app) << "\n# longer\n";
        EXPECT_FALSE(unchanged(scene.files)) << name;
    }
    const OpenedScene scene = open(options());
    fs::remove(folder_.path() / "oak.png");
    EXPECT_FALSE(unchanged(scene.files));
}

TEST_F(OpenScene, TheMotionHashCoversIncludesModelsAndSurfacesButNoImages) {
    const std::uint64_t first = open(options()).motion_hash();
    EXPECT_EQ(open(options()).motion_hash(), first);
    write("oak.png", "another image");
    EXPECT_EQ(open(options()).motion_hash(), first);
    std::vector<std::uint64_t> hashes{first};
    for (const char* name : {"one.toml", "wood.toml", "config/surfaces.toml", "chair.obj"}) {
        std::ofstream(folder_.path() / name, std::ios::app) << "\n# longer\n";
        const std::uint64_t hash = open(options()).motion_hash();
        EXPECT_EQ(std::ranges::count(hashes, hash), 0) << name;
        hashes.push_back(hash);
    }
}

TEST_F(OpenScene, OverridesAreInPlaceForWhoResolvesAuto) {
    OpenOptions how = options();
    how.overrides = {.solver = physics::Solver::BulletSi, .step_hz = 120};
    OpenedScene scene = open(how);
    Accuracy& accuracy = scene.description.accuracy;
    EXPECT_EQ(accuracy.preset, "auto");
    EXPECT_TRUE(accuracy.step_hz_given);
    EXPECT_EQ(accuracy.step_hz, 120);
    EXPECT_TRUE(accuracy.solver_given);
    EXPECT_EQ(scene.files.size(), 5U) << "what a kept study is found by";
    assets::AssetLibrary library;
    const auto as_it_stands = scene.build(library);
    ASSERT_TRUE(as_it_stands.ok());
    EXPECT_EQ((*as_it_stands)->physics.def().substeps, preset_of("balanced").bullet_substeps);
    accuracy.substeps = 7;
    const auto resolved = scene.build(library);
    ASSERT_TRUE(resolved.ok());
    EXPECT_EQ((*resolved)->step_s(), 1.0 / 120);
    EXPECT_EQ((*resolved)->physics.def().solver, physics::Solver::BulletSi);
    EXPECT_EQ((*resolved)->physics.def().substeps, 7);
}

TEST_F(OpenScene, WarningsOfTheFilesAreTheSimulationsToo) {
    write("one.toml", "[world]\ngravity_mps2 = [0, -5000, 0]\n");
    const OpenedScene scene = open(options());
    ASSERT_EQ(scene.warnings.size(), 1U);
    EXPECT_NE(scene.warnings[0].find("one.toml:2:16: warning: world.gravity_mps2"),
              std::string::npos)
        << scene.warnings[0];
    assets::AssetLibrary library;
    const auto simulation = scene.build(library);
    ASSERT_TRUE(simulation.ok());
    EXPECT_EQ((*simulation)->warnings, scene.warnings);
}

TEST_F(OpenScene, TheFirstFaultRefusesItAndAllAreKept) {
    write("one.toml", "[accuracy]\nstep_hz = 0\nsubsteps = \"many\"\n");
    Diagnostics faults;
    const auto opened = open_scene(folder_.path() / "one.toml", options(), faults);
    ASSERT_FALSE(opened.ok());
    EXPECT_EQ(opened.error().exit_code, ExitCode::Refused);
    EXPECT_EQ(opened.error().message, to_string(faults.list().front()));
    EXPECT_EQ(faults.list().size(), 2U);
}

// A scene that is built over and over, as at each reload, adds nothing.
TEST_F(OpenScene, FiftyReloadsLeaveTheLibraryAsItIs) {
    assets::AssetLibrary library;
    ASSERT_TRUE(open(options()).build(library).ok());
    const std::size_t materials = library.material_count();
    const std::size_t meshes = library.mesh_count();
    for (int i = 0; i < 50; ++i) ASSERT_TRUE(open(options()).build(library).ok());
    EXPECT_EQ(library.material_count(), materials);
    EXPECT_EQ(library.mesh_count(), meshes);
}

}  // namespace
}  // namespace plumbline::scene
