// What each kind holds, bad starts, and what does not depend on history.
#include "tests/engine/physics/dynamics/joint/count_allocations.h"
#include "tests/engine/physics/dynamics/joint/joint_rig.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::physics {
namespace {

JointDef def_of(JointKind kind, const Vec3d& at) {
    return {.kind = kind,
            .anchor_a_world = Vec3(at),
            .anchor_b_world = Vec3(at + Vec3d{0, 0.3, 0}),
            .axis_world = Vec3(glm::normalize(Vec3d{1, 0.3, -0.2}))};
}

/// A row of six unequal bodies, thrown about, with the same joint between any two.
struct Row : JointRig {
    explicit Row(JointKind kind) {
        std::uint32_t last = 0;
        for (int i = 0; i < 6; ++i) {
            const double mass = 1 + 0.5 * (i % 3);
            const std::uint32_t body = add_body(mass,
                                                Vec3d{0.02, 0.03, 0.045} * mass,
                                                {0.5 * i + 0.25, 0.05 * (i % 2), 0},
                                                glm::angleAxis(0.3 * i, Vec3d{0, 1, 0}));
            add_joint(body, last, def_of(kind, {0.5 * i, 0, 0}));
            last = body;
        }
        bodies[6].velocity_mps = {0, 1, 3};
    }
};

class EveryJointKind : public testing::TestWithParam<JointKind> {};
INSTANTIATE_TEST_SUITE_P(Kinds,
                         EveryJointKind,
                         testing::Values(JointKind::BallAndSocket,
                                         JointKind::Hinge,
                                         JointKind::Slider,
                                         JointKind::Fixed,
                                         JointKind::Cone,
                                         JointKind::Distance));

TEST_P(EveryJointKind, HoldsWhileThrownAbout) {
    Row row(GetParam());
    double worst = 0;
    for (int i = 0; i < 600; ++i) {
        row.step(kFrame_s, 4);
        worst = std::max(worst, row.max_error());
    }
    EXPECT_LT(worst, 1e-6);
    EXPECT_TRUE(std::isfinite(row.energy()));
}

TEST_P(EveryJointKind, KeepsItsEnergy) {
    Row row(GetParam());
    row.step(kFrame_s, 4);
    const double start_J = row.energy();
    double worst_J = 0;
    for (int i = 0; i < 300; ++i) {
        row.step(kFrame_s, 8);
        worst_J = std::max(worst_J, std::abs(row.energy() - start_J));
    }
    // Of the weight times the length of the row.
    EXPECT_LT(worst_J / (9 * kG * 3), GetParam() == JointKind::Distance ? 3e-2 : 1e-3);
}

TEST_P(EveryJointKind, FarFromTheOriginIsTheSame) {
    Row near(GetParam());
    Row far(GetParam());
    const Vec3d shift{1e5, 0, -1e5};
    for (SolverBody& body : far.bodies) body.start_position_m += shift;
    near.run(0.5, kFrame_s, 4);
    far.run(0.5, kFrame_s, 4);
    for (std::uint32_t i = 1; i < near.bodies.size(); ++i) {
        EXPECT_LT(glm::length(far.position(i) - shift - near.position(i)), kFloat32 ? 2e-4 : 1e-6);
    }
}

TEST(JointKinds, FixedBodiesTurnAsOne) {
    // Two cubes side by side are a box 2x1x1; its spin about the long axis' side is unstable, so
    // compare early, with the box itself.
    JointRig pair;
    pair.gravity = {0, 0, 0};
    const Vec3d cube(1.0 / 6);
    const std::uint32_t a = pair.add_body(1, cube, {-0.5, 0, 0});
    const std::uint32_t b = pair.add_body(1, cube, {0.5, 0, 0});
    pair.add_joint(a, b, {.kind = JointKind::Fixed});
    const Vec3d spin{2, 1, 0.5};
    pair.bodies[a].spin_radps = Vec3(spin);
    pair.bodies[b].spin_radps = Vec3(spin);
    pair.bodies[a].velocity_mps = Vec3(glm::cross(spin, Vec3d{-0.5, 0, 0}));
    pair.bodies[b].velocity_mps = Vec3(glm::cross(spin, Vec3d{0.5, 0, 0}));
    JointRig one;
    one.gravity = {0, 0, 0};
    const std::uint32_t box = one.add_body(2, {1.0 / 3, 5.0 / 6, 5.0 / 6}, {0, 0, 0});
    one.bodies[box].spin_radps = Vec3(spin);
    pair.run(2, kFrame_s, 8);
    one.run(2, kFrame_s, 8);
    const Quatd apart = glm::conjugate(one.orientation(box)) * pair.orientation(a);
    EXPECT_LT(2 * std::hypot(apart.x, apart.y, apart.z), 3e-4);
    EXPECT_LT(pair.max_error(), 1e-8);
}

TEST(JointKinds, CantileverBearsForceAndMoment) {
    JointRig rig;
    const std::uint32_t beam = rig.add_body(3, {0.01, 1, 1}, {1, 0, 0});
    rig.add_joint(beam, 0, {.kind = JointKind::Fixed, .anchor_a_world = {0, 0, 0}});
    rig.run(1, kFrame_s, 4);
    EXPECT_NEAR(rig.joints[0].total_impulse_Ns.y / kFrame_s, 3 * kG, 1e-4);
    EXPECT_NEAR(rig.joints[0].total_angular_impulse_Nms.z / kFrame_s, 3 * kG, 1e-4);
    EXPECT_LT(rig.max_speed(), 1e-6);
}

TEST(JointKinds, KinematicBodyCarriesWhatHangsOnIt) {
    JointRig rig;
    const std::uint32_t hand = rig.add_body(0, Vec3d(0), {0, 0, 0});
    const std::uint32_t ball = rig.add_ball_body(1, 0.1, {0, -1, 0});
    rig.add_ball(ball, hand, {0, 0, 0});
    rig.bodies[hand].velocity_mps = {2, 0, 0};
    rig.bodies[ball].velocity_mps = {2, 0, 0};
    rig.run(2, kFrame_s, 4);
    EXPECT_NEAR(rig.position(ball).x, 4, 1e-4);
    EXPECT_NEAR(rig.position(ball).y, -1, 1e-5);
    EXPECT_LT(rig.max_error(), 1e-7);
    // Turning: a fixed joint on a turntable.
    JointRig table;
    table.gravity = {0, 0, 0};
    const std::uint32_t plate = table.add_body(0, Vec3d(0), {0, 0, 0});
    const std::uint32_t box = table.add_body(1, Vec3d(0.1), {1, 0, 0});
    table.add_joint(box, plate, {.kind = JointKind::Fixed});
    table.bodies[plate].spin_radps = {0, 3, 0};
    table.run(1, kFrame_s, 4);
    EXPECT_NEAR(table.position(box).x, std::cos(3.0), 1e-4);
    EXPECT_NEAR(table.position(box).z, -std::sin(3.0), 1e-4);
    EXPECT_LT(table.max_error(), 1e-5);
}

class JointKindsAtSubsteps : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Substeps, JointKindsAtSubsteps, testing::Values(1, 4));

