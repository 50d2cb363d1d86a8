// Bodies that kinematic ones carry or crush, beside what the scenes H74 and H75 have.
#include "tests/scenarios/families/case_run.h"

namespace plumbline::study {
namespace {

/// A plate comes down on a box until half of it is left as room, and goes up again; H74's leaves 95 %.
TEST(Carried, ACrusherLetsGoWithoutAKick) {
    constexpr double kRoom_m = 0.5;
    for (const int hz : {30, 60, 240}) {
        ScenarioWorld world(balanced(hz));
        world.floor();
        const BodyId plate = world.kinematic_box({0, 2.25, 0}, {4, 0.5, 4});
        const BodyId box = world.box({0, 0.5, 0}, {1, 1, 1});
        double while_crushed = 0;
        double after = 0;
        const int steps = steps_of(world, 6);
        for (int i = 1; i <= steps; ++i) {
            const double t = i * world.physics.def().step_s;
            // Down in 2 s, stays 1 s, up in 1 s.
            const double open = t < 2 ? 1 - t / 2 : t < 3 ? 0 : std::min(1.0, t - 3);
            const double gap_m = kRoom_m + (2 - kRoom_m) * open;
            world.physics.move_kinematic(plate, {vec(0, gap_m + 0.25, 0), kNoRotation});
            world.physics.step();
            const double speed = glm::length(world.velocity(box));
            (t > 3 ? after : while_crushed) = std::max(t > 3 ? after : while_crushed, speed);
        }
        const std::string row = fmt::format("crusher, {} Hz ", hz);
        EXPECT_TRUE(all_finite(world));
        expect_at_most(row + "speed while crushed m/s", while_crushed, 2 * kPush_mps);
        expect_at_most(row + "speed after m/s", after, kPush_mps);
    }
}

/// A lift with five boxes goes up at 3 m/s, stops at once, goes down at less than free fall allows.
TEST(Carried, H75ALiftCarriesAStack) {
    for (const int hz : {30, 60, 240}) {
        ScenarioWorld world(balanced(hz));
        const BodyId lift = world.kinematic_box({0, -0.5, 0}, {4, 1, 4});
        for (int i = 0; i < 5; ++i) world.box({0, 0.5 + i, 0}, {1, 1, 1});
        const auto ride = [&](double speed_mps, double seconds) {
            for (int i = 0; i < steps_of(world, seconds); ++i) {
                world.physics.set_velocity(lift, vec(0, speed_mps, 0), {0, 0, 0});
                world.physics.step();
            }
        };
        const auto lean = [&] {
            double worst = 0;
            for (std::size_t i = 0; i < 5; ++i) {
                const Vec3d off = world.at(world.movers[i]) - world.at(lift) -
                                  Vec3d{0, 1 + static_cast<double>(i), 0};
                worst = std::max(worst, glm::length(off));
            }
            return worst;
        };
        const std::string row = fmt::format("H75 lift {} Hz ", hz);
        ride(0, 1);
        ride(3, 2);
        expect_at_most(row + "rising, off m", lean(), 0.02);
        // Thrown up 3 m/s by the stop, they land v^2/2g = 0.46 m lower within 0.62 s.
        ride(0, 0.15);
        const double hop = world.at(world.movers[0]).y - world.at(lift).y - 1;
        expect_at_most(row + "hop after the stop",
                       std::abs(hop / (3 * 0.15 - 0.5 * kG_mps2 * 0.15 * 0.15) - 1),
                       hz == 30 ? 0.3 : 0.1);
        ride(0, 2);
        expect_at_most(row + "after the stop, off m", lean(), 0.05);
        // Down: free fall catches up with 5 m/s after half a second.
        ride(-5, 2);
        expect_at_most(row + "sinking, off m", lean(), 0.05);
        EXPECT_TRUE(all_finite(world));
    }
}

/// A lift that speeds up gently is not left, one that drops faster than g is.
TEST(Carried, H75ContactLastsExactlyWhileTheLiftFallsSlowerThanG) {
    for (const double share : {0.9, 1.1}) {
        ScenarioWorld world(balanced());
        const BodyId lift = world.kinematic_box({0, -0.5, 0}, {4, 1, 4});
        const BodyId box = world.box({0, 0.5, 0}, {1, 1, 1});
        world.run(1);
        const double acceleration = share * kG_mps2;
        double gap = 0;
        for (int i = 1; i <= 60; ++i) {
            const double t = i / 60.0;
            world.physics.move_kinematic(
                lift, {vec(0, -0.5 - 0.5 * acceleration * t * t, 0), kNoRotation});
            world.physics.step();
            gap = std::max(gap, world.at(box).y - world.at(lift).y - 1);
        }
        if (share < 1) {
            // Its way is a polygon: at each corner the box hops by (0.9 g dt)^2 / 2g = 1.1 mm.
            expect_at_most("H75 gap on a lift of 0.9 g m", gap, 3e-3);
        } else {
            // Its first step is a straight line at half the speed it ends with: the box follows that.
            const double first = (kG_mps2 - 1.1 * kG_mps2 / 2) / 60;
            expect_at_most(
                "H75 gap on a lift of 1.1 g", std::abs(gap / (0.05 * kG_mps2 + first) - 1), 0.05);
        }
    }
}

}  // namespace
}  // namespace plumbline::study
