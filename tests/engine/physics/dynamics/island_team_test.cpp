// The same bits however many threads share a step.
#include "tests/engine/physics/test_world.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace plumbline::physics {
namespace {

using Build = std::function<std::vector<BodyId>(TestWorld&)>;

std::uint64_t hash_with(int threads, const Build& build, double seconds) {
    TestWorld test({.threads = threads});
    const std::vector<BodyId> bodies = build(test);
    test.run(seconds);
    return test.hash(bodies);
}

/// Runs more often than once: what threads decide among them differs from run to run.
void expect_same_bits(const Build& build, double seconds) {
    const std::uint64_t alone = hash_with(1, build, seconds);
    for (const int threads : {2, 2, 3, 7, 7})
        EXPECT_EQ(hash_with(threads, build, seconds), alone) << threads << " threads";
}

/// Boxes that fall onto each other in a heap, of different sizes.
std::vector<BodyId> heap(TestWorld& test) {
    test.ground();
    std::vector<BodyId> bodies;
    for (int i = 0; i < 400; ++i) {
        const Real size_m = 0.1_r + 0.02_r * static_cast<Real>(i % 7);
        const Vec3 at{0.45_r * static_cast<Real>(i % 5),
                      0.3_r + 0.45_r * static_cast<Real>(i / 25),
                      0.45_r * static_cast<Real>(i / 5 % 5)};
        bodies.push_back(test.add(BoxShape{.size_m = {size_m, 0.15_r, 0.15_r}}, at));
    }
    return bodies;
}

std::vector<BodyId> many_small_stacks(TestWorld& test) {
    test.ground();
    std::vector<BodyId> bodies;
    for (int i = 0; i < 300; ++i) {
        const Vec3 at{static_cast<Real>(i % 10),
                      0.1_r + 0.21_r * static_cast<Real>(i / 100),
                      static_cast<Real>(i / 10 % 10)};
        bodies.push_back(test.add(BoxShape{.size_m = {0.1_r, 0.1_r, 0.1_r}}, at));
    }
    return bodies;
}

/// Stacks beside balls that come fast and a plate that moves: islands that take turns.
std::vector<BodyId> stacks_under_fire(TestWorld& test) {
    std::vector<BodyId> bodies = many_small_stacks(test);
    for (int i = 0; i < 20; ++i) {
        const BodyId ball =
            test.add(SphereShape{.radius_m = 0.05_r}, {-3, 0.3_r, 0.5_r * static_cast<Real>(i)});
        test.world.set_velocity(ball, {60, 0, 0}, {0, 0, 0});
        bodies.push_back(ball);
    }
    const BodyId plate = test.add(
        BoxShape{.size_m = {0.3_r, 0.05_r, 5}}, {-1, 0.1_r, 4.5_r}, {.kind = BodyKind::Kinematic});
    test.world.set_velocity(plate, {1, 0, 0}, {0, 0, 0});
    return bodies;
}

/// A block of boxes that touch: an island whose sweeps are shared.
std::vector<BodyId> block(TestWorld& test) {
    test.ground();
    std::vector<BodyId> bodies;
    for (int i = 0; i < 14 * 14 * 10; ++i) {
        const Vec3 at{0.2_r * static_cast<Real>(i % 14),
                      0.1_r + 0.2_r * static_cast<Real>(i / 196),
                      0.2_r * static_cast<Real>(i / 14 % 14)};
        bodies.push_back(test.add(BoxShape{.size_m = {0.2_r, 0.2_r, 0.2_r}}, at));
    }
    test.world.set_velocity(bodies[1000], {3, 2, 1}, {0, 5, 0});
    return bodies;
}

TEST(IslandTeam, OneLargeIslandMovesTheSame) {
    expect_same_bits(block, 5.0 / 60);
}

TEST(IslandTeam, AHeapMovesTheSame) {
    expect_same_bits(heap, 1.5);
}

TEST(IslandTeam, ManyIslandsMoveTheSame) {
    expect_same_bits(many_small_stacks, 1);
}

TEST(IslandTeam, IslandsThatAreSweptOrCarriedMoveTheSame) {
    expect_same_bits(stacks_under_fire, 1);
}

TEST(IslandTeam, TheirTimeIsCountedAndAFewBodiesWakeNobody) {
    TestWorld many({.threads = 2});
    heap(many);
    const StepCost& cost = many.world.report().cost;
    // A busy machine may leave the helper waiting for some steps.
    for (int step = 0; step < 600 && cost.helpers_ms == 0; ++step) many.world.step();
    EXPECT_GT(cost.helpers_ms, 0);
    EXPECT_GT(cost.total_ms, cost.helpers_ms);
    EXPECT_GT(cost.wall_ms, 0);

    TestWorld few({.threads = 2});
    few.ground();
    few.add(BoxShape{}, {0, 0.5_r, 0});
    few.run(0.5);
    EXPECT_EQ(few.world.report().cost.helpers_ms, 0);
}

}  // namespace
}  // namespace plumbline::physics
