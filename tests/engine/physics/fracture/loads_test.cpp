// What pushes a body adds up to what moves it.
#include "engine/physics/fracture.h"
#include "tests/engine/physics/test_world.h"

namespace plumbline::physics {
namespace {

Vec3d sum_of(const std::vector<BodyLoad>& loads) {
    Vec3d sum{0, 0, 0};
    for (const BodyLoad& load : loads) sum += load.force_N;
    return sum;
}

TEST(LoadsOnABody, AtRestAreItsWeight) {
    for (const Solver solver : {Solver::SmallStep, Solver::BulletSi}) {
        TestWorld rig({.solver = solver});
        rig.ground();
        const BodyId box = rig.add(BoxShape{{1, 1, 1}},
                                   {0, 0.5_r, 0},
                                   {.kind = BodyKind::Dynamic, .mass_kg = 10, .can_sleep = false});
        rig.run(1);
        const std::vector<BodyLoad> loads = loads_on(rig.world, box, 1e-3);
        EXPECT_NEAR(sum_of(loads).y, 10 * kG, 0.01 * 10 * kG) << solver_name(solver);
        for (const BodyLoad& load : loads) EXPECT_NEAR(load.point_m.y, 0, 0.01);
    }
}

TEST(LoadsOnABody, OfAJointHoldItUp) {
    TestWorld rig;
    const BodyId box =
        rig.add(BoxShape{{1, 1, 1}}, {0, 5, 0}, {.kind = BodyKind::Dynamic, .mass_kg = 10});
    ASSERT_TRUE(rig.world
                    .create_joint({.kind = JointKind::Fixed,
                                   .a = box,
                                   .anchor_a_world = {0.5_r, 5, 0},
                                   .anchor_b_world = {0.5_r, 5, 0}})
                    .ok());
    rig.run(0.2);
    const std::vector<BodyLoad> loads = loads_on(rig.world, box, 1e-3);
    ASSERT_EQ(loads.size(), 1U);
    EXPECT_NEAR(loads[0].force_N.y, 10 * kG, 0.01);
    EXPECT_NEAR(loads[0].point_m.x, 0.5, 1e-5);
    EXPECT_NEAR(std::abs(loads[0].torque_Nm.z), 10 * kG * 0.5, 0.01);
}

// The same at every rate.
TEST(LoadsOnABody, OfAnImpactAreItsMomentumByItsTime) {
    for (const int hz : {60, 240}) {
        TestWorld rig({.gravity_mps2 = {0, 0, 0}, .step_s = 1.0 / hz});
        rig.ground();
        const BodyId ball =
            rig.add(SphereShape{0.5_r},
                    {0, 0.6_r, 0},
                    {.kind = BodyKind::Dynamic, .mass_kg = 2, .velocity_mps = {0, -3, 0}});
        Vec3d most_N{0, 0, 0};
        for (int i = 0; i < hz / 5; ++i) {
            rig.world.step();
            most_N = glm::max(most_N, sum_of(loads_on(rig.world, ball, 1e-3)));
        }
        EXPECT_NEAR(most_N.y, 2 * 3 / 1e-3, 0.02 * 6000) << hz;
    }
}

}  // namespace
}  // namespace plumbline::physics
