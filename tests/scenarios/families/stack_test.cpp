// Bodies on top of each other, beside what the scenes H08 and H20 have.
#include "tests/scenarios/families/case_run.h"

namespace plumbline::study {
namespace {

/// A box of 20 m and 8000 kg on two small ones under its middle; those of H08 are near its edges.
TEST(Stack, AHugeBoxStandsOnTwoSmallOnesUnderItsMiddle) {
    ScenarioWorld world(balanced());
    world.floor();
    world.box({-4, 0.5, 0}, {1, 1, 1});
    world.box({4, 0.5, 0}, {1, 1, 1});
    const BodyId huge = world.box({0, 11, 0}, {20, 20, 20}, {.mass_kg = 8000});
    const Watch seen = watch(world, 20, 5);
    const std::string row = "8000 kg on two";
    EXPECT_TRUE(seen.finite);
    expect_at_most(row + " penetration m", seen.penetration_m, 0.2);
    expect_at_most(row + " small ones move m",
                   std::max(drift_m(world.at(world.movers[0]), {-4, 0, 0}),
                            drift_m(world.at(world.movers[1]), {4, 0, 0})),
                   0.1);
    expect_at_most(row + " comes down m", std::abs(world.at(huge).y - 11), 0.3);
}

/// As H20, without its friction.
TEST(Stack, AColumnOfSmoothBallsInATubeBearsAPiston) {
    constexpr double kInner_m = 1.02;
    const BodyProperties smooth{.friction = 0};
    ScenarioWorld world(balanced());
    world.floor(0);
    for (const double side : {-1.0, 1.0}) {
        const double at_m = side * (kInner_m / 2 + 0.5);
        world.fixed_box({at_m, 15, 0}, {1, 30, 4}, smooth);
        world.fixed_box({0, 15, at_m}, {4, 30, 1}, smooth);
    }
    for (int i = 0; i < 20; ++i)
        world.sphere({0.001 * (i % 2), 0.5 + i, 0.001 * (i % 3)}, 0.5, smooth);
    const BodyId piston = world.box({0, 20.5, 0}, {1, 1, 1}, {.mass_kg = 100, .friction = 0});
    const Watch seen = watch(world, 10, 8);
    EXPECT_TRUE(seen.finite);
    expect_at_most("tube, mu 0 energy gain", seen.energy_gain, 0.01);
    // Zigzag in a tube wider than the balls takes no more than 1 - cos off each. Nothing stops the piston
    // from sliding to and fro on the topmost ball.
    expect_at_most("tube, mu 0 compression", (20.5 - world.at(piston).y) / 20, 0.02);
}

/// Each lies on the next but for 3 mm, another way each time: what presses one leans it.
TEST(Stack, CoinsBesideEachOthersMiddlesLieStill) {
    constexpr double kThick_m = 0.02;
    ScenarioWorld world(balanced());
    world.floor();
    for (int i = 0; i < 30; ++i)
        world.cylinder({0.003 * std::sin(2.4 * i), kThick_m * (i + 0.5), 0.003 * std::cos(2.4 * i)},
                       0.12,
                       kThick_m);
    const Watch seen = watch(world, 6, 3);
    EXPECT_TRUE(seen.finite);
    expect_at_most("30 coins speed m/s", seen.speed_mps, 1e-3);
    expect_at_most("30 coins penetration m", seen.penetration_m, 1e-3);
}

/// Of 2 mm thickness and 24 mm width, each beside the next by up to half a millimetre: the lowest carries 39 others.
TEST(Stack, FortyCoinsOfTheirTrueSizeStand) {
    constexpr double kThick_m = 0.002;
    ScenarioWorld world(balanced());
    world.floor();
    for (int i = 0; i < 40; ++i)
        world.cylinder(
            {0.0005 * (i % 3), kThick_m * (i + 0.5), 0.0002 * (i * 7 % 5)}, 0.012, kThick_m);
    const Watch seen = watch(world, 6, 3);
    EXPECT_TRUE(seen.finite);
    expect_at_most("40 small coins speed m/s", seen.speed_mps, 1e-3);
    expect_at_most("40 small coins penetration m", seen.penetration_m, 1e-4);
}

}  // namespace
}  // namespace plumbline::study
