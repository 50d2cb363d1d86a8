#include "engine/physics/dynamics/contact/contact_constraint.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::physics {
namespace {

/// A cube of 1 m and 2 kg on the ground, with the corners of its bottom as points.
struct CubeOnGround {
    SolverBody cube;
    SolverBody ground;
    ContactConstraint contact;

    explicit CubeOnGround(int points) {
        cube.inverse_mass = 0.5_r;
        const Real inverse = Real{6} / 2;  // 1 / (m s^2 / 6)
        cube.inverse_inertia = {.xx = inverse, .yy = inverse, .zz = inverse};
        contact.a = 1;
        contact.count = points;
        contact.friction = 0.5_r;
        contact.tangent[0] = {1, 0, 0};
        contact.tangent[1] = {0, 0, 1};
        const Vec3 corners[] = {{-0.5_r, -0.5_r, -0.5_r},
                                {0.5_r, -0.5_r, -0.5_r},
                                {0.5_r, -0.5_r, 0.5_r},
                                {-0.5_r, -0.5_r, 0.5_r}};
        for (int i = 0; i < points; ++i) {
            set_lane(contact.offset_a, i, corners[i]);
            set_lane(contact.offset_b, i, corners[i] + Vec3{0, 0.5_r, 0});
        }
    }
    void prepare_rigid() { prepare(contact, cube, ground, {}, 1); }
};

// A corner's: 1/m + |r x n|^2 / I, with |r x n|^2 = 1/2; two corners share 1/m and the product of arms.
TEST(ContactConstraint, ResponsesAreThoseOfARigidBody) {
    CubeOnGround on(4);
    on.prepare_rigid();
    const auto& response = on.contact.response;
    EXPECT_NEAR(static_cast<double>(response[0][0]), 0.5 + 0.5 * 3, 1e-6);
    EXPECT_NEAR(static_cast<double>(response[0][2]), 0.5 - 0.5 * 3, 1e-6) << "across";
    EXPECT_NEAR(static_cast<double>(response[0][1]), 0.5, 1e-6) << "beside";
    EXPECT_TRUE(on.contact.against_immovable);
}

// One point alone: the inverse is the reciprocal; lanes without a point stay out of it.
TEST(ContactConstraint, OnePointHasItsReciprocal) {
    CubeOnGround on(1);
    on.prepare_rigid();
    EXPECT_NEAR(static_cast<double>(on.contact.rigid_mass[0][0]), 1.0 / 2.0, 1e-6);
    EXPECT_EQ(on.contact.rigid_mass[0][1], Real{0});
    EXPECT_EQ(on.contact.rigid_mass[1][1], Real{1});
}

// Friction acts at the centre of the load: the middle of points that carry nothing, else by weight.
TEST(ContactConstraint, FrictionStandsAtTheCentreOfTheLoad) {
    CubeOnGround on(4);
    on.prepare_rigid();
    EXPECT_NEAR(
        static_cast<double>(glm::length(on.contact.center_a - Vec3{0, -0.5_r, 0})), 0, 1e-6);
    EXPECT_NEAR(static_cast<double>(on.contact.twist_arm_m), std::sqrt(0.5), 1e-6);
    // 1/m + |r x t|^2 / I, half a metre below the centre of mass.
    EXPECT_NEAR(static_cast<double>(on.contact.slip_response[0]), 0.5 + 0.25 * 3, 1e-6);
    EXPECT_NEAR(static_cast<double>(on.contact.slip_coupling), 0, 1e-6);
    EXPECT_NEAR(static_cast<double>(on.contact.twist_mass), 1.0 / 3, 1e-6);
    on.contact.normal_Ns = Lanes{3, 1, 0, 0};
    on.prepare_rigid();
    EXPECT_NEAR(
        static_cast<double>(glm::length(on.contact.center_a - Vec3{-0.25_r, -0.5_r, -0.5_r})),
        0,
        1e-6);
    EXPECT_NEAR(static_cast<double>(on.contact.twist_arm_m), 0.75 * 0.25 + 0.25 * 0.75, 1e-6);
    on.contact.friction = 0;
    on.contact.slip_response[0] = -7;
    on.prepare_rigid();
    EXPECT_EQ(on.contact.slip_response[0], Real{-7}) << "smooth: not looked at";
}

}  // namespace
}  // namespace plumbline::physics
