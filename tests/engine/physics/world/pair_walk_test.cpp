// Which pairs a step looks at.
#include "engine/physics/totals.h"
#include "tests/engine/physics/world/asleep.h"

namespace plumbline::physics {
namespace {

TEST(Sleep, OneAwakeBodyLooksAtItsOwnPairsOnly) {
    Asleep asleep(10);
    asleep.test.add(BoxShape{}, {20, 0.5_r, 0}, {.kind = BodyKind::Dynamic, .can_sleep = false});
    asleep.test.run(0.5);
    EXPECT_EQ(awake_count(asleep.test.world), 1U);
    EXPECT_EQ(asleep.test.world.report().cost.pairs, 1U);
}

// Five balls in a row, a finger's breadth apart; the first comes at 20 m/s, a third of a metre a step.
TEST(PairWalk, ABlowReachesTheEndOfARowWithinTheStep) {
    WorldDef def = in_small_steps();
    def.gravity_mps2 = {0, 0, 0};
    TestWorld test(def);
    std::vector<BodyId> row;
    for (int i = 0; i < 5; ++i) {
        row.push_back(test.add(SphereShape{.radius_m = 0.1_r},
                               {0.21_r * static_cast<Real>(i), 0, 0},
                               {.kind = BodyKind::Dynamic, .friction = 0, .restitution = 1}));
    }
    test.world.set_velocity(row[0], {20, 0, 0}, {0, 0, 0});
    test.run(0.1);
    double momentum = 0;
    for (const BodyId id : row) momentum += test.velocity(id).x;
    EXPECT_NEAR(momentum, 20, 1e-3) << "of equal masses";
    EXPECT_GT(test.velocity(row[4]).x, 10);
    for (std::size_t i = 0; i + 1 < row.size(); ++i)
        EXPECT_GT(test.at(row[i + 1]).x - test.at(row[i]).x, 0.199) << "none went through";
}

}  // namespace
}  // namespace plumbline::physics
