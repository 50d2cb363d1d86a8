#include "engine/physics/dynamics/joint/joint_group.h"

#include <gtest/gtest.h>

#include <vector>

namespace plumbline::physics {
namespace {

// 0.5 m away: see the speeds of the push and of its own size a second.
TEST(JointGroup, ErrorsAtTheStartAreComeBackFromSlowly) {
    EXPECT_EQ(JointGroup::reduced_residual({0.9e-5, 0, 0}, 0.01), (Vec3d{0, 0, 0})) << "at once";
    const Vec3d away{0.3, 0, 0.4};
    const Vec3d after = JointGroup::reduced_residual(away, 0.01);
    EXPECT_NEAR(glm::length(after), 0.5 - (kPush_mps + 0.5) * 0.01, 1e-12);
    EXPECT_NEAR(glm::length(glm::cross(after, away)), 0, 1e-12) << "straight";
    EXPECT_EQ(JointGroup::reduced_residual({1e-3, 0, 0}, 1), (Vec3d{0, 0, 0})) << "never past it";
}

TEST(JointGroup, ABoundIsSolvedWhileItIsReached) {
    TopologyCache cache;
    std::vector<SolverBody> bodies(2);
    bodies[1].inverse_mass = 1;
    bodies[1].inertia_kgm2 = {1, 1, 1};
    std::vector<SolverJoint> joints(1);
    joints[0].kind = JointKind::Hinge;
    joints[0].a = 1;
    joints[0].limits = {0, 1};
    const std::vector<JointForm> forms{form_of(joints[0], false)};
    JointGroup group;
    group.substep_s = 0.01;
    group.joints = joints;
    group.topology = &cache.of(bodies, joints, forms);
    group.start(bodies);
    ASSERT_EQ(group.bounds.size(), 1U);
    JointBound& bound = group.bounds[0];
    EXPECT_EQ(bound.row, 2);
    EXPECT_NEAR(bound.mass, 1, 1e-6) << "the moment about the axis";
    EXPECT_EQ(group.bounds_of(group.topology->components[0]).size(), 1U);
    const auto row_is_solved = [&] { return group.rows[bound.node].is_active(2); };
    bound.step = BoundStep::Lower;
    group.set_active(bound);
    EXPECT_TRUE(row_is_solved());
    EXPECT_TRUE(group.rows[bound.node].is_active(0)) << "the others as they were";
    bound.release();
    group.set_active(bound);
    EXPECT_FALSE(row_is_solved());
    EXPECT_TRUE(group.rows[bound.node].is_active(0));
}

TEST(JointGroup, WhatTheRowsCarriedGoesToTheTotalsOnce) {
    TopologyCache cache;
    std::vector<SolverBody> bodies(2);
    bodies[1].inverse_mass = 1;
    bodies[1].inertia_kgm2 = {1, 1, 1};
    std::vector<SolverJoint> joints(1);
    joints[0].kind = JointKind::Fixed;
    joints[0].a = 1;
    const std::vector<JointForm> forms{form_of(joints[0], false)};
    JointGroup group;
    group.substep_s = 0.01;
    group.joints = joints;
    group.topology = &cache.of(bodies, joints, forms);
    group.start(bodies);
    group.impulses = {{1, 2, 3}, {4, 5, 6}};
    group.collect_totals();
    group.collect_totals();
    EXPECT_EQ(group.totals[0].impulse_Ns, (Vec3d{-1, -2, -3})) << "on a, against b";
    EXPECT_EQ(group.totals[0].angular_impulse_Nms, (Vec3d{-4, -5, -6}));
}

}  // namespace
}  // namespace plumbline::physics
