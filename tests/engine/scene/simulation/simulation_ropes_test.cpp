// Ropes of a scene: pieces and joints as the file says, told of in the state file, broken where they carry too much.
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

constexpr double kLoad_N = 1000 * 9.81;  // of a cube

RopeDescription rope_to(const std::string& b, const Vec3& from_m, const Vec3& to_m) {
    RopeDescription rope;
    rope.name = "line";
    rope.a = "world";
    rope.b = b;
    rope.anchor_a_m = from_m;
    rope.anchor_b_m = to_m;
    rope.length_m = glm::distance(Vec3d(from_m), Vec3d(to_m));
    rope.mass_kg = 2;
    rope.location = in_file("test.toml", 40);
    return rope;
}

json ropes_state(const Running& run) {
    return json::parse(state_json(*run.simulation, {}, "[]", 0, true));
}

// Also where it is tied to the middle of a body, whose shape its last pieces lie in.
TEST(SimulationRopes, HoldALoad) {
    SceneDescription scene = scene_of({cube("load", {0, 5, 0})});
    scene.forces.ropes = {rope_to("load", {0, 8, 0}, {0, 5, 0})};
    Running run(scene);
    run.step(120);
    EXPECT_NEAR(static_cast<double>(run.state("load").world_from_body.position.y), 5, 1e-3);
    const json state = ropes_state(run);
    EXPECT_EQ(state["bodies"].size(), 1U);  // the rope stands for its pieces
    ASSERT_EQ(state["ropes"].size(), 1U);
    const json& rope = state["ropes"][0];
    EXPECT_EQ(rope["name"], "line");
    ASSERT_EQ(rope["points_m"].size(), 21U);
    EXPECT_NEAR(rope["points_m"][0][1].get<double>(), 8, 1e-6);
    EXPECT_NEAR(rope["points_m"][20][1].get<double>(), 5, 1e-3);
    EXPECT_NEAR(rope["length_m"].get<double>(), 3, 1e-3);
    EXPECT_NEAR(rope["tension_N"]["b"].get<double>(), kLoad_N, 1e-3 * kLoad_N);
    EXPECT_NEAR(rope["tension_N"]["a"].get<double>(), kLoad_N + 2 * 9.81, 1e-3 * kLoad_N);
    EXPECT_EQ(rope["broken"], false);
}

// Slow swings are not damped by what calms fast ones: m g / k to and fro, for as long as asked.
TEST(SimulationRopes, AWeightBouncesOnAnElasticOne) {
    for (const Fidelity fidelity : {Fidelity::Draft, Fidelity::Balanced}) {
        SceneDescription scene = scene_of({cube("load", {0, 5, 0})});
        scene.forces.fidelity.rope = fidelity;
        RopeDescription rope = rope_to("load", {0, 8, 0}, {0, 5, 0});
        rope.stiffness_N = 3 * 4e5;  // 4e5 N/m: 20 rad/s
        scene.forces.ropes = {rope};
        Running run(scene);
        const double reach_m = kLoad_N / 4e5;
        const auto amplitude_m = [&] {
            double least_m = 1e9;
            double most_m = -1e9;
            for (int i = 0; i < 60; ++i) {
                run.step(1);
                const auto y = static_cast<double>(run.state("load").world_from_body.position.y);
                least_m = std::min(least_m, y);
                most_m = std::max(most_m, y);
            }
            return (most_m - least_m) / 2;
        };
        EXPECT_NEAR(amplitude_m(), reach_m, 0.02 * reach_m);
        run.step(480);
        EXPECT_NEAR(amplitude_m(), reach_m, 0.02 * reach_m);
    }
}

TEST(SimulationRopes, BreakAboveTheirLimit) {
    SceneDescription scene = scene_of({cube("load", {0, 5, 0})});
    scene.forces.ropes = {rope_to("load", {0, 8, 0}, {0, 5, 0})};
    scene.forces.ropes.front().break_N = 0.5 * kLoad_N;
    Running run(scene);
    run.step(120);
    EXPECT_LT(run.state("load").world_from_body.position.y, 0);
    EXPECT_EQ(ropes_state(run)["ropes"][0]["broken"], true);
    ASSERT_FALSE(run->warnings.empty());
    EXPECT_NE(run->warnings.back().find("rope line broke at"), std::string::npos);
}

// As many as asked for; else by fidelity, more in a long rope, fewer in a thick one.
TEST(SimulationRopes, PiecesGoByFidelityAndLength) {
    const auto pieces = [](double length_m, double radius_m, Fidelity fidelity) {
        SceneDescription scene = scene_of({});
        RopeDescription rope = rope_to("", {0, 50, 0}, {0, static_cast<Real>(50 - length_m), 0});
        rope.radius_m = radius_m;
        scene.forces.ropes = {rope};
        scene.forces.fidelity.rope = fidelity;
        const Running run(scene);
        return run.simulation->ropes().front().pieces.size();
    };
    EXPECT_EQ(pieces(2, 0.01, Fidelity::Draft), 8U);
    EXPECT_EQ(pieces(2, 0.01, Fidelity::Balanced), 20U);
    EXPECT_EQ(pieces(2, 0.01, Fidelity::Precise), 40U);
    EXPECT_EQ(pieces(20, 0.01, Fidelity::Balanced), 80U);
    EXPECT_EQ(pieces(2, 0.1, Fidelity::Balanced), 10U);
}

TEST(SimulationRopes, AMissingEndIsRefused) {
    SceneDescription scene = scene_of({});
    scene.forces.ropes = {rope_to("load", {0, 8, 0}, {0, 5, 0})};
    assets::AssetLibrary library;
    const auto built = build_simulation(scene, {}, library, test::plain_surfaces());
    ASSERT_FALSE(built.ok());
    EXPECT_NE(built.error().message.find("rope line: \"load\" has no body"), std::string::npos);
}

}  // namespace
}  // namespace plumbline::scene
