// What hangs, swings and tips in the garden does so as the formulas say, and comes to rest.

#include "engine/physics/character.h"
#include "tests/scenarios/scene_run.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

namespace plumbline {
namespace {

using test::SceneRun;

constexpr Real kG_mps2 = 9.81_r;

class GardenThings : public testing::Test {
protected:
    SceneRun run_{"garden.toml"};

    void SetUp() override {
        ASSERT_TRUE(run_.simulation);
        // What only settles is none of these tests' business.
        run_.step(60 * 4);
    }
    physics::PhysicsWorld& world() { return run_.simulation->physics; }
    physics::BodyId body(const std::string& name) const {
        return run_.simulation->registry.get<scene::BodyRef>(run_.simulation->find(name)).body;
    }
    /// How far it is turned about an axis of the world from `start`.
    Real turned_deg(const std::string& name, const Quat& start, const Vec3& axis) const {
        const Quat turn = run_.state(name).world_from_body.orientation * glm::conjugate(start);
        const Real along = glm::dot(Vec3{turn.x, turn.y, turn.z}, axis);
        return degrees_from_radians(std::remainder(2 * std::atan2(along, turn.w), 2 * kPi));
    }
    Vec3 axis_of(const std::string& name, const Vec3& axis_body) const {
        return run_.state(name).world_from_body.orientation * axis_body;
    }
};

// 0.96 m by 0.905 m and 14 kg: m w^2 / 3 about the hinge (and its thickness), against the 1.5 N m that
// hold it. An impulse J at 0.8 m from the hinge: w = J r / I, and it turns by I w^2 / (2 * 1.5) rad.
TEST_F(GardenThings, TheGateTurnsAsFarAsItsFrictionLetsItAndRestsAtItsLimit) {
    const Real width_m = 0.905_r;
    const Real thick_m = 0.045_r;
    const Real inertia_kgm2 = 14 * (width_m * width_m / 3 + thick_m * thick_m / 12);
    const Quat start = run_.state("gate_left").world_from_body.orientation;
    const Vec3 hinge = run_.state("gate_left").world_from_body.position;
    const Vec3 struck = hinge + Vec3{0.8_r, 0.54_r, 0};

    const Real wanted_rad = radians_from_degrees(60.0_r);
    const Real speed_radps = std::sqrt(2 * 1.5_r * wanted_rad / inertia_kgm2);
    world().apply_impulse(body("gate_left"), {0, 0, -inertia_kgm2 * speed_radps / 0.8_r}, struck);
    run_.step(60 * 4);
    EXPECT_NEAR(turned_deg("gate_left", start, {0, 1, 0}), 60, 1.5);
    EXPECT_FALSE(run_.state("gate_left").awake);

    const Vec3 now = hinge + axis_of("gate_left", {0.8_r, 0.54_r, 0});
    world().apply_impulse(body("gate_left"), axis_of("gate_left", {0, 0, -12}), now);
    Real widest_deg = 0;
    for (int i = 0; i < 60 * 5; ++i) {
        run_.step(1);
        widest_deg = std::max(widest_deg, turned_deg("gate_left", start, {0, 1, 0}));
    }
    EXPECT_GT(widest_deg, 99);
    EXPECT_LT(widest_deg, 101) << "its limit is 100 degrees";
    EXPECT_NEAR(turned_deg("gate_left", start, {0, 1, 0}), 100, 1);
    EXPECT_FALSE(run_.state("gate_left").awake);
    EXPECT_NEAR(glm::distance(run_.state("gate_left").world_from_body.position, hinge), 0, 1e-4);
}

TEST_F(GardenThings, TheGateOpensBothWaysToWhoWalksThrough) {
    for (const Real way : {Real{1}, Real{-1}}) {
        physics::Character person(world(), {.feet_position_m = {0.3_r, 0.03_r, 17 - 1.5_r * way}});
        for (int i = 0; i < 60 * 4; ++i) {
            person.update({.direction_world = {0, 0, way}});
            run_.step(1);
        }
        EXPECT_GT((person.state().feet_position_m.z - 17) * way, 1.5);
    }
}

/// What a board of the swing adds: its volume, and that times its place and its turning inertia
/// about the axis at y = 0, along x.
struct Board {
    Real y_m;
    Vec3 size_m;
};

// A rigid pendulum: 2 pi sqrt(I / (m g l)), with I and l of the seat and its two ropes as boards of one
// density; at 4 degrees it is longer by a 16th of 0.07^2.
TEST_F(GardenThings, TheSwingHasThePeriodOfItsBoards) {
    const Real seat_y_m = 0.46_r - 0.045_r / 2 - 2.65_r;
    const Real rope_m = 2.65_r - 0.46_r;
    const std::array boards{Board{seat_y_m, {0.92_r, 0.045_r, 0.3_r}},
                            Board{-rope_m / 2, {0.028_r, rope_m, 0.028_r}},
                            Board{-rope_m / 2, {0.028_r, rope_m, 0.028_r}}};
    Real moment = 0;
    Real inertia = 0;
    for (const Board& board : boards) {
        const Vec3 s = board.size_m;
        const Real part = s.x * s.y * s.z;
        moment += part * -board.y_m;
        inertia += part * (board.y_m * board.y_m + (s.y * s.y + s.z * s.z) / 12);
    }
    const Real amplitude_rad = radians_from_degrees(4.0_r);
    const Real period_s = 2 * kPi * std::sqrt(inertia / (kG_mps2 * moment)) *
                          (1 + amplitude_rad * amplitude_rad / 16);

    const physics::BodyState rest = run_.state("swing");
    const Vec3 axis = axis_of("swing", {1, 0, 0});
    const Quat start = rest.world_from_body.orientation;
    world().set_pose(body("swing"),
                     {.position = rest.world_from_body.position,
                      .orientation = glm::angleAxis(amplitude_rad, axis) * start});
    std::vector<Real> downward_s;
    Real before_deg = 4;
    for (int i = 1; i <= 60 * 12; ++i) {
        run_.step(1);
        const Real now_deg = turned_deg("swing", start, axis);
        if (before_deg > 0 && now_deg <= 0)
            downward_s.push_back((static_cast<Real>(i) - now_deg / (now_deg - before_deg)) / 60);
        before_deg = now_deg;
    }
    ASSERT_GE(downward_s.size(), 4U);
    EXPECT_NEAR((downward_s[3] - downward_s[0]) / 3, period_s, 0.004_r * period_s);
    run_.step(60 * 60);
    EXPECT_FALSE(run_.state("swing").awake);
    EXPECT_NEAR(turned_deg("swing", start, axis), 0, 0.3);
}

// The weight of 80 kg at 0.6 m balances that of 40 kg at 1.2 m. The hinge's 24 N m hold 5 cm more of the
// longer arm (20 N m), and not 7 cm (27 N m): then that side goes down, to the limit.
TEST_F(GardenThings, TheSeesawBalancesWhereMassTimesArmIsEqual) {
    const Vec3 axis = run_.state("seesaw").world_from_body.position;
    const Quat level = glm::angleAxis(radians_from_degrees(30.0_r), Vec3{0, 1, 0});
    const auto tilt_deg = [&] {
        return degrees_from_radians(std::asin(axis_of("seesaw", {1, 0, 0}).y));
    };
    EXPECT_NEAR(tilt_deg(), 15, 0.1) << "as it stands";
    const auto loaded_deg = [&](Real longer_arm_m) {
        world().set_pose(body("seesaw"), {.position = axis, .orientation = level});
        world().set_velocity(body("seesaw"), {0, 0, 0}, {0, 0, 0});
        for (int i = 0; i < 60 * 4; ++i) {
            const Vec3 along = axis_of("seesaw", {1, 0, 0});
            world().apply_force(body("seesaw"), {0, -80 * kG_mps2, 0}, axis - along * 0.6_r);
            world().apply_force(body("seesaw"), {0, -40 * kG_mps2, 0}, axis + along * longer_arm_m);
            run_.step(1);
        }
        return tilt_deg();
    };
    EXPECT_NEAR(loaded_deg(1.2_r), 0, 0.1);
    EXPECT_NEAR(loaded_deg(1.25_r), 0, 0.1);
    EXPECT_NEAR(loaded_deg(1.15_r), 0, 0.1);
    EXPECT_NEAR(loaded_deg(1.27_r), -15, 0.2);
    EXPECT_NEAR(loaded_deg(1.13_r), 15, 0.2);
}

TEST_F(GardenThings, OneStandsOnTheSwingAndOnBothEndsOfTheSeesaw) {
    const auto stand = [&](const std::string& thing, const Vec3& place_body) {
        const Pose at = run_.state(thing).world_from_body;
        physics::Character person(
            world(),
            {.feet_position_m = at.position + at.orientation * place_body + Vec3{0, 0.1_r, 0}});
        for (int i = 0; i < 60 * 6; ++i) {
            person.update({});
            run_.step(1);
        }
        EXPECT_EQ(person.state().footing, physics::Footing::Ground) << thing;
        EXPECT_EQ(person.state().ground_body, body(thing)) << thing;
    };
    stand("swing", {0, 0.46_r - 2.65_r, 0});
    stand("seesaw", {-1.35_r, 0.03_r, 0});
    stand("seesaw", {1.35_r, 0.03_r, 0});
    EXPECT_NEAR(axis_of("seesaw", {1, 0, 0}).y, std::sin(radians_from_degrees(-15.0_r)), 0.01)
        << "80 kg at its end take it down";
}

TEST_F(GardenThings, TheWindmillTurnsAtTheSpeedOfItsMotor) {
    const Vec3 axis = axis_of("windmill_rotor", {0, 0, 1});
    const Quat start = run_.state("windmill_rotor").world_from_body.orientation;
    run_.step(90);
    EXPECT_NEAR(turned_deg("windmill_rotor", start, axis), degrees_from_radians(1.4_r * 1.5_r), 1);
    EXPECT_NEAR(glm::length(run_.state("windmill_rotor").angular_velocity_radps), 1.4, 0.01);
}

TEST_F(GardenThings, TheLanternSwingsOnItsChainAndComesToRest) {
    const Vec3 hook = run_.state("lantern_chain_1").world_from_body.position;
    const Vec3 rest = run_.state("lantern_hanging").world_from_body.position;
    world().apply_impulse(body("lantern_hanging"), {2, 0, 1});
    Real farthest_m = 0;
    for (int i = 0; i < 60 * 30; ++i) {
        run_.step(1);
        const Pose at = run_.state("lantern_hanging").world_from_body;
        const Vec3 ring = at.position + at.orientation * Vec3{0, 0.37_r, 0};
        ASSERT_LT(glm::distance(ring, hook), 5 * 0.075_r + 0.002_r) << "five links";
        farthest_m = std::max(farthest_m, glm::distance(at.position, rest));
    }
    EXPECT_GT(farthest_m, 0.2);
    EXPECT_LT(glm::distance(run_.state("lantern_hanging").world_from_body.position, rest), 0.01);
    EXPECT_FALSE(run_.state("lantern_hanging").awake);
}

// 1 N s on 0.3 kg is 3.3 m/s: the clapper meets tubes, and tubes ring, until all hang still.
TEST_F(GardenThings, TheChimesRingWhenTheirTubesMeetAndComeToRest) {
    SceneRun heard("garden.toml", {}, {.frame = false, .sound = true});
    ASSERT_TRUE(heard.simulation);
    heard.step(60 * 4);
    const auto near_chimes = [&] {
        int count = 0;
        const Vec3f place(heard.state("chime_clapper").world_from_body.position);
        for (const audio::SoundCue& cue : heard.effects->sound(*heard.simulation, {}).cues)
            count += glm::distance(cue.position_world, place) < 0.8F ? 1 : 0;
        return count;
    };
    EXPECT_EQ(near_chimes(), 0) << "they hang apart";
    const ecs::Entity clapper = heard.simulation->find("chime_clapper");
    heard.simulation->physics.apply_impulse(
        heard.simulation->registry.get<scene::BodyRef>(clapper).body, {0.7_r, 0, 0.7_r});
    heard.step(60 * 3);
    EXPECT_GE(near_chimes(), 3);
    heard.step(60 * 40);
    near_chimes();
    heard.step(60 * 2);
    EXPECT_EQ(near_chimes(), 0);
    EXPECT_FALSE(heard.state("chime_1").awake);
    EXPECT_FALSE(heard.state("chime_clapper").awake);
}

// Each falls on the next: half the height above the edge that it turns about, and 5 cm between them.
TEST_F(GardenThings, AllLittleDominoesFallWhenTheFirstIsPushed) {
    const Vec3 along = axis_of("small_domino_1", {1, 0, 0});
    const Vec3 top = run_.state("small_domino_1").world_from_body.position + Vec3{0, 0.05_r, 0};
    world().apply_impulse(body("small_domino_1"), along * 0.05_r, top);
    run_.step(60 * 6);
    for (int i = 1; i <= 13; ++i) {
        const std::string name = fmt::format("small_domino_{}", i);
        EXPECT_LT(axis_of(name, {0, 1, 0}).y, 0.75) << name << " still stands";
        EXPECT_FALSE(run_.state(name).awake) << name;
    }
}

TEST_F(GardenThings, TheBarrowRunsOnItsWheelWhenItIsLifted) {
    const Pose start = run_.state("wheelbarrow").world_from_body;
    const Vec3 forward = start.orientation * Vec3{0, 0, 1};
    const Vec3 grip_body{0, 0.44_r, -0.75_r};
    // Held up by half its weight at the handles, and pushed: the stays are off the ground.
    for (int i = 0; i < 90; ++i) {
        const Pose at = run_.state("wheelbarrow").world_from_body;
        const Vec3 grip = at.position + at.orientation * grip_body;
        const Real lift_N = 600 * std::clamp(0.75_r - grip.y, 0.0_r, 0.2_r);
        world().apply_force(body("wheelbarrow"), Vec3{0, lift_N, 0} + forward * 15.0_r, grip);
        run_.step(1);
    }
    const Vec3 way = run_.state("wheelbarrow").world_from_body.position - start.position;
    EXPECT_GT(glm::dot(way, forward), 0.3);
    const Vec3 axle = axis_of("barrow_wheel", {0, 1, 0});
    const Real spin_radps =
        std::abs(glm::dot(run_.state("barrow_wheel").angular_velocity_radps, axle));
    const Real speed_mps = glm::length(run_.state("barrow_wheel").velocity_mps);
    EXPECT_NEAR(spin_radps * 0.19_r, speed_mps, 0.2_r * speed_mps) << "it rolls";
}

}  // namespace
}  // namespace plumbline