TEST_P(JointKindsAtSubsteps, AnchorsFiveMetresApartCloseWithinTwoSeconds) {
    for (const JointKind kind : {JointKind::BallAndSocket, JointKind::Fixed}) {
        JointRig rig;
        const std::uint32_t body = rig.add_body(1, {0.05, 0.1, 0.12}, {5, 0, 0});
        SolverJoint& joint =
            rig.add_joint(body, 0, {.kind = kind, .anchor_a_world = {4.5_r, 0.3_r, 0}});
        rig.place_anchors(joint, {4.5, 0.3, 0}, {0, 0, 0});
        Vec3d last = rig.position(body);
        for (int i = 0; i < 120; ++i) {
            rig.step(kFrame_s, GetParam());
            EXPECT_LT(rig.max_speed(), 10);
            EXPECT_LT(glm::length(rig.position(body) - last) / kFrame_s, 10);
            last = rig.position(body);
        }
        EXPECT_LT(rig.max_error(), 1e-5);
    }
}

TEST_P(JointKindsAtSubsteps, TurnedAwayByHalfATurnComesBack) {
    for (const JointKind kind : {JointKind::Hinge, JointKind::Fixed, JointKind::Slider}) {
        JointRig rig;
        rig.gravity = {0, 0, 0};
        const std::uint32_t body = rig.add_body(1, {0.05, 0.1, 0.12}, {0.5, 0, 0});
        SolverJoint& joint = rig.add_joint(body, 0, {.kind = kind, .axis_world = {1, 0, 0}});
        joint.frame_in_a = glm::angleAxis(glm::pi<double>(), Vec3d{0, 0, 1}) * joint.frame_in_a;
        for (int i = 0; i < 180; ++i) {
            rig.step(kFrame_s, GetParam());
            EXPECT_LT(rig.max_speed(), 1);
        }
        EXPECT_LT(rig.max_error(), 1e-5);
    }
}

