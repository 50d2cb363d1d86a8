#include "engine/physics/totals.h"

#include "tests/engine/physics/test_world.h"

namespace plumbline::physics {
namespace {

TEST(Totals, EnergyAndMomentumOfAThrow) {
    TestWorld test;
    test.add(BoxShape{},
             {0, 8, 0},
             {.kind = BodyKind::Dynamic, .mass_kg = 2, .velocity_mps = {3, 4, 0}});
    const Energy start = energy(test.world);
    EXPECT_NEAR(start.kinetic_J, 25.0, 1e-4);
    EXPECT_NEAR(start.potential_J, 2 * kG * 8, 1e-4);
    test.run(1.0);
    const Energy end = energy(test.world);
    EXPECT_NEAR(end.total_J(), start.total_J(), 200 * kRounding);
    EXPECT_NEAR(momentum_kgmps(test.world).x, 6.0, 10 * kRounding);
    EXPECT_NEAR(momentum_kgmps(test.world).y, 2 * (4 - kG), 20 * kRounding);
}

}  // namespace
}  // namespace plumbline::physics
