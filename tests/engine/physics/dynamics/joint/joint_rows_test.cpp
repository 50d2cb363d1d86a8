#include "engine/physics/dynamics/joint/joint_rows.h"

#include "tests/engine/physics/dynamics/joint/joint_rig.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace plumbline::physics {
namespace {

/// Two bodies askew, and the rows of a joint between them.
struct TwoBodies {
    std::vector<SolverBody> solver{2};
    std::vector<JointBody> bodies;
    std::vector<JointRows> rows;

    TwoBodies(const JointDef& def, const Quatd& turned) {
        const Vec3d inertia[2] = {{0.2, 0.3, 0.4}, {0.5, 0.7, 0.6}};
        for (std::size_t i = 0; i < 2; ++i) {
            solver[i].inverse_mass = Real{1} / static_cast<Real>(i + 1);
            solver[i].inertia_kgm2 = inertia[i];
            solver[i].isotropic_inertia = false;
            solver[i].start_position_m = i == 0 ? Vec3d{0.1, 0.2, 0.3} : Vec3d{1.1, -0.3, 0.4};
            solver[i].start_orientation = glm::angleAxis(0.4 + 0.3 * static_cast<double>(i),
                                                         glm::normalize(Vec3d{1, 2, -0.5}));
        }
        const auto pose = [&](std::size_t i) {
            return MassPose{solver[i].start_position_m, solver[i].start_orientation};
        };
        SolverJoint joint = placed_joint(def, pose(0), pose(1));
        joint.a = 0;
        joint.b = 1;
        // Away from where it was made, so that every row has an error.
        solver[1].start_orientation = glm::normalize(turned * solver[1].start_orientation);
        solver[1].start_position_m += Vec3d{0.03, -0.02, 0.05};
        const JointForm form = form_of(joint, false);
        for (const NodeKind kind : {form.places, form.turns}) {
            if (kind == NodeKind::None) continue;
            rows.push_back(JointRows::of({.joint = 0, .a = 0, .b = 1, .kind = kind}, joint));
        }
        for (SolverBody& body : solver) {
            bodies.push_back(JointBody::of(body));
            bodies.back().read_pose();
            bodies.back().update_inertia();
        }
        for (JointRows& row : rows) row.refresh(bodies);
    }
    void move(std::size_t body, const Vec3d& along, const Vec3d& turn) {
        JointBody& moved = bodies[body];
        moved.position_m += along;
        const double angle = glm::length(turn);
        if (angle > 0)
            moved.orientation =
                glm::normalize(glm::angleAxis(angle, turn / angle) * moved.orientation);
        moved.axes = rows_of(moved.orientation);
    }
};

JointDef def_of_rows(JointKind kind) {
    return {.kind = kind,
            .anchor_a_world = {0.6_r, 0, 0.1_r},
            .anchor_b_world = {0.7_r, 0.4_r, 0.1_r},
            .axis_world = glm::normalize(Vec3{1, 0.3_r, -0.2_r})};
}

class JointRowsOf : public testing::TestWithParam<JointKind> {};
INSTANTIATE_TEST_SUITE_P(Kinds,
                         JointRowsOf,
                         testing::Values(JointKind::BallAndSocket,
                                         JointKind::Hinge,
                                         JointKind::Slider,
                                         JointKind::Fixed,
                                         JointKind::Distance));

// J v is the rate of the errors: exactly for rows that are of places, to the order of the error where
// turns are axis times angle.
TEST_P(JointRowsOf, SpeedsAreTheRateOfTheErrors) {
    const Quatd turned = glm::angleAxis(0.01, glm::normalize(Vec3d{0.3, -1, 0.4}));
    TwoBodies two(def_of_rows(GetParam()), turned);
    two.bodies[0].velocity_mps = {0.3, -0.5, 0.2};
    two.bodies[0].spin_radps = {0.7, 0.1, -0.4};
    two.bodies[1].velocity_mps = {-0.1, 0.4, 0.6};
    two.bodies[1].spin_radps = {-0.2, 0.5, 0.3};
    constexpr double kStep_s = 1e-5;
    for (std::size_t i = 0; i < two.rows.size(); ++i) {
        TwoBodies before = two;
        TwoBodies after = two;
        for (std::size_t k = 0; k < 2; ++k) {
            const JointBody& body = two.bodies[k];
            before.move(k, -body.velocity_mps * kStep_s, -body.spin_radps * kStep_s);
            after.move(k, body.velocity_mps * kStep_s, body.spin_radps * kStep_s);
        }
        const JointRows& rows = two.rows[i];
        const Vec3d rate = (rows.errors(after.bodies) - rows.errors(before.bodies)) / (2 * kStep_s);
        const Vec3d speeds = rows.speeds(two.bodies);
        for (int k = 0; k < 3; ++k) {
            if (!rows.is_active(k)) continue;
            EXPECT_NEAR(speeds[k], rate[k], 0.02) << "node " << i << " row " << k;
        }
    }
}

// A push along the rows changes their speeds by the diagonal's block, and no momentum.
TEST_P(JointRowsOf, APushChangesTheSpeedsByTheOwnCoupling) {
    TwoBodies two(def_of_rows(GetParam()), Quatd{1, 0, 0, 0});
    for (const JointRows& rows : two.rows) {
        std::vector<JointBody> bodies = two.bodies;
        Vec3d impulse{0, 0, 0};
        for (int k = 0; k < 3; ++k) impulse[k] = rows.is_active(k) ? 0.5 + k : 0.0;
        rows.push(bodies, impulse);
        const Vec3d gained = rows.speeds(bodies);
        const Vec3d wanted = own_coupling(rows, bodies) * impulse;
        for (int k = 0; k < 3; ++k) {
            if (rows.is_active(k)) {
                EXPECT_NEAR(gained[k], wanted[k], 1e-6) << k;
            }
        }
        const Vec3d momentum = bodies[0].velocity_mps * 1.0 + bodies[1].velocity_mps * 2.0;
        EXPECT_NEAR(glm::length(momentum), 0, 1e-6);
        EXPECT_NEAR(glm::length(rows.force_on_a(impulse) - bodies[0].velocity_mps), 0, 1e-6);
    }
}

// Twist is read by the shortest swing; beyond 172 degrees of swing it means nothing.
TEST(JointRows, TwistHasNoPositionWhereTheAxesAreOpposite) {
    JointDef cone = def_of_rows(JointKind::Cone);
    cone.limits = {0, 3};
    cone.twist_limits = {-1, 1};
    for (const double degrees : {0.0, 171.0, 173.0, 180.0}) {
        const Vec3d axis{cone.axis_world};
        const Vec3d across = glm::normalize(glm::cross(axis, Vec3d{0, 1, 0}));
        TwoBodies two(cone, glm::angleAxis(radians_from_degrees(degrees), across));
        EXPECT_TRUE(two.rows[1].has_position(0, two.bodies));
        EXPECT_EQ(two.rows[1].has_position(2, two.bodies), degrees < 172) << degrees;
        EXPECT_NEAR(two.rows[1].errors(two.bodies).x, radians_from_degrees(degrees), 1e-5);
    }
    cone.limits = {0, 0};
    const TwoBodies shut(cone, Quatd{1, 0, 0, 0});
    EXPECT_TRUE(shut.rows[1].fixed_swing) << "a cone without opening holds like a hinge";
    EXPECT_EQ(shut.rows[1].active, 0b011);
}

}  // namespace
}  // namespace plumbline::physics
