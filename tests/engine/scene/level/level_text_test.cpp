// A level: what play has changed, written as a scene that starts from another one, and read back.
#include "engine/scene/level/level_text.h"

#include "engine/scene/open_scene.h"
#include "engine/scene/scene_file.h"
#include "tests/support/scene_in_code.h"
#include "tests/support/temporary_folder.h"

#include <cmath>

namespace plumbline::scene {
namespace {

constexpr const char* kBase = R"(
[[prefab]]
name = "brick"
primitive = { box = [0.4, 0.2, 0.2] }
[prefab.body]
mass_kg = 3
[[entity]]
name = "ground"
primitive = { plane = [40, 40] }
body = { kind = "static" }
[[entity]]
name = "ball"
position_m = [5, 0.5, 0]
primitive = { sphere = 0.5 }
body = { mass_kg = 2 }
[[array]]
name = "box"
prefab = "brick"
count = [3, 1, 1]
origin_m = [0, 0.1, 0]
spacing_m = [1, 1, 1]
turn_deg = [30, 0, 0]
)";

/// A scene file in a folder of its own, and what runs of it.
struct LevelFolder {
    test::TemporaryFolder folder;
    std::filesystem::path base = folder.write("base.toml", kBase);

    std::unique_ptr<test::Running> run(const std::filesystem::path& file) const {
        Diagnostics faults;
        const Result<SceneDescription> scene = read_description(file, {}, faults);
        EXPECT_TRUE(scene.ok()) << (scene.ok() ? "" : scene.error().message);
        EXPECT_TRUE(faults.list().empty()) << to_string(faults.list().front());
        return scene ? std::make_unique<test::Running>(*scene) : nullptr;
    }
    /// Of the level that is written of it.
    std::unique_ptr<test::Running> again(const test::Running& run) const {
        return this->run(folder.write(
            "level.toml", level_text(*run.simulation, "a \"level\"", "base.toml").toml));
    }
};

physics::BodyId body_of(const test::Running& run, std::string_view name) {
    return run.simulation->registry.get<BodyRef>(run.simulation->find(name)).body;
}

TEST(LevelText, OfNothingChangedIsTheScene) {
    const LevelFolder files;
    const auto run = files.run(files.base);
    const LevelText level = level_text(**run, "t", "base.toml");
    EXPECT_EQ(level.toml,
              "# Made in play from base.toml.\n[scene]\ntitle = \"t\"\nbase = \"base.toml\"\n");
    EXPECT_TRUE(level.notes.empty());
}

TEST(LevelText, KeepsWhatWasMovedFrozenAndRemoved) {
    const LevelFolder files;
    const auto run = files.run(files.base);
    const Quat turn = glm::normalize(Quat{0.9_r, 0, 0.3_r, 0});
    (*run)->physics.set_pose(body_of(*run, "box.1.0.0"), {{1, 4, 0}, turn});
    (*run)->physics.set_frozen(body_of(*run, "box.1.0.0"), true);
    (*run)->registry.mark_for_destruction((*run)->find("ball"));
    (*run)->destroy_marked();
    const auto level = files.again(*run);
    ASSERT_NE(level, nullptr);
    EXPECT_FALSE((*level)->find("ball"));
    EXPECT_EQ((*level)->description().title, "a \"level\"");
    level->step(60);
    const physics::BodyState box = (*level)->physics.state(body_of(*level, "box.1.0.0"));
    EXPECT_TRUE(box.frozen) << "it stands in the air";
    EXPECT_EQ(box.world_from_body.position, Vec3(1, 4, 0));
    EXPECT_NEAR(static_cast<double>(glm::dot(box.world_from_body.orientation, turn)), 1, 1e-6);
    const physics::BodyState other = (*level)->physics.state(body_of(*level, "box.2.0.0"));
    EXPECT_NEAR(static_cast<double>(other.world_from_body.orientation.y),
                std::sin(radians_from_degrees(30.0)),
                1e-3)
        << "as the array turns its copies";
}

TEST(LevelText, KeepsWhatWasDropped) {
    const LevelFolder files;
    const auto run = files.run(files.base);
    EntityDescription brick = (*run)->description().prefabs.at("brick");
    brick.name = "brick";
    brick.world_from_body.position = {-3, 2, 0};
    const ecs::Entity made = (*run)->spawn(brick);
    ASSERT_TRUE(made);
    (*run)->physics.set_frozen((*run)->registry.get<BodyRef>(made).body, true);
    const auto level = files.again(*run);
    ASSERT_NE(level, nullptr);
    const physics::BodyState there = (*level)->physics.state(body_of(*level, "brick-1"));
    EXPECT_TRUE(there.frozen);
    EXPECT_EQ(there.world_from_body.position, Vec3(-3, 2, 0));
    EXPECT_EQ(there.mass.mass_kg, Real{3});
    EXPECT_EQ((*level)->moving_bodies().size(), (*run)->moving_bodies().size());
}

TEST(LevelText, NamesTheFileOfThingsThatTheSceneDoesNotKnow) {
    const LevelFolder files;
    const auto run = files.run(files.base);
    EntityDescription barrel = test::ball("barrel", {0, 5, 0}, 0.3_r);
    ASSERT_TRUE((*run)->spawn(barrel));
    EXPECT_NE(level_text(**run, "t", "base.toml").toml.find("include = [\"things.toml\"]"),
              std::string::npos);
}

// A level that starts from a level says what is so now.
TEST(LevelText, OfALevelCountsAfterIt) {
    const LevelFolder files;
    const auto run = files.run(files.base);
    (*run)->physics.set_frozen(body_of(*run, "ball"), true);
    const auto first = files.again(*run);
    ASSERT_NE(first, nullptr);
    (*first)->physics.set_frozen(body_of(*first, "ball"), false);
    (*first)->physics.set_pose(body_of(*first, "ball"), {.position = {6, 0.5_r, 0}});
    const auto second =
        files.run(files.folder.write("second.toml", level_text(**first, "t", "level.toml").toml));
    ASSERT_NE(second, nullptr);
    const physics::BodyState ball = (*second)->physics.state(body_of(*second, "ball"));
    EXPECT_FALSE(ball.frozen);
    EXPECT_EQ(ball.world_from_body.position.x, Real{6});
}

}  // namespace
}  // namespace plumbline::scene
