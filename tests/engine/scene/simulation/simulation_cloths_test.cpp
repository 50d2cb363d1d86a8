// Cloths of a scene: cells and pins as the file says, told of in the state file.
#include "engine/physics/sheet.h"
#include "engine/scene/state_report.h"
#include "tests/support/scene_in_code.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace plumbline::scene {
namespace {

using nlohmann::json;
using test::cube;
using test::Running;
using test::scene_of;

ClothDescription flag() {
    ClothDescription cloth;
    cloth.name = "flag";
    cloth.size_m = {1, 0.5};
    cloth.pose.position = {0, 2, 0};
    cloth.location = in_file("test.toml", 40);
    return cloth;
}

const physics::Sheet& sheet_of(Running& run) {
    return dynamic_cast<const physics::Sheet&>(run->cloths().front().body->body());
}

TEST(SimulationCloths, CellsFollowFidelityOrTheFile) {
    for (const auto fidelity : {Fidelity::Draft, Fidelity::Balanced, Fidelity::Precise}) {
        SceneDescription scene = scene_of({});
        scene.forces.cloths = {flag()};
        scene.forces.fidelity.cloth = fidelity;
        Running run(scene);
        const std::uint32_t along = 10U << static_cast<unsigned>(fidelity);
        EXPECT_EQ(sheet_of(run).columns(), along + 1);
        EXPECT_EQ(sheet_of(run).rows(), along / 2 + 1);
    }
    SceneDescription scene = scene_of({});
    scene.forces.cloths = {flag()};
    scene.forces.cloths.front().cells = {{3, 2}};
    Running run(scene);
    EXPECT_EQ(sheet_of(run).positions_m().size(), 12U);
}

TEST(SimulationCloths, EachFoldHasTwoCells) {
    SceneDescription scene = scene_of({});
    scene.forces.cloths = {flag()};
    scene.forces.cloths.front().folds = 12;
    scene.forces.cloths.front().gather = 0.5;
    Running run(scene);
    const auto points_m = sheet_of(run).positions_m();
    EXPECT_EQ(sheet_of(run).columns(), 25U);
    EXPECT_NEAR(points_m[24].x - points_m[0].x, 0.5, 1e-9);
    EXPECT_NEAR(glm::distance(points_m[0], points_m[1]), 1.0 / 24, 1e-9);
}

TEST(SimulationCloths, PinsHoldPointsAndEdges) {
    SceneDescription scene = scene_of({cube("pole", {-1, 2, 0})});
    ClothDescription cloth = flag();
    cloth.cells = {{4, 2}};
    cloth.pins = {{.along = {0, 0, 0, 1}, .to = "pole"}, {.along = {1, 0.5, 1, 0.5}, .to = {}}};
    scene.forces.cloths = {cloth};
    Running run(scene);
    std::vector<std::size_t> pinned;
    for (std::size_t i = 0; i < 15; ++i) {
        if (sheet_of(run).inverse_mass(i) == 0) pinned.push_back(i);
    }
    EXPECT_EQ(pinned, (std::vector<std::size_t>{0, 5, 9, 10}));
    const json state = json::parse(state_json(*run, {}, "[]", 0, true))["cloths"][0];
    EXPECT_EQ(state["name"], "flag");
    EXPECT_EQ(state["columns"], 5);
    EXPECT_EQ(state["rows"], 3);
    EXPECT_EQ(state["points_m"].size(), 15U);
    EXPECT_NEAR(state["points_m"][0][0], -0.5, 1e-6);
    EXPECT_NEAR(state["points_m"][0][1], 2.25, 1e-6);
    EXPECT_NEAR(state["area_m2"], 0.5, 1e-6);
    EXPECT_EQ(state["torn"], 0);
}

TEST(SimulationCloths, APinNeedsABody) {
    SceneDescription scene = scene_of({});
    ClothDescription cloth = flag();
    cloth.pins = {{.along = {0, 0, 0, 1}, .to = "pole"}};
    scene.forces.cloths = {cloth};
    assets::AssetLibrary library;
    const auto built = build_simulation(scene, {}, library, test::plain_surfaces());
    ASSERT_FALSE(built.ok());
    EXPECT_NE(built.error().message.find("test.toml:40: cloth flag"), std::string::npos)
        << built.error().message;
}

}  // namespace
}  // namespace plumbline::scene
