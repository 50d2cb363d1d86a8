// Soft bodies of a scene: cells and pins as the file says, told of in the state file.
#include "engine/physics/soft_body.h"
#include "engine/scene/state_report.h"
#include "tests/support/scene_in_code.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace plumbline::scene {
namespace {

using nlohmann::json;
using test::Running;
using test::scene_of;

SoftDescription jelly() {
    SoftDescription soft;
    soft.name = "jelly";
    soft.pose.position = {0, 2, 0};
    soft.location = in_file("test.toml", 40);
    return soft;
}

Running running(const SoftDescription& soft, Fidelity fidelity = Fidelity::Balanced) {
    SceneDescription scene = scene_of({});
    scene.forces.softs = {soft};
    scene.forces.fidelity.soft = fidelity;
    return Running(scene);
}

const physics::SoftBody& soft_of(Running& run) {
    return dynamic_cast<const physics::SoftBody&>(run->softs().front().body->body());
}

TEST(SimulationSofts, CellsFollowFidelityOrTheFile) {
    Running draft = running(jelly(), Fidelity::Draft);
    EXPECT_EQ(soft_of(draft).grid().cells.size(), 64U);
    Running balanced = running(jelly());
    EXPECT_EQ(soft_of(balanced).grid().cells.size(), 216U);
    SoftDescription flat = jelly();
    flat.size_m = {1, 0.2, 0.5};
    flat.cell_m = 0.25;
    Running coarse = running(flat);
    EXPECT_EQ(soft_of(coarse).grid().cells.size(), 4U * 1U * 2U);
    flat.form = SoftForm::Ellipsoid;
    Running round = running(flat);
    EXPECT_EQ(soft_of(round).grid().cells.size(), 8U * 2U * 4U);
    EXPECT_NEAR(soft_of(round).rest_volume_m3(), 4.0 / 3 * 3.14159265358979 * 0.2 * 0.5, 1e-6);
}

TEST(SimulationSofts, PinsHoldWhatIsInTheirBox) {
    SoftDescription soft = jelly();
    soft.cell_m = 0.5;
    soft.pins = {{.min_m = {-9, 2.4_r, -9}, .max_m = {9, 9, 9}, .to = {}}};
    Running run = running(soft);
    int pinned = 0;
    for (std::size_t i = 0; i < soft_of(run).positions_m().size(); ++i)
        pinned += soft_of(run).inverse_mass(i) == 0 ? 1 : 0;
    EXPECT_EQ(pinned, 9);
    const json state = json::parse(state_json(*run, {}, "[]", 0, true))["softs"][0];
    EXPECT_EQ(state["name"], "jelly");
    EXPECT_EQ(state["points_m"].size(), 27U);
    EXPECT_NEAR(state["volume_m3"], 1, 1e-6);
    EXPECT_NEAR(state["rest_volume_m3"], 1, 1e-6);
}

// A model that cannot be had is a box, as elsewhere.
TEST(SimulationSofts, AMissingModelIsABox) {
    SoftDescription soft = jelly();
    soft.form = SoftForm::Model;
    soft.model = "none.glb";
    Running run = running(soft);
    EXPECT_GT(soft_of(run).grid().cells.size(), 0U);
    EXPECT_FALSE(run->warnings.empty());
}

TEST(SimulationSofts, APinNeedsABody) {
    SceneDescription scene = scene_of({});
    SoftDescription soft = jelly();
    soft.pins = {{.min_m = {-9, -9, -9}, .max_m = {9, 9, 9}, .to = "pole"}};
    scene.forces.softs = {soft};
    assets::AssetLibrary library;
    const auto built = build_simulation(scene, {}, library, test::plain_surfaces());
    ASSERT_FALSE(built.ok());
    EXPECT_NE(built.error().message.find("test.toml:40: soft body jelly"), std::string::npos)
        << built.error().message;
}

}  // namespace
}  // namespace plumbline::scene
