// Coulomb friction of boxes: A28, A29, A34, H76, H84.
#include "engine/study/scenarios/families/sliding.h"

#include "tests/scenarios/families/case_run.h"

namespace plumbline::study {
namespace {

TEST(Sliding, A28ABoxStopsWhereFrictionSays) {
    for (const double height_m : {1.0, 0.25}) {
        for (const int hz : {30, 60, 240}) {
            for (const Setting& setting : every_s(hz)) {
                Stepper stepper(Stepper::Mode::Errors, setting);
                const Vec3d at = sliding_stop_m({.height_m = height_m}, stepper);
                const std::string row =
                    fmt::format("A28 stop, box 1 x {} {} Hz {} ", height_m, hz, name_of(setting));
                expect_at_most(row + "distance", std::abs(at.x / sliding_way_m() - 1), 5e-3);
                expect_at_most(row + "aside", std::abs(at.z) / sliding_way_m(), 1e-3);
            }
        }
    }
}

TEST(Sliding, A28StopsAlikeInEveryDirection) {
    for (const double turns : {0.0, 1.0}) {
        double least = 1e9;
        double most = 0;
        for (int i = 0; i < 24; ++i) {
            const double heading = i * kPi_d / 12;
            Stepper stepper(Stepper::Mode::Errors, balanced());
            const Vec3d at =
                sliding_stop_m({.heading_rad = heading, .turned_rad = turns * heading}, stepper);
            const double path = std::hypot(at.x, at.z);
            least = std::min(least, path);
            most = std::max(most, path);
        }
        expect_at_most(
            turns > 0 ? "A28 24 headings, box turned along" : "A28 24 headings, same box",
            (most - least) / most,
            1e-3);
    }
}

TEST(Sliding, A29ABoxBelowTheLimitStays) {
    for (const Setting& setting : every_s()) {
        BoxOnSlope held(setting, std::atan(0.99 * 0.5), 0.5);
        held.world.run(60);
        expect_at_most("A29 creep in 60 s m " + name_of(setting), held.moved_m(), 1e-4);
    }
}

TEST(Sliding, H84ABoxOnTwentyDegreesStays) {
    for (const int hz : {30, 60, 240}) {
        BoxOnSlope held(balanced(hz), 20 * kPi_d / 180, 0.5);
        held.world.run(60);
        expect_at_most(fmt::format("H84 creep in 60 s m {} Hz", hz), held.moved_m(), 1e-4);
    }
}

TEST(Sliding, A29ABoxAboveTheLimitGainsSpeedAsNewtonSays) {
    struct Case {
        double slope;
        double mu;
    };
    for (const Case& one : {Case{0.505, 0.5}, {0.55, 0.5}, {0.5, 0.3}, {0.7, 0.1}}) {
        for (const Setting& setting : every_s()) {
            BoxOnSlope slides(setting, std::atan(one.slope), one.mu);
            slides.world.run(1);
            const double before_mps = slides.down_mps();
            const double before_m = slides.down_m();
            slides.world.run(3);
            const double expected = slides.gain_mps2();
            const double gained = slides.down_mps() - before_mps;
            const double path = slides.down_m() - before_m;
            const std::string row =
                fmt::format("A29 slope {} mu {} {} ", one.slope, one.mu, name_of(setting));
            expect_at_most(row + "acceleration", std::abs(gained / (3 * expected) - 1), 5e-3);
            expect_at_most(
                row + "path", std::abs(path / (before_mps * 3 + 4.5 * expected) - 1), 5e-3);
            // What the first steps let it slip before friction holds.
            expect_at_most(row + "head start", std::abs(before_mps - expected) / expected, 5e-3);
        }
    }
}

/// A box spinning on its face stops by the law of four corners or of even pressure, and by the same
/// one however it stands and however fast the world steps.
TEST(Sliding, A34ASpinningBoxStopsByOneLaw) {
    const auto stop_s = [](const Setting& setting, double turned_rad) {
        SpinningBox spins(setting, turned_rad);
        const int steps = steps_of(spins.world, 3);
        double before = 10;
        for (int i = 1; i <= steps; ++i) {
            spins.world.physics.step();
            const double now = spins.spin_radps();
            if (now < 1) return (i - (1 - now) / (before - now)) * spins.world.step_s() / 0.9;
            before = now;
        }
        return 3.0;
    };
    double least = 1e9;
    double most = 0;
    for (int i = 0; i < 12; ++i) {
        const double found = stop_s(balanced(), i * kPi_d / 24);
        least = std::min(least, found);
        most = std::max(most, found);
    }
    note("A34 stop time over that of four corners", least / (10 / four_corners_radps2()));
    expect_at_most("A34 spread over 12 yaws", (most - least) / most, 5e-3);
    for (const int hz : {30, 120, 240}) {
        expect_at_most(fmt::format("A34 {} Hz against 60 Hz", hz),
                       std::abs(stop_s(balanced(hz), 0) / stop_s(balanced(), 0) - 1),
                       0.01);
    }
}

/// H76: a box on a disc that turns ever faster slips when its path asks for more than friction.
TEST(Sliding, H76ABoxOnATurningPlateSlipsWhenItMust) {
    constexpr double kRadius_m = 2;
    constexpr double kSlipped_m = 1e-3;
    constexpr double kSeconds = 20;
    const double slip_radps = std::sqrt(0.5 * kG_mps2 / kRadius_m);
    const double gain = 1.2 * slip_radps / kSeconds;
    // Beyond the limit the path out grows as w r gain t^3 / 3.
    const double late_radps = gain * std::cbrt(3 * kSlipped_m / (slip_radps * kRadius_m * gain));
    for (const Setting& setting : every_s()) {
        ScenarioWorld world(setting);
        const BodyId plate = world.kinematic_box({0, -0.5, 0}, {10, 1, 10});
        const BodyId box = world.box({kRadius_m, 0.125, 0}, {0.25, 0.25, 0.25});
        double slipped_at = 0;
        const int steps = steps_of(world, kSeconds);
        for (int i = 1; i <= steps && slipped_at == 0; ++i) {
            const double rate = gain * kSeconds * i / steps;
            world.physics.set_velocity(plate, {0, 0, 0}, vec(0, rate, 0));
            world.physics.step();
            if (std::hypot(world.at(box).x, world.at(box).z) > kRadius_m + kSlipped_m)
                slipped_at = rate;
        }
        note("H76 slips at share of the rate, " + name_of(setting), slipped_at / slip_radps);
        expect_at_most("H76 rate of slip " + name_of(setting),
                       std::abs(slipped_at / (slip_radps + late_radps) - 1),
                       0.02);
    }
}

}  // namespace
}  // namespace plumbline::study
