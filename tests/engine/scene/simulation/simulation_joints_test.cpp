// Joints of a scene: built as the file says, told of in the state file, reported when they break.
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

constexpr double kWeight_N = 1000 * 9.81;  // of a cube

JointDescription hung(const std::string& name, const std::string& a, const Vec3& anchor_m) {
    return {.name = name,
            .kind = JointKind::Fixed,
            .a = a,
            .b = "world",
            .anchor_a_m = anchor_m,
            .anchor_b_m = anchor_m,
            .location = in_file("test.toml", 40)};
}

json state_of(const Running& run) {
    return json::parse(state_json(*run.simulation, {}, "[]", 0, true));
}

std::string refusal_of(const SceneDescription& scene) {
    assets::AssetLibrary library;
    const auto built = build_simulation(scene, {}, library, test::plain_surfaces());
    if (built) return "";
    EXPECT_EQ(built.error().exit_code, ExitCode::Refused);
    return built.error().message;
}

TEST(SimulationJoints, HoldWhatTheyName) {
    SceneDescription scene = scene_of({cube("lamp", {0, 5, 0})});
    scene.arrays.push_back({.name = "row",
                            .prefab = cube("crate", {}),
                            .origin_m = {10, 5, 0},
                            .count = {2, 1, 1},
                            .spacing_m = {2, 1, 1}});
    scene.joints = {hung("hook", "lamp", {0, 6, 0}), hung("peg", "row.1.0.0", {12, 6, 0})};
    scene.joints.push_back(hung("link", "row.0.0.0", {11, 5, 0}));
    scene.joints.back().b = "row.1.0.0";
    Running run(scene);
    run.step(120);
    EXPECT_NEAR(static_cast<double>(run.state("lamp").world_from_body.position.y), 5, 0.01);
    EXPECT_NEAR(static_cast<double>(run.state("row.0.0.0").world_from_body.position.y), 5, 0.05);
    const json state = state_of(run);
    ASSERT_EQ(state["joints"].size(), 3U);
    EXPECT_EQ(state["joints"][0]["name"], "hook");
    EXPECT_EQ(state["joints"][1]["name"], "peg");
    EXPECT_NEAR(state["joints"][0]["force_N"].get<double>(), kWeight_N, kWeight_N * 1e-4);
    EXPECT_NEAR(state["joints"][1]["force_N"].get<double>(), 2 * kWeight_N, kWeight_N * 1e-3);
    EXPECT_NEAR(state["joints"][2]["torque_Nm"].get<double>(), kWeight_N, kWeight_N * 1e-3);
    EXPECT_FALSE(state["joints"][0]["broken"].get<bool>());
    double most_m = 0;
    for (const json& joint : state["joints"]) {
        most_m = std::max(most_m, joint["error_m"].get<double>());
    }
    EXPECT_EQ(state["max_joint_error_m"].get<double>(), most_m);
    EXPECT_TRUE(run->warnings.empty());
}

TEST(SimulationJoints, PassOnEverythingTheFileSays) {
    SceneDescription scene = scene_of({cube("a", {0, 5, 0}), cube("b", {2, 5, 0})});
    const JointDescription described{.name = "all",
                                     .kind = JointKind::Cone,
                                     .a = "a",
                                     .b = "b",
                                     .anchor_a_m = {1, 5, 0},
                                     .anchor_b_m = {1, 4, 0},
                                     .axis = {1, 0, 0},
                                     .limits = {{0, 0.5_r}},
                                     .twist = {{-0.1_r, 0.2_r}},
                                     .motor = physics::JointMotor{.target = 1, .max = 2},
                                     .stiffness_Npm = 3,
                                     .damping_Nspm = 4,
                                     .rest_length_m = 5.0_r,
                                     .collide = true,
                                     .break_N = 6};
    scene.joints = {described};
    Running run(scene);
    ASSERT_EQ(run->joints().size(), 1U);
    const physics::JointDef& def = run->physics.joint(run->joints()[0].joint).def;
    EXPECT_EQ(def.kind, described.kind);
    EXPECT_EQ(def.a, run.body("a"));
    EXPECT_EQ(def.b, run.body("b"));
    EXPECT_EQ(def.anchor_a_world, described.anchor_a_m);
    EXPECT_EQ(def.anchor_b_world, described.anchor_b_m);
    EXPECT_EQ(def.axis_world, described.axis);
    EXPECT_EQ(def.limits, described.limits);
    EXPECT_EQ(def.twist_limits, described.twist);
    EXPECT_EQ(def.motor->target, Real{1});
    EXPECT_EQ(def.motor->max, Real{2});
    EXPECT_EQ(def.stiffness_Npm, Real{3});
    EXPECT_EQ(def.damping_Nspm, Real{4});
    EXPECT_EQ(def.rest_length_m, 5.0_r);
    EXPECT_TRUE(def.collide);
    EXPECT_EQ(def.break_N, Real{6});
}

