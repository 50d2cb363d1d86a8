// Wheels of a vehicle: they carry it where the file says, roll along with it, and stand in the state file for themselves.
#include "engine/scene/simulation/entity_lookup.h"
#include "engine/scene/state_report.h"
#include "tests/support/cart.h"

#include <nlohmann/json.hpp>

namespace plumbline::scene {
namespace {

using nlohmann::json;

TEST(SimulationVehicles, RestWhereTheFileSays) {
    test::Running run(test::cart_at(0));
    run.step(180);
    EXPECT_NEAR(static_cast<double>(run.state("chassis").world_from_body.position.y), 0.65, 1e-3);
    const json state = json::parse(state_json(*run.simulation, {}, "[]", 0, true));
    EXPECT_EQ(state["bodies"].size(), 1U) << "the vehicle stands for its wheels";
    ASSERT_EQ(state["vehicles"].size(), 1U);
    EXPECT_EQ(state["vehicles"][0]["name"], "cart");
    ASSERT_EQ(state["vehicles"][0]["wheels"].size(), 4U);
    for (const json& wheel : state["vehicles"][0]["wheels"]) {
        EXPECT_EQ(wheel["on_ground"], true);
        EXPECT_NEAR(wheel["load_N"].get<double>(), test::kCart_kg * 9.81 / 4, 2);
        EXPECT_NEAR(wheel["position_m"][1].get<double>(), 0.35, 1e-3);
    }
    EXPECT_TRUE(run->warnings.empty());
}

TEST(SimulationVehicles, RollWithoutLoss) {
    test::Running run(test::cart_at(5));
    run.step(120);
    const Vehicle& cart = run->vehicles().front();
    EXPECT_NEAR(static_cast<double>(run.state("chassis").velocity_mps.z), -5, 2e-3);
    for (const Wheel& wheel : cart.wheels) EXPECT_NEAR(run->spin_radps(wheel), 5 / 0.35, 0.02);
}

TEST(SimulationVehicles, WheelsTooLightForTheirLoadAreNamed) {
    SceneDescription scene = test::cart_at(0);
    scene.forces.vehicles.front().location = in_file("test.toml", 30);
    scene.forces.vehicles.front().wheels[1].mass_kg = 0.1;
    test::Running run(scene);
    ASSERT_EQ(run->warnings.size(), 1U);
    EXPECT_EQ(run->warnings[0],
              "test.toml:30: vehicle cart: a wheel of 0.1 kg carries 100 kg and may stick as it "
              "rolls; make it 1 kg or more");
}

// What nobody holds rolls on by itself.
TEST(SimulationVehicles, LoseAWheelAndItsHub) {
    test::Running run(test::cart_at(5));
    const Wheel wheel = run->vehicles().front().wheels.front();
    for (const physics::BodyId body : {wheel.body, wheel.hub})
        run->registry.mark_for_destruction(entity_of(*run, body));
    run.step(60);
    EXPECT_FALSE(run->physics.contains(wheel.axle));
    EXPECT_EQ(run->spin_radps(wheel), 0);
    EXPECT_LT(static_cast<double>(run.state("chassis").world_from_body.position.z), -2);
}

}  // namespace
}  // namespace plumbline::scene
