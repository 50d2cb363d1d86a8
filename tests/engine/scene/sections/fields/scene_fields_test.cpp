// Keys of forces that bodies feel: what they say is what the description holds, what they get wrong is named.
#include "tests/engine/scene/sections/scene_file_fixture.h"

namespace plumbline::scene {
namespace {

const std::string kBall =
    "[[entity]]\nname = \"ball\"\nprimitive = { sphere = 0.5 }\n[entity.body]\nmass_kg = 2\n";

TEST_F(SceneFileTest, KeysOfBodiesInFieldsAreRead) {
    const Outcome outcome =
        load(kBall +
             "drag = { coefficient = 1.1, area_m2 = 0.25, spin_lift = 0.5 }\n"
             "magnet = { moment_Am2 = [0, 0, 50] }\n"
             "[[entity]]\nname = \"belt\"\nprimitive = { box = [1, 1, 1] }\n[entity.body]\nkind = "
             "\"static\"\n"
             "surface_velocity_mps = [0, 0, 2]\nsurface_spin_degps = [0, 180, 0]\n");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    EXPECT_TRUE(outcome.faults.empty());
    const BodyDescription& ball = *outcome.scene->entities[0].body;
    ASSERT_TRUE(ball.drag);
    EXPECT_EQ(ball.drag->coefficient, 1.1_r);
    EXPECT_EQ(ball.drag->area_m2, 0.25_r);
    EXPECT_EQ(ball.drag->spin_lift, 0.5_r);
    ASSERT_TRUE(ball.magnet);
    expect_near(ball.magnet->moment_Am2, {0, 0, 50});
    const BodyDescription& belt = *outcome.scene->entities[1].body;
    expect_near(belt.surface_velocity_mps, {0, 0, 2});
    expect_near(belt.surface_spin_radps, {0, kPi, 0});
}

TEST_F(SceneFileTest, AirWaterAndChargesAreRead) {
    const Outcome outcome = load(R"([world]
air_density_kgpm3 = 1.0
magnetic_field_T = [0, 0.5, 0]
[wind]
shelter = true
[[wind_zone]]
min_m = [-1, 0, -1]
max_m = [1, 2, 1]
velocity_mps = [0, 0, 5]
[[water]]
name = "pond"
min_m = [-5, -2, -5]
max_m = [5, 0, 5]
density_kgpm3 = 1025
drag = 0
flow_mps = [1, 0, 0]
probes_m = [[0, 0], [1, 2]]
[[water]]
min_m = [10, -2, -5]
max_m = [15, 0, 5]
[[explosion]]
at_s = 1
position_m = [0, 1, 0]
impulse_Ns = 500
reach_m = 12
[[explosion]]
position_m = [0, 2, 0]
[effects.drag]
fidelity = "precise"
[effects.magnets]
fidelity = "draft"
)");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    EXPECT_TRUE(outcome.faults.empty());
    const SceneDescription& scene = *outcome.scene;
    EXPECT_EQ(scene.forces.air_density_kgpm3, Real{1});
    expect_near(scene.forces.magnetic_field_T, {0, 0.5_r, 0});
    EXPECT_TRUE(scene.wind->shelter);
    ASSERT_EQ(scene.forces.wind_zones.size(), 1U);
    expect_near(scene.forces.wind_zones.front().velocity_mps, {0, 0, 5});
    ASSERT_EQ(scene.forces.waters.size(), 2U);
    EXPECT_EQ(scene.forces.waters[0].density_kgpm3, Real{1025});
    EXPECT_EQ(scene.forces.waters[0].drag, Real{0});
    ASSERT_EQ(scene.forces.waters[0].probes_m.size(), 2U);
    EXPECT_EQ(scene.forces.waters[0].probes_m[1], (Vec2{1, 2}));
    EXPECT_EQ(scene.forces.waters[1].name, "water#2");
    ASSERT_EQ(scene.forces.explosions.size(), 2U);
    EXPECT_EQ(scene.forces.explosions[0].at_s, 1.0);
    EXPECT_FALSE(scene.forces.explosions[1].at_s);
    EXPECT_EQ(scene.forces.explosions[1].impulse_Ns, Real{1000});
    EXPECT_EQ(scene.forces.fidelity.drag, Fidelity::Precise);
    EXPECT_EQ(scene.forces.fidelity.magnets, Fidelity::Draft);
    EXPECT_EQ(scene.forces.fidelity.buoyancy, Fidelity::Balanced);
}

TEST_F(SceneFileTest, FaultsOfFieldsAreNamed) {
    const auto fault = [&](const std::string& text) {
        const Outcome outcome = load(text);
        return outcome.faults.size() == 1 ? outcome.faults.front()
                                          : fmt::format("{}", fmt::join(outcome.faults, "\n"));
    };
    EXPECT_EQ(fault(kBall + "drag = { coefficient = -1 }\n"),
              "scene.toml:6:24: error: entity[0].body.drag.coefficient: -1; expected a coefficient "
              "from 0 to 100");
    EXPECT_EQ(fault(kBall + "magnet = {}\n"),
              "scene.toml:6:10: error: entity[0].body.magnet.moment_Am2: missing; expected [x, y, "
              "z] in A m2");
    EXPECT_EQ(fault(kBall + "surface_velocity_mps = [1, 0, 0]\n"),
              "scene.toml:6:24: warning: entity[0].body.surface_velocity_mps: only static and "
              "kinematic bodies are belts; ignored");
    EXPECT_EQ(
        fault(
            "[[entity]]\nname = \"floor\"\nprimitive = { box = [1, 1, 1] }\n[entity.body]\nkind = "
            "\"static\"\ndrag = {}\n"),
        "scene.toml:6:8: warning: entity[0].body.drag: only dynamic bodies are moved by the "
        "air; ignored");
    EXPECT_EQ(
        fault("[[water]]\nbasin = \"tub\"\n"),
        "scene.toml:1:1: error: water[0].level_m: missing; expected the height of the surface "
        "in m, world");
    EXPECT_EQ(fault("[[water]]\nbasin = \"tub\"\nlevel_m = 1\nmin_m = [0, 0, 0]\n"),
              "scene.toml:4:9: error: water[0].min_m: a basin's mesh says where its water is");
    EXPECT_EQ(fault("[[water]]\nmin_m = [0, 0, 0]\nmax_m = [1, -1, 1]\n"),
              "scene.toml:3:9: error: water[0].max_m: is not above min_m along every axis");
    EXPECT_EQ(fault("[[water]]\nmin_m = [0, 0, 0]\nmax_m = [1, 1, 1]\nprobes_m = [[1]]\n"),
              "scene.toml:4:12: error: water[0].probes_m: expected [x, z] in m for each place");
    EXPECT_EQ(
        fault("[[wind_zone]]\nmin_m = [0, 0, 0]\nmax_m = [1, 1, 1]\n"),
        "scene.toml:1:1: error: wind_zone[0].velocity_mps: missing; expected [x, y, z] in m/s; or "
        "wind_share");
    EXPECT_EQ(fault("[[wind_zone]]\nmin_m = [0, 0, 0]\nmax_m = [1, 1, 1]\nwind_share = 2\n"),
              "scene.toml:4:14: error: wind_zone[0].wind_share: 2; expected a share from 0 to 1");
    EXPECT_EQ(fault("[[explosion]]\nposition_m = [0, 0, 0]\nimpulse_Ns = -5\n"),
              "scene.toml:3:14: error: explosion[0].impulse_Ns: -5; expected N s from 0 to 1e9");
    std::string many;
    for (int i = 0; i < 17; ++i) many += "[[water]]\nmin_m = [0, 0, 0]\nmax_m = [1, 1, 1]\n";
    EXPECT_EQ(fault(many), "scene.toml:1:1: error: water: 17 of them; at most 16 are kept");
}

}  // namespace
}  // namespace plumbline::scene
