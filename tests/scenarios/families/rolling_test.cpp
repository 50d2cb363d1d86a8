// Balls that roll: A30, the peers' slide to roll, A31, A32, H85.
#include "engine/study/scenarios/families/rolling.h"

#include "engine/study/scenarios/families/sliding.h"
#include "engine/study/scenarios/world/peer_scene.h"
#include "tests/scenarios/families/case_run.h"

namespace plumbline::study {
namespace {

TEST(Rolling, A30ASlidingBallComesToRoll) {
    const SlideToRoll law{.speed_mps = 5, .mu = 0.2};
    for (const int hz : {30, 60, 240}) {
        for (const Setting& setting : every_s(hz)) {
            SlidingBall slides(setting, law);
            slides.world.run(3);
            const std::string row = fmt::format("A30 {} Hz {} ", hz, name_of(setting));
            const double x_m = slides.world.at(slides.ball).x;
            const double speed_mps = slides.world.velocity(slides.ball).x;
            expect_at_most(row + "x(3 s)", std::abs(x_m / law.path_m(3) - 1), 5e-3);
            expect_at_most(row + "speed", std::abs(speed_mps / law.rolling_mps() - 1), 5e-3);
        }
    }
}

TEST(Rolling, SlideToRollIsExactAllTheWay) {
    const SlideToRoll law{.speed_mps = 5, .mu = 0.3};
    for (const Setting& setting : every_s()) {
        const auto opened = PeerScene::open("slideroll", setting);
        ASSERT_TRUE(opened.ok()) << opened.error().message;
        ScenarioWorld& world = (*opened)->world;
        double off_m = 0;
        for (int i = 1; i <= 180; ++i) {
            world.physics.step();
            off_m = std::max(off_m, std::abs(world.at(world.movers[0]).x - law.path_m(i / 60.0)));
        }
        expect_at_most("slide to roll, largest x error m " + name_of(setting), off_m, 5e-4);
    }
}

TEST(Rolling, A30NoHeadingIsBetter) {
    double least = 1e9;
    double most = 0;
    for (int i = 0; i < 24; ++i) {
        SlidingBall slides(balanced(), {.speed_mps = 5, .mu = 0.2}, i * kPi_d / 12);
        slides.world.run(3);
        const Vec3d at = slides.world.at(slides.ball);
        const double path = std::hypot(at.x, at.z);
        least = std::min(least, path);
        most = std::max(most, path);
    }
    expect_at_most("A30 24 headings", (most - least) / most, 1e-3);
}

/// A ball released on a slope rolls where friction suffices and slips where it does not.
TEST(Rolling, A31ABallOnASlopeRollsOrSlips) {
    for (const double angle_deg : {10.0, 30.0, 50.0}) {
        for (const double share : {0.5, 0.95, 1.05, 2.0}) {
            for (const Setting& setting : every_s()) {
                Stepper stepper(Stepper::Mode::Errors, setting);
                const auto [path, spin] = down_slope(angle_deg * kPi_d / 180, share, stepper);
                const std::string row = fmt::format(
                    "A31 {} deg, {} of the threshold, {} ", angle_deg, share, name_of(setting));
                expect_at_most(row + "path", std::abs(path), 5e-3);
                expect_at_most(row + "spin", std::abs(spin), 5e-3);
            }
        }
    }
}

/// A ball on a turntable goes round at two sevenths of its rate, at whatever radius.
TEST(Rolling, A32ABallOnATurntableGoesRound) {
    using Turntable = BallOnTurntable;
    for (const Setting& setting :
         {exactly(8), balanced(), exactly(1), exactly(16), balanced(240)}) {
        Turntable rolls(setting);
        double drift = 0;
        const int steps = steps_of(rolls.world, 30);
        for (int i = 0; i < steps; ++i) {
            rolls.world.physics.step();
            rolls.follow();
            drift = std::max(drift, std::abs(rolls.path_m() / Turntable::kPath_m - 1));
        }
        const std::string name = fmt::format("{} Hz {}", setting.step_hz, name_of(setting));
        expect_at_most("A32 period " + name,
                       std::abs(rolls.gone_round_rad / (30 * Turntable::kAround_radps) - 1),
                       0.01);
        expect_at_most("A32 radius in 30 s " + name, drift, 0.023);
    }
}

constexpr double kFrictionLength_m = 0.02;  ///< of rolling and of spinning friction
constexpr double kBallRadius_m = 0.5;

/// On the floor, as `motion` has it; the rest is the same for all of them.
BodyId resisted_ball(ScenarioWorld& world, BodyDef motion) {
    world.floor();
    motion.kind = BodyKind::Dynamic;
    motion.world_from_body = {.position = vec(0, kBallRadius_m, 0)};
    motion.can_sleep = false;
    return world.add(physics::SphereShape{.radius_m = real(kBallRadius_m)}, motion);
}

TEST(Rolling, H85RollingFrictionStopsABall) {
    const double slowing = kFrictionLength_m * kG_mps2 / (1.4 * kBallRadius_m);
    for (const Setting& setting : every_s()) {
        ScenarioWorld world(setting);
        const BodyId ball = resisted_ball(world,
                                          {.velocity_mps = {2, 0, 0},
                                           .angular_velocity_radps = vec(0, 0, -2 / kBallRadius_m),
                                           .rolling_friction = real(kFrictionLength_m)});
        world.run(3);
        expect_at_most("H85 rolling, slowing " + name_of(setting),
                       std::abs((2 - world.velocity(ball).x) / (3 * slowing) - 1),
                       0.05);
        world.run(9);
        expect_at_most("H85 rolling, path " + name_of(setting),
                       std::abs(world.at(ball).x / (4 / (2 * slowing)) - 1),
                       0.05);
        expect_at_most("H85 rolling, speed at rest " + name_of(setting),
                       glm::length(world.velocity(ball)),
                       1e-3);
    }
}

TEST(Rolling, H85SpinningFrictionStopsATop) {
    const double slowing = kFrictionLength_m * kG_mps2 / (0.4 * kBallRadius_m * kBallRadius_m);
    for (const Setting& setting : every_s()) {
        ScenarioWorld world(setting);
        const BodyId ball = resisted_ball(
            world,
            {.angular_velocity_radps = {0, 10, 0}, .spinning_friction = real(kFrictionLength_m)});
        world.run(3);
        expect_at_most("H85 spinning, slowing " + name_of(setting),
                       std::abs((10 - world.spin(ball).y) / (3 * slowing) - 1),
                       0.05);
        world.run(4);
        expect_at_most(
            "H85 spinning, spin at rest " + name_of(setting), glm::length(world.spin(ball)), 1e-3);
    }
}

/// A ball with rolling friction on a slope that its friction holds does not creep.
TEST(Rolling, H85RollingFrictionHoldsABallOnAGentleSlope) {
    // Rolls down where sin(angle) r > c cos(angle).
    for (const double share : {0.9, 1.1}) {
        const double angle = std::atan(share * kFrictionLength_m / 0.5);
        const Slope slope(angle);
        ScenarioWorld world(balanced());
        slope.add_to(world, 0.5);
        const BodyId ball = world.add(physics::SphereShape{},
                                      BodyDef{.kind = BodyKind::Dynamic,
                                              .world_from_body = {.position = vec(slope.out * 0.5)},
                                              .rolling_friction = real(kFrictionLength_m),
                                              .can_sleep = false});
        const Vec3d start = world.at(ball);
        world.run(10);
        const double path = glm::dot(world.at(ball) - start, slope.down);
        if (share < 1) {
            expect_at_most("H85 creep below the limit m", std::abs(path), 1e-3);
        } else {
            const double pull =
                kG_mps2 * (std::sin(angle) - std::cos(angle) * kFrictionLength_m / 0.5) / 1.4;
            expect_at_most("H85 path above the limit", std::abs(path / (pull * 50) - 1), 0.05);
        }
    }
}

}  // namespace
}  // namespace plumbline::study
