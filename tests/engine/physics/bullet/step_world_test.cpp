// The bullet_* solvers: their step, and whom it lays down.
#include "engine/physics/totals.h"
#include "tests/engine/physics/test_world.h"

namespace plumbline::physics {
namespace {

WorldDef bullet_world(const Vec3& gravity_mps2 = {0, -9.81_r, 0}) {
    return {.gravity_mps2 = gravity_mps2, .iterations = 10, .solver = Solver::BulletSi};
}

TEST(StepWorld, PileSleepsAndWakesWhenItsSupportGoes) {
    TestWorld test(bullet_world());
    test.ground();
    const BodyId lower = test.add(BoxShape{}, {0, 0.5_r, 0});
    const BodyId upper = test.add(BoxShape{}, {0, 1.5_r, 0});
    test.run(4.0);
    EXPECT_EQ(awake_count(test.world), 0U);
    test.world.destroy_body(lower);
    EXPECT_EQ(awake_count(test.world), 1U);
    test.run(0.25);
    EXPECT_LT(test.at(upper).y, 1.5 - 0.5 * kG * 0.25 * 0.25 + 0.02);
}

TEST(StepWorld, SlowMoversKeepMoving) {
    TestWorld test(bullet_world());
    test.ground(0);
    const BodyId slider =
        test.add(BoxShape{.size_m = {1, 0.2_r, 1}},
                 {0, 0.1_r, 0},
                 {.kind = BodyKind::Dynamic, .velocity_mps = {0.1_r, 0, 0}, .friction = 0});
    test.run(10.0);
    EXPECT_NEAR(test.at(slider).x, 1.0, 0.01);

    TestWorld space(bullet_world({0, 0, 0}));
    const BodyId drifting = space.add(
        BoxShape{}, {0, 0, 0}, {.kind = BodyKind::Dynamic, .velocity_mps = {0.001_r, 0, 0}});
    space.run(10.0);
    EXPECT_NEAR(space.at(drifting).x, 0.01, 1e-6);
}

}  // namespace
}  // namespace plumbline::physics
