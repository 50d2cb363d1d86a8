// PHYSICS.md C06, C11: going along, and weighing on what one stands on.
#include "tests/engine/physics/character/character_stage.h"

namespace plumbline::physics {
namespace {

class CharacterRiding : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Rates, CharacterRiding, ::testing::Values(30, 60, 120, 240));

TEST_P(CharacterRiding, TurnsWithARotatingPlatform) {
    Stage stage(GetParam());
    Platform platform(stage, {6, 0.5_r, 6}, {10, 3, 0});
    stage.enter({12, 3.25_r, 0});
    stage.rest(0.2_r);
    const double rate_radps = 1;
    const int count = stage.steps_in(10);
    Real yaw = 0;
    Vec3 anchor{};
    for (int i = 1; i <= count; ++i) {
        const double angle = rate_radps * i * static_cast<double>(stage.dt);
        Pose next = platform.pose;
        next.orientation = glm::angleAxis(static_cast<Real>(angle), Vec3{0, 1, 0});
        const CharacterState& state = platform.step(next);
        yaw += state.ridden_yaw_rad;
        ASSERT_EQ(state.footing, Footing::Ground);
        const Vec3 local = transform_point(invert(next), state.feet_position_m);
        // It starts at once: one step of surprise, then exact.
        if (i == 2) anchor = local;
        if (i > 2) {
            ASSERT_LT(glm::distance(local, anchor), 1e-4) << "after " << angle << " rad";
        }
    }
    EXPECT_NEAR(yaw, rate_radps * 10, 2e-3);
}

TEST_P(CharacterRiding, RidesALiftThatRises) {
    Stage stage(GetParam());
    Platform lift(stage, {4, 0.5_r, 4}, {0, -0.25_r, 0});
    stage.enter({0.5_r, 0, 0.5_r});
    stage.rest(0.2_r);
    double t = 0;
    double speed = 0;
    double height = -0.25;
    while (t < 4) {
        // Up to 3 m/s within a second.
        const double dt = static_cast<double>(stage.dt);
        speed = std::min(3.0, speed + 3.0 * dt);
        height += speed * dt;
        t += dt;
        Pose next = lift.pose;
        next.position.y = static_cast<Real>(height);
        const CharacterState& state = lift.step(next);
        ASSERT_EQ(state.footing, Footing::Ground) << "at " << t;
        ASSERT_NEAR(state.feet_position_m.y, height + 0.25, 0.01) << "at " << t;
        ASSERT_NEAR(state.feet_position_m.x, 0.5, 1e-4);
    }
    EXPECT_GT(stage.feet().y, 10);
    EXPECT_NEAR(stage.person->state().velocity_mps.y, 3, 0.01);
}

TEST_P(CharacterRiding, WalksOnAMovingPlatformAsOnTheGroundAndTakesItsSpeedAlong) {
    Stage stage(GetParam());
    Platform tram(stage, {40, 0.5_r, 4}, {0, -0.25_r, 0});
    stage.enter({0, 0, 0});
    stage.rest(0.2_r);
    const auto roll = [&](const CharacterInput& input) {
        Pose next = tram.pose;
        next.position.x += 2 * stage.dt;
        return tram.step(next, input);
    };
    for (int i = 0; i < stage.steps_in(1); ++i) roll({});
    const Real start = stage.feet().x - tram.pose.position.x;
    for (int i = 0; i < stage.steps_in(2); ++i) roll({.direction_world = kRight});
    EXPECT_NEAR(stage.feet().x - tram.pose.position.x - start, 1.8 * 2 - 0.04, 0.01);
    for (int i = 0; i < stage.steps_in(0.5_r); ++i) roll({});
    const CharacterState left = roll({.jump = true});
    EXPECT_EQ(left.footing, Footing::Air);
    EXPECT_NEAR(left.velocity_mps.x, 2, 1e-2);
}

/// Sums up how far the person is turned by what is under the feet, which turns about +Y at 1 rad/s.
Real turned_in_a_second(Stage& stage, const ShapeDef& shape, Real top_m, Real mass_kg) {
    const BodyId body =
        stage.add(shape,
                  {0, top_m / 2, 0},
                  {.kind = BodyKind::Dynamic, .mass_kg = mass_kg, .can_sleep = false});
    stage.enter({0.2_r, top_m, 0});
    stage.rest(0.2_r);
    Real yaw = 0;
    for (int i = 0; i < stage.steps_in(1); ++i) {
        stage.world.set_velocity(body, {0, 0, 0}, {0, 1, 0});
        const CharacterState& state = stage.step();
        EXPECT_EQ(state.ground_body, body) << "in step " << i;
        yaw += state.ridden_yaw_rad;
    }
    return yaw;
}

TEST_P(CharacterRiding, AHeavyFlatThingTurnsThePersonAndALightOneDoesNot) {
    for (const ShapeDef& shape :
         {ShapeDef{BoxShape{{3, 0.3_r, 3}}}, ShapeDef{CylinderShape{1.5_r, 0.3_r}}}) {
        Stage heavy(GetParam());
        heavy.ground(0);
        EXPECT_NEAR(turned_in_a_second(heavy, shape, 0.3_r, 400), 1, 0.05);
        Stage light(GetParam());
        light.ground(0);
        EXPECT_EQ(turned_in_a_second(light, shape, 0.3_r, 30), 0);
    }
}

// FAULTS N27: a ball under the feet turned the view.
TEST_P(CharacterRiding, ABallUnderTheFeetTurnsNobodyHoweverHeavy) {
    for (const Real mass_kg : {5.0_r, 400.0_r}) {
        Stage stage(GetParam());
        stage.ground();
        const BodyId ball =
            stage.add(SphereShape{0.5_r},
                      {0, 0.5_r, 0},
                      {.kind = BodyKind::Dynamic, .mass_kg = mass_kg, .can_sleep = false});
        stage.enter({0.02_r, 1, 0.03_r});
        int ridden = 0;
        for (int i = 0; i < stage.steps_in(1); ++i) {
            stage.world.set_velocity(ball, stage.world.state(ball).velocity_mps, {0.3_r, 2, 0.2_r});
            const CharacterState& state = stage.step({.direction_world = kRight * 0.1_r});
            ridden += state.ground_body == ball ? 1 : 0;
            ASSERT_EQ(state.ridden_yaw_rad, 0);
        }
        EXPECT_GT(ridden, 2) << "it did stand on it";
    }
}

// A ball thrown at a wall came back under the feet, and its spin flung the person about.
TEST_P(CharacterRiding, ABallThatFliesAtTheFeetCarriesNobodyAway) {
    for (const Real speed_mps : {3.0_r, 6.0_r, 9.0_r, 13.0_r}) {
        for (const Real high_m : {0.12_r, 0.2_r, 0.3_r, 0.45_r}) {
            for (const Real spin_radps : {-60.0_r, 0.0_r, 60.0_r}) {
                Stage stage(GetParam());
                stage.ground();
                stage.wall({4, 3, 0.2_r}, {0, 1.5_r, 0.6_r});  // behind the person
                stage.enter({0, 0, 0});
                stage.rest(0.2_r);
                const BodyId ball = stage.add(SphereShape{0.12_r},
                                              {0.05_r, high_m, -1.5_r},
                                              {.kind = BodyKind::Dynamic,
                                               .mass_kg = 0.6_r,
                                               .friction = 0.7_r,
                                               .restitution = 0.75_r});
                stage.world.set_velocity(ball, {0, 0, speed_mps}, {spin_radps, 0, 0});
                Real farthest_m = 0;
                for (int i = 0; i < stage.steps_in(2); ++i) {
                    stage.step();
                    farthest_m = std::max(farthest_m, glm::length(stage.feet()));
                }
                EXPECT_LT(farthest_m, 0.15)
                    << speed_mps << " m/s at " << high_m << " m, spin " << spin_radps;
            }
        }
    }
}

TEST_P(CharacterRiding, AHeavySlabThatTumblesTurnsNobody) {
    Stage stage(GetParam());
    stage.ground();
    const BodyId slab = stage.add(BoxShape{{3, 0.3_r, 3}},
                                  {0, 0.15_r, 0},
                                  {.kind = BodyKind::Dynamic, .mass_kg = 400, .can_sleep = false});
    stage.enter({0.2_r, 0.3_r, 0});
    stage.rest(0.2_r);
    for (int i = 0; i < stage.steps_in(0.5_r); ++i) {
        stage.world.set_velocity(slab, {0, 0, 0}, {0.6_r, 1, 0});
        EXPECT_EQ(stage.step().ridden_yaw_rad, 0);
    }
}

TEST_P(CharacterRiding, IsWeighedByWhatItStandsOn) {
    // A plank on a pivot: 80 kg on one end against 60 kg on the other.
    for (const Real counter_kg : {60.0_r, 120.0_r}) {
        Stage stage(GetParam());
        stage.ground();
        stage.wall({0.1_r, 0.3_r, 1}, {0, 0.15_r, 0});
        stage.add(BoxShape{{4, 0.06_r, 0.8_r}},
                  {0, 0.33_r, 0},
                  {.kind = BodyKind::Dynamic, .mass_kg = 20, .can_sleep = false});
        stage.add(BoxShape{{0.4_r, 0.4_r, 0.4_r}},
                  {1.6_r, 0.56_r, 0},
                  {.kind = BodyKind::Dynamic, .mass_kg = counter_kg, .can_sleep = false});
        stage.enter({-1.6_r, 0.4_r, 0});
        stage.rest(2);
        const bool down = stage.feet().y < 0.3_r;
        EXPECT_EQ(down, counter_kg < 80) << "counterweight " << counter_kg;
    }
}

}  // namespace
}  // namespace plumbline::physics