TEST_P(JointKindsAtSubsteps, ConeWithOppositeAxesComesBack) {
    JointRig rig;
    rig.gravity = {0, 0, 0};
    const std::uint32_t body = rig.add_body(1, {0.05, 0.1, 0.12}, {0.5, 0, 0});
    SolverJoint& joint = rig.add_joint(body,
                                       0,
                                       {.kind = JointKind::Cone,
                                        .axis_world = {1, 0, 0},
                                        .limits = std::array<Real, 2>{0, 0.5_r},
                                        .twist_limits = std::array<Real, 2>{-0.2_r, 0.2_r}});
    joint.frame_in_a = glm::angleAxis(glm::pi<double>(), Vec3d{0, 0, 1}) * joint.frame_in_a;
    for (int i = 0; i < 240; ++i) {
        rig.step(kFrame_s, GetParam());
        ASSERT_TRUE(std::isfinite(rig.max_speed()));
        EXPECT_LT(rig.max_speed(), 10);
    }
    EXPECT_LT(rig.max_error(), 1e-4);
    EXPECT_LT(rig.max_speed(), 1);
}

TEST(JointKinds, UselessJointsDoNothing) {
    JointRig rig;
    const std::uint32_t wall = rig.add_body(0, Vec3d(0), {3, 0, 0});
    const std::uint32_t ball = rig.add_ball_body(1, 0.1, {0, 0, 0});
    rig.add_ball(wall, 0, {1, 0, 0});
    rig.add_ball(ball, ball, {0, 0, 0});
    rig.add_joint(ball, ball, {.kind = JointKind::Spring, .stiffness_Npm = 1e9_r});
    rig.run(1, kFrame_s, 4);
    EXPECT_NEAR(rig.position(ball).y, -0.5 * kG, 1e-4);
    JointRig none;
    none.add_ball_body(1, 0.1, {0, 0, 0});
    none.run(1, kFrame_s, 4);
    EXPECT_NEAR(none.position(1).y, -0.5 * kG, 1e-4);
}

TEST(JointKinds, DistanceOfNothingIsFinite) {
    JointRig rig;
    const std::uint32_t ball = rig.add_ball_body(1, 0.1, {0, 0, 0});
    rig.add_joint(ball, 0, {.kind = JointKind::Distance});
    rig.add_joint(ball, 0, {.kind = JointKind::Spring, .stiffness_Npm = 10});
    rig.run(1, kFrame_s, 4);
    EXPECT_TRUE(std::isfinite(rig.position(ball).y));
}

TEST(JointKinds, SameNumbersWhateverTheSystemSolvedBefore) {
    Row fresh(JointKind::Hinge);
    Row used(JointKind::Hinge);
    Row other(JointKind::Fixed);
    std::swap(other.system, used.system);
    other.run(0.2, kFrame_s, 2);
    std::swap(other.system, used.system);
    for (int i = 0; i < 60; ++i) {
        fresh.step(kFrame_s, 4);
        used.step(kFrame_s, 4);
        std::swap(other.system, used.system);
        other.step(kFrame_s, 2);
        std::swap(other.system, used.system);
    }
    for (std::uint32_t i = 1; i < fresh.bodies.size(); ++i) {
        EXPECT_EQ(fresh.position(i), used.position(i));
        EXPECT_EQ(fresh.velocity(i), used.velocity(i));
    }
}

TEST(JointKinds, SettledStepsAllocateNothing) {
    Row row(JointKind::Hinge);
    row.add_joint(
        6, 0, {.kind = JointKind::Spring, .anchor_a_world = {3, 0, 0}, .stiffness_Npm = 1e6_r});
    row.run(0.2, kFrame_s, 4);
    const std::size_t before = allocations();
    row.run(1, kFrame_s, 4);
    EXPECT_EQ(allocations(), before);
}

}  // namespace
}  // namespace plumbline::physics
