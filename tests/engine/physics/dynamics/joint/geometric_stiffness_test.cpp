// Sub-steps too long for light bodies that joints pull hard.
#include "tests/engine/physics/dynamics/joint/joint_rig.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

/// A rod of 1 kg and 1 m between a ceiling and a ball that pulls it: how many times too long a
/// sub-step of 1/60 s is for its swinging across.
double unresolved_under(double ball_kg, const Vec3d& rod_inertia) {
    JointRig rig;
    const std::uint32_t rod = rig.add_body(1, rod_inertia, {0, -0.5, 0});
    rig.add_ball(rod, 0, {0, 0, 0});
    rig.add_ball(rig.add_ball_body(ball_kg, 0.2, {0, -1, 0}), rod, {0, -1, 0});
    double most = 0;
    for (int i = 0; i < 30; ++i) {
        rig.step(1.0 / 60, 1);
        most = std::max(most, rig.system.work().unresolved);
    }
    EXPECT_LT(rig.max_error(), 1e-5) << "slowed down, not torn";
    EXPECT_TRUE(std::isfinite(rig.energy()));
    return most;
}

TEST(GeometricStiffness, LightBodiesUnderSlightLoadsAreLeftAlone) {
    EXPECT_EQ(unresolved_under(1, {1.0 / 12, 0.01, 1.0 / 12}), 0);
}

// Four times the load swings twice as fast.
TEST(GeometricStiffness, HeavyLoadsSwingTheirRodTooFastByTheRootOfTheLoad) {
    const Vec3d thin{1e-4, 1e-4, 1e-4};
    const double slow = unresolved_under(1e3, thin);
    const double fast = unresolved_under(4e3, thin);
    EXPECT_GT(slow, 1);
    EXPECT_NEAR(fast / slow, 2, 0.1);
}

}  // namespace
}  // namespace plumbline::physics
