// Balls that roll: A30, the peers' slide to roll, A31, A32, H85.
#include "tests/scenarios/families/rig.h"

namespace plumbline::physics {
namespace {

/// A ball sent off without spin at `speed`: where it is and how fast.
struct SlideToRoll {
    double speed;
    double mu;

    double rolls_s() const { return 2 * speed / (7 * mu * kG); }
    double way_m(double t) const {
        const double slides = std::min(t, rolls_s());
        return speed * slides - 0.5 * mu * kG * slides * slides +
               5.0 / 7 * speed * std::max(0.0, t - rolls_s());
    }
};

TEST(Rolling, A30ASlidingBallComesToRoll) {
    const SlideToRoll law{5, 0.2};
    for (const int hz : {30, 60, 240}) {
        for (const Setting& setting : every_s(hz)) {
            Rig rig(setting.def);
            rig.floor(law.mu);
            const BodyId ball =
                rig.ball({0, 0.5, 0}, 0.5, {.friction = law.mu, .velocity_mps = {5, 0, 0}});
            rig.run(3);
            const std::string row = fmt::format("A30 {} Hz {} ", hz, setting.name);
            expect_at_most(row + "x(3 s)", std::abs(rig.at(ball).x / law.way_m(3) - 1), 5e-3);
            expect_at_most(row + "speed", std::abs(rig.velocity(ball).x / (5 * 5.0 / 7) - 1), 5e-3);
        }
    }
}

TEST(Rolling, SlideToRollIsExactAllTheWay) {
    const SlideToRoll law{5, 0.3};
    for (const Setting& setting : every_s()) {
        Rig rig(setting.def);
        rig.floor(law.mu);
        const BodyId ball = rig.ball(
            {0, 0.5, 0}, 0.5, {.mass_kg = 500, .friction = law.mu, .velocity_mps = {5, 0, 0}});
        double off_m = 0;
        for (int i = 1; i <= 180; ++i) {
            rig.world.step();
            off_m = std::max(off_m, std::abs(rig.at(ball).x - law.way_m(i / 60.0)));
        }
        expect_at_most("slide to roll, largest x error m " + setting.name, off_m, 5e-4);
    }
}

TEST(Rolling, A30NoHeadingIsBetter) {
    const SlideToRoll law{5, 0.2};
    double least = 1e9;
    double most = 0;
    for (int i = 0; i < 24; ++i) {
        const double heading = i * kPiD / 12;
        Rig rig(balanced());
        rig.floor(law.mu);
        const BodyId ball =
            rig.ball({0, 0.5, 0},
                     0.5,
                     {.friction = law.mu,
                      .velocity_mps = Vec3d{std::cos(heading), 0, std::sin(heading)} * 5.0});
        rig.run(3);
        const double way = std::hypot(rig.at(ball).x, rig.at(ball).z);
        least = std::min(least, way);
        most = std::max(most, way);
    }
    expect_at_most("A30 24 headings", (most - least) / most, 1e-3);
}

/// A ball released on a slope rolls where friction suffices and slips where it does not.
TEST(Rolling, A31ABallOnASlopeRollsOrSlips) {
    for (const double angle_deg : {10.0, 30.0, 50.0}) {
        const double angle = angle_deg * kPiD / 180;
        const double threshold = 2.0 / 7 * std::tan(angle);
        for (const double share : {0.5, 0.95, 1.05, 2.0}) {
            for (const Setting& setting : every_s()) {
                const double mu = share * threshold;
                const Quatd turn = glm::angleAxis(-angle, Vec3d{0, 0, 1});
                const Vec3d down = turn * Vec3d{1, 0, 0};
                const Vec3d out = turn * Vec3d{0, 1, 0};
                Rig rig(setting.def);
                rig.fixed_box(out * -1.0, {200, 2, 200}, {.friction = mu, .turn = turn});
                const BodyId ball = rig.ball(out * 0.5, 0.5, {.friction = mu});
                const Vec3d start = rig.at(ball);
                rig.run(2);
                const bool rolls = share > 1;
                const double expected = rolls ? 5.0 / 7 * kG * std::sin(angle)
                                              : kG * (std::sin(angle) - mu * std::cos(angle));
                const double turning =
                    rolls ? expected / 0.5 : 5 * mu * kG * std::cos(angle) / (2 * 0.5);
                const std::string row = fmt::format(
                    "A31 {} deg, {} of the threshold, {} ", angle_deg, share, setting.name);
                expect_at_most(row + "way",
                               std::abs(glm::dot(rig.at(ball) - start, down) / (2 * expected) - 1),
                               5e-3);
                expect_at_most(row + "spin", std::abs(-rig.spin(ball).z / (2 * turning) - 1), 5e-3);
            }
        }
    }
}

/// A ball on a turntable goes round at two sevenths of its rate, at whatever radius.
TEST(Rolling, A32ABallOnATurntableGoesRound) {
    constexpr double kRate_radps = 3;
    constexpr double kRadius_m = 0.25;
    constexpr double kPath_m = 2;
    const double around_radps = 2.0 / 7 * kRate_radps;
    struct At {
        std::string name;
        WorldDef def;
    };
    const At ats[] = {{"60 Hz x 8", exactly(8)},
                      {"60 Hz balanced", balanced()},
                      {"60 Hz x 1", exactly(1)},
                      {"60 Hz x 16", exactly(16)},
                      {"240 Hz balanced", balanced(240)}};
    for (const At& at : ats) {
        Rig rig(at.def);
        const BodyId table = rig.carrier({0, -0.5, 0}, {16, 1, 16}, {.friction = 1});
        rig.world.set_velocity(table, {0, 0, 0}, vec(0, kRate_radps, 0));
        const Vec3d start{kPath_m, kRadius_m, 0};
        const Vec3d floor_speed = glm::cross(Vec3d{0, kRate_radps, 0}, Vec3d{kPath_m, 0, 0});
        const Vec3d velocity = floor_speed * (2.0 / 7);
        const BodyId ball = rig.ball(
            start,
            kRadius_m,
            {.friction = 1,
             .velocity_mps = velocity,
             .spin_radps = glm::cross(Vec3d{0, 1, 0}, (velocity - floor_speed) / kRadius_m)});
        double phase = 0;
        double drift = 0;
        const int steps = steps_of(at.def, 30);
        for (int i = 0; i < steps; ++i) {
            rig.world.step();
            const Vec3d now = rig.at(ball);
            phase += std::remainder(std::atan2(-now.z, now.x) - phase, 2 * kPiD);
            drift = std::max(drift, std::abs(std::hypot(now.x, now.z) / kPath_m - 1));
        }
        expect_at_most("A32 period " + at.name, std::abs(phase / (30 * around_radps) - 1), 0.01);
        expect_at_most("A32 radius in 30 s " + at.name, drift, 0.023);
    }
}

TEST(Rolling, H85RollingFrictionStopsABall) {
    constexpr double kLength_m = 0.02;
    constexpr double kRadius_m = 0.5;
    const double slowing = kLength_m * kG / (1.4 * kRadius_m);
    for (const Setting& setting : every_s()) {
        Rig rig(setting.def);
        rig.floor();
        const BodyId ball = rig.add(SphereShape{.radius_m = real(kRadius_m)},
                                    vec(0, kRadius_m, 0),
                                    {.kind = BodyKind::Dynamic,
                                     .velocity_mps = {2, 0, 0},
                                     .angular_velocity_radps = vec(0, 0, -2 / kRadius_m),
                                     .rolling_friction = real(kLength_m),
                                     .can_sleep = false});
        rig.run(3);
        expect_at_most("H85 rolling, slowing " + setting.name,
                       std::abs((2 - rig.velocity(ball).x) / (3 * slowing) - 1),
                       0.05);
        rig.run(9);
        expect_at_most("H85 rolling, way " + setting.name,
                       std::abs(rig.at(ball).x / (4 / (2 * slowing)) - 1),
                       0.05);
        expect_at_most(
            "H85 rolling, speed at rest " + setting.name, glm::length(rig.velocity(ball)), 1e-3);
    }
}

TEST(Rolling, H85SpinningFrictionStopsATop) {
    constexpr double kLength_m = 0.02;
    constexpr double kRadius_m = 0.5;
    const double slowing = kLength_m * kG / (0.4 * kRadius_m * kRadius_m);
    for (const Setting& setting : every_s()) {
        Rig rig(setting.def);
        rig.floor();
        const BodyId ball = rig.add(SphereShape{.radius_m = real(kRadius_m)},
                                    vec(0, kRadius_m, 0),
                                    {.kind = BodyKind::Dynamic,
                                     .angular_velocity_radps = {0, 10, 0},
                                     .spinning_friction = real(kLength_m),
                                     .can_sleep = false});
        rig.run(3);
        expect_at_most("H85 spinning, slowing " + setting.name,
                       std::abs((10 - rig.spin(ball).y) / (3 * slowing) - 1),
                       0.05);
        rig.run(4);
        expect_at_most(
            "H85 spinning, spin at rest " + setting.name, glm::length(rig.spin(ball)), 1e-3);
    }
}

/// A ball with rolling friction on a slope that its friction holds does not creep.
TEST(Rolling, H85RollingFrictionHoldsABallOnAGentleSlope) {
    // Rolls down where sin(angle) r > c cos(angle).
    constexpr double kLength_m = 0.02;
    for (const double share : {0.9, 1.1}) {
        const double angle = std::atan(share * kLength_m / 0.5);
        const Quatd turn = glm::angleAxis(-angle, Vec3d{0, 0, 1});
        const Vec3d down = turn * Vec3d{1, 0, 0};
        Rig rig(balanced());
        rig.fixed_box(turn * Vec3d{0, -1, 0}, {200, 2, 200}, {.turn = turn});
        const BodyId ball = rig.add(
            SphereShape{},
            Vec3(turn * Vec3d{0, 0.5, 0}),
            {.kind = BodyKind::Dynamic, .rolling_friction = real(kLength_m), .can_sleep = false});
        const Vec3d start = rig.at(ball);
        rig.run(10);
        const double way = glm::dot(rig.at(ball) - start, down);
        if (share < 1) {
            expect_at_most("H85 creep below the limit m", std::abs(way), 1e-3);
        } else {
            const double pull = kG * (std::sin(angle) - std::cos(angle) * kLength_m / 0.5) / 1.4;
            expect_at_most("H85 way above the limit", std::abs(way / (pull * 50) - 1), 0.05);
        }
    }
}

}  // namespace
}  // namespace plumbline::physics
