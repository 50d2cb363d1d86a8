// Bodies that hit each other or the floor: A22, A23, A24, H25.
#include "engine/study/scenarios/families/impacts.h"
#include "tests/scenarios/families/case_run.h"

namespace plumbline::study {
namespace {

void expect_balls_meet(const std::string& row, const BallsMeet& how, const Setting& setting) {
    Stepper stepper(Stepper::Mode::Errors, setting);
    const BallsMeetErrors errors = balls_meet(how, stepper);
    expect_at_most(row + " velocities", errors.velocity, 0.01);
    expect_at_most(row + " momentum", errors.momentum, 2 * kRounding);
}

TEST(Impact, A22TwoBallsPartAsNewtonSays) {
    for (const double ratio : {1.0, 10.0, 100.0, 1000.0, 0.001}) {
        for (const double aside : {0.0, 1.0}) {
            const std::string row =
                fmt::format("A22 ratio {} {} ", ratio, aside > 0 ? "oblique" : "head on");
            expect_balls_meet(row + "balanced", {ratio, aside}, balanced());
            expect_balls_meet(row + "S=16", {ratio, aside}, exactly(16));
            expect_balls_meet(row + "240 Hz", {ratio, aside}, balanced(240));
        }
    }
}

TEST(Impact, A23ASpinningBallLeavesTheFloorTheSameInEveryDirection) {
    for (const double mu : {0.1, 0.5}) {
        for (const Setting& setting : {balanced(), exactly(16)}) {
            Stepper stepper(Stepper::Mode::Errors, setting);
            const SpinningBallErrors errors = spinning_ball_bounces(mu, stepper);
            const std::string row = fmt::format("A23 mu={} {} ", mu, name_of(setting));
            expect_at_most(row + "velocity and spin", errors.worst, 1e-3);
            expect_at_most(row + "azimuth spread", errors.spread, 1e-3);
        }
    }
}

TEST(Impact, A24ACradleSendsOneBallOut) {
    for (const double gap_m : {0.0, 1e-3}) {
        for (const int hz : {60, 240}) {
            for (const Setting& setting : every_s(hz)) {
                Stepper stepper(Stepper::Mode::Errors, setting);
                const CradleErrors errors = cradle_swings({.gap_m = gap_m}, stepper);
                const std::string row =
                    fmt::format("A24 cradle gap {} {} Hz {} ", gap_m, hz, name_of(setting));
                expect_at_most(row + "last ball", std::abs(errors.leaving), 0.01);
                expect_at_most(row + "the others", errors.staying, 0.01);
            }
        }
    }
}

/// Two in, two out.
TEST(Impact, A24ACradleSendsTwoBallsOut) {
    Stepper stepper(Stepper::Mode::Errors, balanced());
    const CradleErrors errors = cradle_swings({.gap_m = 0, .coming = 2}, stepper);
    expect_at_most(
        "A24 cradle two in two out", std::max(std::abs(errors.leaving), errors.staying), 0.01);
}

/// H25: a light box and one of a hundred times its mass meet without bouncing.
TEST(Impact, H25UnequalBoxesGoOnTogether) {
    for (const double mass_kg : {100.0, 0.01}) {
        for (const int hz : {30, 60, 240}) {
            ScenarioWorld world(balanced(hz), kWeightless);
            const BodyId a = world.box({-3, 0, 0}, {1, 1, 1}, {.velocity_mps = {20, 0, 0}});
            const BodyId b = world.box({0, 0, 0}, {1, 1, 1}, {.mass_kg = mass_kg});
            world.run(1);
            const double common = 20 / (1 + mass_kg);
            const std::string row = fmt::format("H25 1 kg on {} kg {} Hz ", mass_kg, hz);
            expect_at_most(row + "velocity", std::abs(world.velocity(b).x / common - 1), 0.01);
            expect_at_most(
                row + "rebound", std::abs(world.velocity(a).x - world.velocity(b).x) / 20, 0.01);
        }
    }
}

}  // namespace
}  // namespace plumbline::study
