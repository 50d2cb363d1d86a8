// Coulomb friction of boxes: A28, A29, A34, H76, H84.
#include "tests/scenarios/families/rig.h"

#include <functional>

namespace plumbline::physics {
namespace {

/// Where a box of 5 m/s comes to rest that was sent off at `heading_rad` with its faces turned by
/// `turned_rad`.
Vec3d stop_of(const WorldDef& def, const Vec3d& size, double heading_rad, double turned_rad) {
    Rig rig(def);
    rig.floor(0.3);
    const Vec3d ahead{std::cos(heading_rad), 0, -std::sin(heading_rad)};
    const BodyId box = rig.box({0, size.y / 2, 0},
                               size,
                               {.friction = 0.3,
                                .velocity_mps = ahead * 5.0,
                                .turn = glm::angleAxis(turned_rad, Vec3d{0, 1, 0})});
    rig.run(2.5);
    return rig.at(box);
}

TEST(Sliding, A28ABoxStopsWhereFrictionSays) {
    constexpr double kDistance_m = 4.2473667;
    for (const double height_m : {1.0, 0.25}) {
        for (const int hz : {30, 60, 240}) {
            for (const Setting& setting : every_s(hz)) {
                const Vec3d at = stop_of(setting.def, {1, height_m, 1}, 0, 0);
                const std::string row =
                    fmt::format("A28 stop, box 1 x {} {} Hz {} ", height_m, hz, setting.name);
                expect_at_most(row + "distance", std::abs(at.x / kDistance_m - 1), 5e-3);
                expect_at_most(row + "aside", std::abs(at.z) / kDistance_m, 1e-3);
            }
        }
    }
}

TEST(Sliding, A28StopsAlikeInEveryDirection) {
    for (const double turns : {0.0, 1.0}) {
        double least = 1e9;
        double most = 0;
        for (int i = 0; i < 24; ++i) {
            const double heading = i * kPiD / 12;
            const Vec3d at = stop_of(balanced(), {1, 0.25, 1}, heading, turns * heading);
            const double way = std::hypot(at.x, at.z);
            least = std::min(least, way);
            most = std::max(most, way);
        }
        expect_at_most(
            turns > 0 ? "A28 24 headings, box turned along" : "A28 24 headings, same box",
            (most - least) / most,
            1e-3);
    }
}

/// A slope of `angle_rad` through the origin that goes down along +x.
struct Slope {
    Quatd turn;
    Vec3d down;
    Vec3d out;

