// Scenes of a body or two in engines that are not ours: they fall, rest, hang and slide as they must.
#include "runners/engine_world.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace plumbline::engines {
namespace {

Json part(const char* shape, const Json& sizes) {
    Json json = sizes;
    json["shape"] = shape;
    json["at_m"] = {0, 0, 0};
    json["turn"] = {0, 0, 0, 1};
    return json;
}

Json body(const char* kind, const Json& shape, const Json& at_m) {
    return {{"kind", kind},
            {"parts", {shape}},
            {"at_m", at_m},
            {"turn", {0, 0, 0, 1}},
            {"mass_kg", 1},
            {"inertia_kgm2", {0.1, 0.1, 0.1}},
            {"friction", 0.5},
            {"restitution", 0},
            {"rolling_friction_m", 0},
            {"spinning_friction_m", 0},
            {"linear_damping_per_s", 0},
            {"angular_damping_per_s", 0},
            {"linear_factor", {1, 1, 1}},
            {"continuous", false},
            {"group", 1},
            {"collides_with", 0xFFFFFFFFU}};
}

/// A floor, its top at 0, and one more body at 1 m.
Json scene_of(const Json& shape) {
    const Json floor = body("static", part("box", {{"half_m", {10, 1, 10}}}), {0, -1, 0});
    return {{"gravity_mps2", {0, -10, 0}},
            {"step_hz", 60},
            {"joints", Json::array()},
            {"bodies", {floor, body("dynamic", shape, {0, 1, 0})}}};
}

Json joint_of(const char* kind, const Json& axis) {
    return {{"kind", kind},
            {"a", 1},
            {"b", -1},
            {"anchor_a_m", {-1, 5, 0}},
            {"anchor_b_m", {-1, 5, 0}},
            {"axis", axis},
            {"rest_length_m", 0},
            {"collide", false},
            {"breaks", false}};
}

class OtherWorld : public testing::TestWithParam<Engine> {
protected:
    std::array<double, kNumbers> after(const Json& scene, int steps) {
        const std::unique_ptr<EngineWorld> world = GetParam().make(scene);
        for (int i = 0; i < steps; ++i) world->step();
        std::array<double, kNumbers> state{};
        world->get_state(1, state);
        return state;
    }
};

TEST_P(OtherWorld, RoundAndFlatShapesComeToRestOnTheFloor) {
    const Json box = part("box", {{"half_m", {0.5, 0.5, 0.5}}});
    const Json ball = part("sphere", {{"radius_m", 0.5}});
    const Json barrel = part("cylinder", {{"radius_m", 0.5}, {"half_height_m", 0.5}});
    for (const Json& shape : {box, ball, barrel})
        EXPECT_NEAR(after(scene_of(shape), 180)[1], 0.5, 0.03) << shape;
    const Json capsule = part("capsule", {{"radius_m", 0.25}, {"half_height_m", 0.25}});
    EXPECT_NEAR(after(scene_of(capsule), 60)[1], 0.5, 0.03) << "stands along Y";
}

TEST_P(OtherWorld, AStateThatIsSetIsWhereItGoesOnFrom) {
    const std::unique_ptr<EngineWorld> world =
        GetParam().make(scene_of(part("sphere", {{"radius_m", 0.5}})));
    const std::array<double, kNumbers> set{1, 50, 3, 0, 0, 0, 1, 2, 0, 0, 0, 3, 0};
    world->set_state(1, set);
    for (int i = 0; i < 60; ++i) world->step();
    std::array<double, kNumbers> state{};
    world->get_state(1, state);
    EXPECT_NEAR(state[0], 3, 1e-3);
    EXPECT_NEAR(state[1], 45, 0.1);  // semi-implicit Euler falls 1/120 s further
    EXPECT_NEAR(state[8], -10, 1e-3);
    EXPECT_NEAR(state[11], 3, 1e-3);
    // Half a turn about Y in pi / 3 s: 3 rad in a second.
    EXPECT_NEAR(2 * std::atan2(state[4], state[6]), 3, 1e-2);
    world->set_gravity({0, 0, 0});
    world->step();
    const double before = state[8];
    world->get_state(1, state);
    EXPECT_NEAR(state[8], before, 1e-3);
}

TEST_P(OtherWorld, JointsHoldAlongAllButTheirAxes) {
    Json scene = scene_of(part("sphere", {{"radius_m", 0.5}}));
    scene["bodies"][1]["at_m"] = {0, 5, 0};
    scene["joints"] = {joint_of("fixed", {0, 1, 0})};
    EXPECT_NEAR(after(scene, 60)[1], 5, 0.02);
    scene["joints"] = {joint_of("slider", {1, 0, 0})};
    EXPECT_NEAR(after(scene, 60)[1], 5, 0.02);
    // A hinge along Z lets it swing in the XY plane at 1 m from (-1, 5).
    for (const char* kind : {"hinge", "ball"}) {
        scene["joints"] = {joint_of(kind, {0, 0, 1})};
        const auto state = after(scene, 20);
        EXPECT_LT(state[1], 4.8) << kind;
        EXPECT_NEAR(std::hypot(state[0] + 1, state[1] - 5), 1, 0.02) << kind;
    }
    scene["joints"][0] = joint_of("hinge", {0, 0, 1});
    scene["joints"][0]["limits"] = {-0.2, 0.2};
    const auto held = after(scene, 120);
    EXPECT_NEAR(std::atan2(held[1] - 5, held[0] + 1), -0.2, 0.03);
}

TEST_P(OtherWorld, WhatItLacksIsSaid) {
    Json rolling = scene_of(part("sphere", {{"radius_m", 0.5}}));
    rolling["bodies"][1]["rolling_friction_m"] = 0.01;
    EXPECT_THROW(GetParam().make(rolling), Lacks);
    Json elastic = scene_of(part("sphere", {{"radius_m", 0.5}}));
    elastic["joints"] = {joint_of("elastic", {0, 0, 1})};
    EXPECT_THROW(GetParam().make(elastic), Lacks);
    EXPECT_THROW(GetParam().make(scene_of(part("torus", {{"radius_m", 1}, {"half_height_m", 1}}))),
                 Lacks);
}

std::vector<Engine> engines() {
    std::vector<Engine> all{bullet_engine()};
#ifdef PLUMBLINE_HAS_ODE
    all.push_back(ode_engine());
#endif
    return all;
}
INSTANTIATE_TEST_SUITE_P(Engines, OtherWorld, testing::ValuesIn(engines()), [](const auto& each) {
    return std::string(each.param.name);
});

}  // namespace
}  // namespace plumbline::engines
