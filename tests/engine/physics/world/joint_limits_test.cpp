// Joints that are pressed against their limits for seconds.
#include "tests/engine/physics/joint_bench.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace plumbline::physics {
namespace {

// The motion took half of the way of a couple that the limit holds, further than a position step comes back: the limb hovered
// off its limit and reported 2.7 rad/s while it lay there.
TEST(PressedLimits, ALimbLiesStillOnConeAndTwist) {
    constexpr int kSettle_steps = 300;
    constexpr int kSteps = 60;
    TestWorld test({.gravity_mps2 = {0, 0, 0},
                    .substeps = 2,
                    .substeps_max = 16,
                    .iterations = 1,
                    .solver = Solver::SmallStep});
    const BodyDef limb{
        .kind = BodyKind::Dynamic, .mass_kg = 2, .angular_damping_per_s = 60, .can_sleep = false};
    const BodyId arm = test.add(BoxShape{.size_m = {0.4_r, 0.1_r, 0.1_r}}, {0.2_r, 0, 0}, limb);
    const JointId cone = join(test,
                              {.kind = JointKind::Cone,
                               .a = arm,
                               .axis_world = {1, 0, 0},
                               .limits = {{0, kPi / 3}},
                               .twist_limits = {{-0.07_r, 2.356_r}}});
    const Vec3 couple_Nm = glm::normalize(Vec3{1, 1, 1}) * Real{40};
    double fastest_radps = 0;
    for (int i = 0; i < kSettle_steps + kSteps; ++i) {
        test.world.apply_torque(arm, couple_Nm);
        test.world.step();
        if (i < kSettle_steps) continue;
        fastest_radps = std::max(fastest_radps, glm::length(test.spin(arm)));
    }
    EXPECT_NEAR(position(test, cone), static_cast<double>(kPi) / 3, 1e-4);
    EXPECT_LT(fastest_radps, 0.01);
}

}  // namespace
}  // namespace plumbline::physics
