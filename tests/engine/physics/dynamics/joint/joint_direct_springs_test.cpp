// Springs as rows beside other joints, in one solve.
#include "tests/engine/physics/dynamics/joint/joint_rig.h"

#include <gtest/gtest.h>

namespace plumbline::physics {
namespace {

/// A chain of hard and elastic joints by turns, with a load a thousand times as heavy as a link.
struct MixedChain : JointRig {
    static constexpr int kLinks = 6;
    static constexpr double kStiffness_Npm = 2e5;
    std::uint32_t load{0};

    MixedChain() {
        kick = Kick::Steady;
        std::uint32_t before = 0;
        for (int i = 0; i < kLinks; ++i) {
            const bool last = i + 1 == kLinks;
            const Vec3d middle{0, -0.1 * i - 0.05, 0};
            const std::uint32_t link = add_body(last ? 10 : 0.01, Vec3d(last ? 0.1 : 1e-5), middle);
            const Vec3 at{0, static_cast<Real>(-0.1 * i), 0};
            const bool hard = i % 2 == 0;
            add_joint(link,
                      before,
                      {.kind = hard ? JointKind::BallAndSocket : JointKind::Elastic,
                       .anchor_a_world = at,
                       .anchor_b_world = at,
                       .stiffness_Npm = static_cast<Real>(hard ? 0 : kStiffness_Npm),
                       .damping_s = 0.01_r});
            before = link;
        }
        load = before;
    }
};

TEST(DirectSprings, AMixedChainStretchesBySumOfItsSprings) {
    MixedChain rig;
    rig.run(10, kFrame_s, 8);
    // Below each of the three springs hang the load and the links between.
    double exact_m = 0;
    for (const int below : {1, 3, 5}) {
        const double mass_kg = 10 + 0.01 * (MixedChain::kLinks - 1 - below);
        exact_m += mass_kg * kG / MixedChain::kStiffness_Npm;
    }
    EXPECT_NEAR(-0.55 - rig.position(rig.load).y, exact_m, 0.01 * exact_m);
    // The load swings slowly: it may rest with a part of g h.
    EXPECT_NEAR(rig.velocity(rig.load).y, 0, 0.05 * kG * kFrame_s / 8);
    EXPECT_LT(rig.max_error(), 1e-6);
}

// A line spring and an elastic block that share a body.
TEST(DirectSprings, LinesAndBlocksAddUp) {
    JointRig rig;
    rig.kick = Kick::Steady;
    const std::uint32_t ball = rig.add_body(0.01, {0, 0, 0}, {0, -1, 0});
    rig.add_joint(ball,
                  0,
                  {.kind = JointKind::Spring,
                   .anchor_a_world = {0, -1, 0},
                   .anchor_b_world = {0, 0, 0},
                   .stiffness_Npm = 3e4,
                   .damping_Nspm = 5,
                   .rest_length_m = 1});
    rig.add_joint(ball,
                  0,
                  {.kind = JointKind::Elastic,
                   .anchor_a_world = {0, -1, 0},
                   .anchor_b_world = {0, -1, 0},
                   .stiffness_Npm = 1e4,
                   .damping_s = 0.001_r});
    rig.run(5, kFrame_s, 4);
    EXPECT_NEAR(-1 - rig.position(ball).y, 0.01 * kG / 4e4, kFloat32 ? 2e-7 : 5e-8);
}

}  // namespace
}  // namespace plumbline::physics
