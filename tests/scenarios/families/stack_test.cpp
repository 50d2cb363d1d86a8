// Bodies on top of each other: H01-H05, H08, H11, H17, H19, H20, H22, H24.
#include "tests/scenarios/families/case_run.h"

namespace plumbline::study {
namespace {

/// Boxes of 1 m exactly on each other, the k-th of mass masses[k].
void stack_up(ScenarioWorld& world, const std::vector<double>& masses_kg) {
    world.floor();
    for (std::size_t i = 0; i < masses_kg.size(); ++i)
        world.box({0, 0.5 + static_cast<double>(i), 0}, {1, 1, 1}, {.mass_kg = masses_kg[i]});
}

/// How far the top came down, and how far any box went aside.
struct Lean {
    double sag_m;
    double drift_m;
};
Lean lean_of(const ScenarioWorld& world) {
    Lean lean{static_cast<double>(world.movers.size()) - 0.5 - world.at(world.movers.back()).y, 0};
    for (const BodyId id : world.movers)
        lean.drift_m = std::max(lean.drift_m, drift_m(world.at(id), {0, 0, 0}));
    return lean;
}

void expect_tower(const std::string& row, const Setting& setting, int boxes, double seconds) {
    ScenarioWorld world(setting);
    stack_up(world, std::vector<double>(static_cast<std::size_t>(boxes), 1.0));
    const Watch seen = watch(world, seconds, 5);
    expect_sound(row, seen);
    const Lean lean = lean_of(world);
    expect_at_most(row + " drift m", lean.drift_m, 0.01);
    expect_at_most(row + " sag m", std::abs(lean.sag_m), 0.02 * boxes);
    expect_at_most(row + " speed m/s", seen.speed_mps, 5e-3);
}

TEST(Stack, H01ATowerOfTenStands) {
    for (const int hz : {30, 60, 240})
        expect_tower(fmt::format("H01 tower of 10, {} Hz", hz), balanced(hz), 10, 10);
}
TEST(Stack, H02ATowerOfTwentyStands) {
    expect_tower("H02 tower of 20", balanced(), 20, 60);
}
TEST(Stack, H03ATowerOfFortyStands) {
    expect_tower("H03 tower of 40", balanced(), 40, 60);
}

void expect_loaded(const std::string& row,
                   const Setting& setting,
                   const std::vector<double>& masses_kg,
                   double seconds,
                   double sag_m) {
    ScenarioWorld world(setting);
    stack_up(world, masses_kg);
    const Watch seen = watch(world, seconds, 5);
    EXPECT_TRUE(seen.finite);
    expect_at_most(row + " energy gain", seen.energy_gain, 0.01);
    const Lean lean = lean_of(world);
    expect_at_most(row + " sag m", std::abs(lean.sag_m), sag_m);
    expect_at_most(row + " drift m", lean.drift_m, 0.01);
    expect_at_most(row + " penetration m", seen.penetration_m, 0.02);
    expect_at_most(row + " speed m/s", seen.speed_mps, 5e-3);
}

TEST(Stack, H04FiveBoxesBearAHundredfoldOne) {
    for (const int hz : {30, 60, 240}) {
        expect_loaded(
            fmt::format("H04 top x 100, {} Hz", hz), balanced(hz), {1, 1, 1, 1, 100}, 10, 0.1);
    }
}
TEST(Stack, H05ABoxBearsAThousandfoldOne) {
    expect_loaded("H05 1000:1", balanced(), {1, 1000}, 60, 0.1);
    expect_loaded("H05 1000:1, 30 Hz", balanced(30), {1, 1000}, 10, 0.1);
}
TEST(Stack, H24LightAndHeavyBoxesAlternate) {
    for (const int hz : {30, 60, 240}) {
        expect_loaded(fmt::format("H24 sandwich, {} Hz", hz),
                      balanced(hz),
                      {1, 100, 1, 100, 1, 100},
                      10,
                      0.6);
    }
}

/// A box of 20 m and 8000 kg on two small ones, near its edges.
TEST(Stack, H08AHugeBoxStandsOnTwoSmallOnes) {
    for (const double out_m : {4.0, 9.0}) {
        ScenarioWorld world(balanced());
        world.floor();
        world.box({-out_m, 0.5, 0}, {1, 1, 1});
        world.box({out_m, 0.5, 0}, {1, 1, 1});
        const BodyId huge = world.box({0, 11, 0}, {20, 20, 20}, {.mass_kg = 8000});
        const Watch seen = watch(world, 20, 5);
        const std::string row = fmt::format("H08 8000 kg on two, {} m out", out_m);
        EXPECT_TRUE(seen.finite);
        expect_at_most(row + " penetration m", seen.penetration_m, 0.2);
        expect_at_most(row + " small ones move m",
                       std::max(drift_m(world.at(world.movers[0]), {-out_m, 0, 0}),
                                drift_m(world.at(world.movers[1]), {out_m, 0, 0})),
                       0.1);
        expect_at_most(row + " comes down m", std::abs(world.at(huge).y - 11), 0.3);
    }
}

TEST(Stack, H11APyramidKeepsItsShape) {
    constexpr int kBase = 20;
    ScenarioWorld world(balanced());
    world.floor();
    std::vector<Vec3d> places;
    for (int row = 0; row < kBase; ++row) {
        for (int i = 0; i < kBase - row; ++i)
            places.push_back({1.05 * (i - 0.5 * (kBase - 1 - row)), 0.5 + row, 0});
    }
    for (const Vec3d& at : places) world.box(at, {1, 1, 1});
    const Watch seen = watch(world, 10, 5);
    double sum = 0;
    for (std::size_t i = 0; i < places.size(); ++i)
        sum += glm::distance(world.at(world.movers[i]), places[i]);
    expect_sound("H11 pyramid of 210", seen);
    expect_at_most("H11 mean displacement m", sum / static_cast<double>(places.size()), 0.02);
    expect_at_most("H11 speed m/s", seen.speed_mps, 5e-3);
}

TEST(Stack, H17DominoesFallAndNoneFlies) {
    for (const int hz : {30, 60, 240}) {
        ScenarioWorld world(balanced(hz));
        world.floor(0.6);
        for (int i = 0; i < 15; ++i) {
            world.box({1.01 * i - 7.5, 0.5, 0}, {0.25, 1, 0.5}, {.mass_kg = 0.25, .friction = 0.6});
        }
        world.physics.apply_impulse_at(world.movers[0], vec(0.2, 0, 0), vec(-7.5, 1, 0));
        double top = 0;
        for (int i = 0; i < 15 * hz; ++i) {
            world.physics.step();
            top = std::max(top, top_speed_mps(world));
        }
        int standing = 0;
        for (const BodyId id : world.movers) {
            const Vec3d up = world.turn(id) * Vec3d{0, 1, 0};
            if (up.y > 0.9) ++standing;
        }
        EXPECT_TRUE(all_finite(world));
        EXPECT_EQ(standing, 0) << hz << " Hz";
        expect_at_most(fmt::format("H17 dominoes, top speed m/s, {} Hz", hz), top, 10);
    }
}

/// Ten balls one exactly on the other: they may come down some day, but not jump.
TEST(Stack, H19ColumnOfBallsGainsNothing) {
    ScenarioWorld world(balanced());
    world.floor();
    for (int i = 0; i < 10; ++i) world.ball({0, 0.5 + i, 0}, 0.5);
    const double start_J = world.energy_J();
    double gain_J = 0;
    double up_mps = 0;
    for (int i = 0; i < 600; ++i) {
        world.physics.step();
        gain_J = std::max(gain_J, world.energy_J() - start_J);
        // Until it topples.
        if (world.at(world.movers[9]).y < 9.4) continue;
        for (const BodyId id : world.movers) up_mps = std::max(up_mps, world.velocity(id).y);
    }
    EXPECT_TRUE(all_finite(world));
    expect_at_most("H19 balls, energy gain", gain_J / start_J, 1e-3);
    expect_at_most("H19 balls, jump m/s", up_mps, 0.1);
}

TEST(Stack, H20AColumnOfBallsInATubeBearsAPiston) {
    for (const double friction : {0.0, 0.5}) {
        constexpr double kInner_m = 1.02;
        ScenarioWorld world(balanced());
        world.floor(friction);
        for (const double side : {-1.0, 1.0}) {
            const double at_m = side * (kInner_m / 2 + 0.5);
            world.fixed_box({at_m, 15, 0}, {1, 30, 4}, {.friction = friction});
            world.fixed_box({0, 15, at_m}, {4, 30, 1}, {.friction = friction});
        }
        for (int i = 0; i < 20; ++i)
            world.ball({0.001 * (i % 2), 0.5 + i, 0.001 * (i % 3)}, 0.5, {.friction = friction});
        const BodyId piston =
            world.box({0, 20.5, 0}, {1, 1, 1}, {.mass_kg = 100, .friction = friction});
        const Watch seen = watch(world, 10, 8);
        const std::string row = fmt::format("H20 tube, mu {}", friction);
        EXPECT_TRUE(seen.finite);
        expect_at_most(row + " energy gain", seen.energy_gain, 0.01);
        // Zigzag in a tube wider than the balls takes no more than 1 - cos off each.
        expect_at_most(row + " compression", (20.5 - world.at(piston).y) / 20, 0.02);
        // Without friction nothing stops the piston from sliding to and fro on the topmost ball.
        if (friction > 0) expect_at_most(row + " speed m/s", seen.speed_mps, 0.01);
    }
}

TEST(Stack, H22APileOfBoxesComesToRest) {
    constexpr int kSide = 8;
    ScenarioWorld world(balanced());
    world.floor();
    for (int i = 0; i < kSide * kSide * kSide; ++i) {
        const int x = i % kSide;
        const int z = i / kSide % kSide;
        const int y = i / (kSide * kSide);
        world.box({1.1 * x, 0.6 + 1.1 * y, 1.1 * z}, {1, 1, 1});
    }
    const Watch seen = watch(world, 6, 5);
    expect_sound("H22 pile of 512", seen);
    expect_at_most("H22 kinetic energy at the end J", world.physics.energy().kinetic_J, 0.1);
}

}  // namespace
}  // namespace plumbline::study
