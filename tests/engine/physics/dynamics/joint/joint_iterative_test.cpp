// Joints solved by sweeps.
#include "tests/engine/physics/dynamics/joint/joint_rig.h"

#include <gtest/gtest.h>

namespace plumbline::physics {
namespace {

TEST(JointIterative, IterativeChainStretchesAsSoftJointsDo) {
    // Ten links and a hundredfold load. Halving the sub-step makes the joints four times as stiff.
    double before = 0;
    for (const int substeps : {4, 8, 16}) {
        JointRig rig;
        rig.method = JointMethod::Iterative;
        rig.kick = Kick::Steady;
        std::uint32_t last = 0;
        for (int i = 0; i < 10; ++i) {
            const std::uint32_t link =
                rig.add_body(1, {0.01417, 0.00167, 0.01417}, {0, -0.4 * i - 0.2, 0});
            rig.add_ball(link, last, {0, -0.4 * i, 0});
            last = link;
        }
        rig.add_ball(rig.add_ball_body(100, 0.25, {0, -4.25, 0}), last, {0, -4, 0});
        rig.run(10, kFrame_s, substeps);
        const double stretch = rig.sum_of_errors() / 4;
        EXPECT_LT(stretch, 0.04 * 16 / (substeps * substeps));
        EXPECT_LT(rig.max_speed(), 0.01);
        EXPECT_NEAR(glm::length(rig.joints[0].total_impulse_Ns) / kFrame_s, 110 * kG, 1);
        if (before > 0) {
            EXPECT_NEAR(before / stretch, 4, 0.1);
        }
        before = stretch;
    }
}

}  // namespace
}  // namespace plumbline::physics