TEST(SimulationJoints, SayOnceWhenTheyBreak) {
    SceneDescription scene = scene_of({cube("lamp", {0, 50, 0})});
    scene.joints = {hung("hook", "lamp", {0, 51, 0})};
    scene.joints[0].break_N = 9000;  // the cube weighs 9810 N
    Running run(scene);
    run.step(60);
    ASSERT_EQ(run->warnings.size(), 1U);
    EXPECT_EQ(run->warnings[0], "joint hook broke at 0.017 s: 9810 N > 9000 N");
    const json state = state_of(run);
    EXPECT_TRUE(state["joints"][0]["broken"].get<bool>());
    EXPECT_EQ(state["max_joint_error_m"], 0.0);
    EXPECT_EQ(state["warnings"][0], run->warnings[0]);
    EXPECT_LT(run.state("lamp").world_from_body.position.y, Real{46});
}

TEST(SimulationJoints, GoWithTheirEntities) {
    SceneDescription scene = scene_of({cube("high", {0, 5, 0}), cube("low", {0, 3, 0})});
    scene.joints = {hung("hook", "high", {0, 6, 0}), hung("chain", "low", {0, 4, 0})};
    scene.joints[1].b = "high";
    Running run(scene);
    run.step(10);
    run->registry.mark_for_destruction(run->find("low"));
    run.step(10);
    const json state = state_of(run);
    ASSERT_EQ(state["joints"].size(), 1U);
    EXPECT_EQ(state["joints"][0]["name"], "hook");
    EXPECT_EQ(run->joints().size(), 2U);
}

TEST(SimulationJoints, ElasticEnergyIsThatOfTheSprings) {
    SceneDescription scene = scene_of({cube("bob", {0, 0, 0})});
    scene.joints = {{.name = "spring",
                     .kind = JointKind::Spring,
                     .a = "bob",
                     .b = "world",
                     .anchor_b_m = {0, 3, 0},
                     .stiffness_Npm = 200,
                     .rest_length_m = 1.0_r}};
    Running run(scene);
    EXPECT_NEAR(state_of(run)["energy_J"]["elastic"].get<double>(), 0.5 * 200 * 4, 1e-3);
}

TEST(SimulationJoints, WarnOfSolversThatLoseThem) {
    SceneDescription scene = scene_of({cube("a", {0, 5, 0}), cube("b", {2, 5, 0})});
    const auto warnings = [&scene](physics::Solver solver) {
        Running run(scene, test::plain_surfaces(), {.solver = solver});
        return run->warnings.size();
    };
    EXPECT_EQ(warnings(physics::Solver::BulletNncg), 0U);
    scene.joints = {hung("first", "a", {0, 6, 0})};
    EXPECT_EQ(warnings(physics::Solver::BulletSi), 0U);
    EXPECT_EQ(warnings(physics::Solver::BulletNncg), 1U);
    EXPECT_EQ(warnings(physics::Solver::BulletDantzig), 0U);
    scene.joints.push_back(hung("second", "a", {0, 4, 0}));
    EXPECT_EQ(warnings(physics::Solver::BulletDantzig), 1U);
    EXPECT_EQ(warnings(physics::Solver::BulletPgs), 0U);
}

TEST(SimulationJoints, RefuseWhatCannotBe) {
    SceneDescription scene = scene_of(
        {cube("a", {0, 5, 0}), test::box("post", {0, 2, 0}, {1, 1, 1}, physics::BodyKind::Static)});
    EntityDescription image = cube("image", {5, 5, 0});
    image.body.reset();
    scene.entities.push_back(image);
    const auto with = [&](const auto& spoil) {
        scene.joints = {hung("bad", "a", {0, 6, 0})};
        spoil(scene.joints[0]);
        return refusal_of(scene);
    };
    const std::string start = "test.toml:40: joint bad: ";
    EXPECT_EQ(with([](JointDescription& joint) { joint.b = "nobody"; }),
              start + "\"nobody\" has no body to hold on to");
    EXPECT_EQ(with([](JointDescription& joint) { joint.a = "image"; }),
              start + "\"image\" has no body to hold on to");
    EXPECT_EQ(with([](JointDescription& joint) { joint.b = "a"; }),
              start + "a body cannot be joined to itself");
    EXPECT_EQ(with([](JointDescription& joint) { joint.a = "post"; }),
              start + "neither body can move; at least one must be dynamic");
    EXPECT_EQ(with([](JointDescription& joint) {
                  joint.kind = JointKind::Slider;
                  joint.limits = {{2, 1}};
              }),
              start + "limits cross: 2 is above 1");
    EXPECT_EQ(with([](JointDescription&) {}), "");
}

}  // namespace
}  // namespace plumbline::scene
