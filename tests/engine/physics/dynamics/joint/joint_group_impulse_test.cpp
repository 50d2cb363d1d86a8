// What an impulse meets in bodies that joints hold together, beside closed forms.
#include "engine/physics/dynamics/joint/joint_group.h"
#include "tests/engine/physics/dynamics/joint/joint_rig.h"

#include <gtest/gtest.h>

namespace plumbline::physics {
namespace {

constexpr double kNear = 1e-6;  // rows give way by a share of 1e-9

double inverse_mass_along(JointSystem& system, const ImpulseLine& line) {
    double change = 0;
    system.respond(line, {&line, 1}, {&change, 1});
    return change;
}

/// Balls of 2 and 3 kg a metre apart along x, held together in the middle, and one of 5 kg alone.
struct Dumbbell : JointRig {
    explicit Dumbbell(JointKind kind) {
        left = add_ball_body(2, 0.1, {-0.5, 0, 0});
        right = add_ball_body(3, 0.1, {0.5, 0, 0});
        alone = add_ball_body(5, 0.1, {0, 3, 0});
        joints.push_back({.kind = kind,
                          .a = left,
                          .b = right,
                          .anchor_in_a = {0.5, 0, 0},
                          .anchor_in_b = {-0.5, 0, 0}});
        for (SolverBody& body : bodies) body.inverse_inertia = inverse_inertia_of(body);
        system.start(bodies, joints, 0.01, method);
    }
    static SymmetricMat3 inverse_inertia_of(const SolverBody& body) {
        const Real inverse = body.movable() ? static_cast<Real>(1 / body.inertia_kgm2.x) : Real{0};
        return {.xx = inverse, .yy = inverse, .zz = inverse};
    }
    double along(std::uint32_t a, std::uint32_t b, const Vec3& direction) {
        return inverse_mass_along(system, {.a = a, .b = b, .direction = direction});
    }
    std::uint32_t left{0};
    std::uint32_t right{0};
    std::uint32_t alone{0};
};

TEST(JointGroupImpulse, KnowsWhatHangsTogether) {
    Dumbbell rig(JointKind::BallAndSocket);
    EXPECT_EQ(rig.system.piece_of(rig.left), rig.system.piece_of(rig.right));
    EXPECT_EQ(rig.system.piece_of(rig.alone), JointGroup::kNoPiece);
    EXPECT_EQ(rig.system.piece_of(kWorldBody), JointGroup::kNoPiece) << "immovable";
}

TEST(JointGroupImpulse, AnImpulseAlongARodMeetsBothItsEnds) {
    for (const JointKind kind : {JointKind::BallAndSocket, JointKind::Fixed}) {
        Dumbbell rig(kind);
        EXPECT_NEAR(rig.along(rig.left, kWorldBody, {1, 0, 0}), 1.0 / 5, kNear);
        EXPECT_NEAR(rig.along(rig.left, rig.alone, {1, 0, 0}), 1.0 / 5 + 1.0 / 5, kNear);
        EXPECT_NEAR(rig.along(rig.alone, kWorldBody, {1, 0, 0}), 1.0 / 5, kNear);
        EXPECT_NEAR(rig.along(rig.left, rig.right, {1, 0, 0}), 0, kNear) << "of one piece";
    }
}

TEST(JointGroupImpulse, AcrossItTheStiffOneTurnsAsAWhole) {
    Dumbbell rig(JointKind::Fixed);
    // The common centre is 0.6 m from the lighter ball; moments of both balls and of their distances.
    const double moment_kgm2 = 0.4 * (2 + 3) * 0.01 + 2 * 0.6 * 0.6 + 3 * 0.4 * 0.4;
    EXPECT_NEAR(rig.along(rig.left, kWorldBody, {0, 1, 0}), 1.0 / 5 + 0.36 / moment_kgm2, kNear);
}

TEST(JointGroupImpulse, APendulumGivesWayOnlyAcross) {
    JointRig rig;
    const std::uint32_t ball = rig.add_ball_body(2, 0.1, {0, -1, 0});
    rig.joints.push_back(
        {.kind = JointKind::BallAndSocket, .a = ball, .b = kWorldBody, .anchor_in_a = {0, 1, 0}});
    rig.bodies[ball].inverse_inertia = Dumbbell::inverse_inertia_of(rig.bodies[ball]);
    rig.system.start(rig.bodies, rig.joints, 0.01, rig.method);
    const auto along = [&](const Vec3& direction) {
        return inverse_mass_along(rig.system, {.a = ball, .b = kWorldBody, .direction = direction});
    };
    EXPECT_NEAR(along({0, 1, 0}), 0, kNear);
    EXPECT_NEAR(along({1, 0, 0}), 1 / (2 + 0.4 * 2 * 0.01), kNear);
}

}  // namespace
}  // namespace plumbline::physics
