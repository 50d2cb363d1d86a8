// Friction of a contact that turns a body differently along each of its two directions.
#include "engine/physics/dynamics/contact/contact_set.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::physics {
namespace {

/// A body that slides over the world with one contact beside its centre.
struct Sliding {
    std::vector<SolverBody> bodies{2};
    ContactSet contacts;

    Sliding(const Vec3& velocity_mps, Real friction) {
        SolverBody& body = bodies[1];
        body.inverse_mass = 1;
        body.inverse_inertia = {.xx = 1, .xy = 0.5_r, .yy = 2, .zz = 9};
        body.velocity_mps = velocity_mps;
        ContactConstraint constraint;
        constraint.a = 1;
        constraint.normal = {0, 1, 0};
        constraint.tangent[0] = {1, 0, 0};
        constraint.tangent[1] = {0, 0, 1};
        constraint.count = 1;
        constraint.friction = friction;
        constraint.start_separation_m[0] = 0;
        constraint.normal_Ns[0] = 0.01_r;
        set_lane(constraint.offset_a, 0, {0, -0.5_r, 0});
        contacts.constraints.push_back(constraint);
        contacts.begin_step(bodies, {});
    }
    Vec3d slip() const { return Vec3d(bodies[1].velocity_at({0, -0.5_r, 0})); }
    Vec3d friction_Ns() const {
        const ContactConstraint& constraint = contacts.constraints[0];
        return Vec3d(constraint.tangent[0] * constraint.tangent_Ns[0] +
                     constraint.tangent[1] * constraint.tangent_Ns[1]);
    }
};

TEST(ContactFriction, ActsStraightAgainstTheSlipAtEveryHeading) {
    for (int i = 0; i < 24; ++i) {
        const Real heading_rad = static_cast<Real>(i) * kPi / 12;
        Sliding body({5 * std::cos(heading_rad), 0, 5 * std::sin(heading_rad)}, 0.5_r);
        const Vec3d before = glm::normalize(body.slip());
        body.contacts.relax(ContactSet::Sweep::All);
        const Vec3d friction_Ns = body.friction_Ns();
        EXPECT_NEAR(glm::length(friction_Ns), 0.5 * 0.01, 1e-6) << i;
        EXPECT_NEAR(glm::dot(glm::normalize(friction_Ns), before), -1, 1e-5) << i;
    }
}

TEST(ContactFriction, StopsInOneSweepWhatSticks) {
    Sliding body({0.001_r, 0, 0.002_r}, 10);
    body.contacts.relax(ContactSet::Sweep::All);
    EXPECT_NEAR(body.slip().x, 0, 1e-8);
    EXPECT_NEAR(body.slip().z, 0, 1e-8);
    EXPECT_LT(glm::length(body.friction_Ns()), 10 * 0.01);
}

// What turns about the normal faster than friction can stop gives up its twist, and not what holds it sideways.
TEST(ContactFriction, ASpinThatNothingStopsLeavesTheForceThatHolds) {
    Sliding body({0.002_r, 0, 0}, 0.5_r);
    ContactConstraint& contact = body.contacts.constraints[0];
    contact.count = 2;
    contact.normal_Ns[1] = contact.normal_Ns[0];
    set_lane(contact.offset_a, 0, {0, -0.5_r, 0.01_r});
    set_lane(contact.offset_a, 1, {0, -0.5_r, -0.01_r});
    body.bodies[1].inverse_inertia = {.xx = 1, .yy = 1, .zz = 1};
    body.contacts.begin_step(body.bodies, {});
    for (int sweep = 0; sweep < 10; ++sweep) {
        body.bodies[1].spin_radps.y = 3;
        body.bodies[1].velocity_mps.x -= 0.0002_r;  // a steady pull
        body.contacts.relax(ContactSet::Sweep::All);
    }
    const Vec3d friction_Ns = body.friction_Ns();
    EXPECT_LT(std::abs(body.slip().x), 2e-4);
    EXPECT_GT(std::abs(contact.twist_Nms), 0.9 * 0.01 * 0.01 * 0.5 * 2);
    EXPECT_LE(glm::length(friction_Ns), 0.5 * 0.02);
}

TEST(ContactFriction, WithoutALoadNothingHolds) {
    Sliding body({1, 0, 1}, 0);
    body.contacts.constraints[0].twist_Nms = 1e-3_r;
    body.contacts.relax(ContactSet::Sweep::All);
    EXPECT_EQ(body.friction_Ns(), (Vec3d{0, 0, 0}));
    EXPECT_TRUE(std::isfinite(body.contacts.constraints[0].twist_Nms));
}

}  // namespace
}  // namespace plumbline::physics