    explicit Slope(double angle_rad)
        : turn(glm::angleAxis(-angle_rad, Vec3d{0, 0, 1})),
          down(turn * Vec3d{1, 0, 0}),
          out(turn * Vec3d{0, 1, 0}) {}
    void add_to(Rig& rig, double friction) const {
        rig.fixed_box(out * -1.0, {200, 2, 200}, {.friction = friction, .turn = turn});
    }
    /// How far along the slope, whatever the box sinks in.
    double way_m(const Vec3d& from, const Vec3d& to) const {
        const Vec3d moved = to - from;
        return glm::length(moved - out * glm::dot(moved, out));
    }
};

TEST(Sliding, A29ABoxBelowTheLimitStays) {
    for (const Setting& setting : every_s()) {
        Rig rig(setting.def);
        const Slope slope(std::atan(0.99 * 0.5));
        slope.add_to(rig, 0.5);
        const BodyId box = rig.box(slope.out * 0.5, {1, 1, 1}, {.turn = slope.turn});
        const Vec3d start = rig.at(box);
        rig.run(60);
        expect_at_most(
            "A29 creep in 60 s m " + setting.name, slope.way_m(start, rig.at(box)), 1e-4);
    }
}

TEST(Sliding, H84ABoxOnTwentyDegreesStays) {
    for (const int hz : {30, 60, 240}) {
        Rig rig(balanced(hz));
        const Slope slope(20 * kPiD / 180);
        slope.add_to(rig, 0.5);
        const BodyId box = rig.box(slope.out * 0.5, {1, 1, 1}, {.turn = slope.turn});
        const Vec3d start = rig.at(box);
        rig.run(60);
        expect_at_most(
            fmt::format("H84 creep in 60 s m {} Hz", hz), slope.way_m(start, rig.at(box)), 1e-4);
    }
}

TEST(Sliding, A29ABoxAboveTheLimitGainsSpeedAsNewtonSays) {
    struct Case {
        double slope;
        double mu;
    };
    for (const Case& one : {Case{0.505, 0.5}, {0.55, 0.5}, {0.5, 0.3}, {0.7, 0.1}}) {
        for (const Setting& setting : every_s()) {
            Rig rig(setting.def);
            const double angle = std::atan(one.slope);
            const Slope slope(angle);
            slope.add_to(rig, one.mu);
            const BodyId box =
                rig.box(slope.out * 0.5, {1, 1, 1}, {.friction = one.mu, .turn = slope.turn});
            rig.run(1);
            const double before = glm::dot(rig.velocity(box), slope.down);
            const Vec3d then = rig.at(box);
            rig.run(3);
            const double expected = kG * (std::sin(angle) - one.mu * std::cos(angle));
            const double gained = glm::dot(rig.velocity(box), slope.down) - before;
            const double way = glm::dot(rig.at(box) - then, slope.down);
            const std::string row =
                fmt::format("A29 slope {} mu {} {} ", one.slope, one.mu, setting.name);
            expect_at_most(row + "acceleration", std::abs(gained / (3 * expected) - 1), 5e-3);
            expect_at_most(row + "way", std::abs(way / (before * 3 + 4.5 * expected) - 1), 5e-3);
            // What the first steps let it slip before friction holds.
            expect_at_most(row + "head start", std::abs(before - expected) / expected, 5e-3);
        }
    }
}

/// A box spinning on its face stops by the law of four corners or of even pressure, and by the same
/// one however it stands and however fast the world steps.
TEST(Sliding, A34ASpinningBoxStopsByOneLaw) {
    const auto stop_s = [](const WorldDef& def, double turned_rad) {
        Rig rig(def);
        rig.floor(0.3);
        const BodyId box = rig.box({0, 0.5, 0},
                                   {1, 1, 1},
                                   {.friction = 0.3,
                                    .spin_radps = {0, 10, 0},
                                    .turn = glm::angleAxis(turned_rad, Vec3d{0, 1, 0})});
        const int steps = steps_of(def, 3);
        double before = 10;
        for (int i = 1; i <= steps; ++i) {
            rig.world.step();
            const double now = rig.spin(box).y;
            if (now < 1) return (i - (1 - now) / (before - now)) * def.step_s / 0.9;
            before = now;
        }
        return 3.0;
    };
    const double corners_s = 10.0 / 6 / (0.3 * kG * std::sqrt(0.5));
    double least = 1e9;
    double most = 0;
    for (int i = 0; i < 12; ++i) {
        const double found = stop_s(balanced(), i * kPiD / 24);
        least = std::min(least, found);
        most = std::max(most, found);
    }
    note("A34 stop time over that of four corners", least / corners_s);
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
    const double slip_radps = std::sqrt(0.5 * kG / kRadius_m);
    const double gain = 1.2 * slip_radps / kSeconds;
    // Beyond the limit the way out grows as w r gain t^3 / 3.
    const double late_radps = gain * std::cbrt(3 * kSlipped_m / (slip_radps * kRadius_m * gain));
    for (const Setting& setting : every_s()) {
        Rig rig(setting.def);
        const BodyId plate = rig.carrier({0, -0.5, 0}, {10, 1, 10});
        const BodyId box = rig.box({kRadius_m, 0.125, 0}, {0.25, 0.25, 0.25});
        double slipped_at = 0;
        const int steps = steps_of(setting.def, kSeconds);
        for (int i = 1; i <= steps && slipped_at == 0; ++i) {
            const double rate = gain * kSeconds * i / steps;
            rig.world.set_velocity(plate, {0, 0, 0}, vec(0, rate, 0));
            rig.world.step();
            if (std::hypot(rig.at(box).x, rig.at(box).z) > kRadius_m + kSlipped_m)
                slipped_at = rate;
        }
        note("H76 slips at share of the rate, " + setting.name, slipped_at / slip_radps);
        expect_at_most("H76 rate of slip " + setting.name,
                       std::abs(slipped_at / (slip_radps + late_radps) - 1),
                       0.02);
    }
}

}  // namespace
}  // namespace plumbline::physics
