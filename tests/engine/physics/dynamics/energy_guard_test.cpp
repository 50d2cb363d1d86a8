#include "engine/physics/dynamics/energy_guard.h"

#include <gtest/gtest.h>

namespace plumbline::physics {
namespace {

SolverBody ball_of(Real mass_kg, const Vec3& velocity_mps) {
    SolverBody body;
    body.inverse_mass = 1 / mass_kg;
    body.velocity_mps = velocity_mps;
    body.inertia_kgm2 = Vec3d(0.4 * static_cast<double>(mass_kg));
    return body;
}

/// Two balls that touch each other; the world is the first body.
struct TwoBodies {
    std::vector<SolverBody> bodies{SolverBody{}, ball_of(2, {3, 0, 0}), ball_of(1, {-1, 0, 0})};
    std::vector<ContactConstraint> contacts{ContactConstraint{.a = 1, .b = 2, .count = 1}};
    EnergyGuard guard;

    void begin() { guard.begin(bodies, contacts, {}, 0, 1.0_r / 240); }
    double end() { return guard.end(bodies, std::span<const SolverJoint>{}, {}, 1.0 / 60); }
    double energy_J() const {
        double sum = 0;
        for (const SolverBody& body : bodies) {
            if (!body.movable()) continue;
            sum += 0.5 / static_cast<double>(body.inverse_mass) *
                   static_cast<double>(glm::dot(body.velocity_mps, body.velocity_mps));
        }
        return sum;
    }
    Vec3 momentum() const {
        return bodies[1].velocity_mps / bodies[1].inverse_mass +
               bodies[2].velocity_mps / bodies[2].inverse_mass;
    }
};

TEST(EnergyGuard, LetsAnElasticBlowPass) {
    TwoBodies pair;
    pair.begin();
    const double before = pair.energy_J();
    // Relative speed 4 is turned round: v1 = 1/3, v2 = 13/3.
    pair.bodies[1].velocity_mps = {1.0_r / 3, 0, 0};
    pair.bodies[2].velocity_mps = {13.0_r / 3, 0, 0};
    EXPECT_EQ(pair.end(), 0);
    EXPECT_NEAR(pair.energy_J(), before, 1e-5);
}

TEST(EnergyGuard, TakesOutWhatNothingGaveAndKeepsMomentum) {
    TwoBodies pair;
    pair.begin();
    const double before = pair.energy_J();
    const Vec3 momentum = pair.momentum();
    pair.bodies[1].velocity_mps = {-20, 0, 0};
    pair.bodies[2].velocity_mps = {45, 0, 0};
    const double too_much = pair.energy_J();
    const double taken = pair.end();
    EXPECT_NEAR(pair.energy_J(), before, 0.01 * before);
    EXPECT_NEAR(taken, too_much - pair.energy_J(), 1e-3) << "it says how much it took";
    EXPECT_LT(glm::distance(pair.momentum(), momentum), 1e-4_r);
}

TEST(EnergyGuard, KnowsTheWorkOfGravity) {
    TwoBodies pair;
    pair.contacts.push_back({.a = 1, .b = kWorldBody, .count = 1});
    pair.bodies[1].velocity_mps = pair.bodies[2].velocity_mps = {0, 0, 0};
    for (SolverBody& body : pair.bodies) body.acceleration_mps2 = {0, -9.81_r, 0};
    pair.begin();
    for (std::size_t i : {1U, 2U}) {
        // Fell 2 m from rest.
        pair.bodies[i].delta_position_m = {0, -2, 0};
        pair.bodies[i].velocity_mps = {0, -std::sqrt(2 * 9.81_r * 2), 0};
    }
    EXPECT_EQ(pair.end(), 0);
    pair.bodies[1].velocity_mps.y *= 1.2_r;
    EXPECT_GT(pair.end(), 0);
}

TEST(EnergyGuard, LeavesWhatAMachineDrivesAlone) {
    TwoBodies pair;
    pair.contacts.push_back({.a = 1, .b = kWorldBody, .count = 1});
    pair.bodies[kWorldBody].velocity_mps = {0, 3, 0};  // a lift
    pair.begin();
    pair.bodies[1].velocity_mps = {0, 30, 0};
    EXPECT_EQ(pair.end(), 0);
}

/// A ball of 2 kg that a joint holds at the world's origin, 1 m above it, at 3 m/s.
struct Pendulum {
    std::vector<SolverBody> bodies{SolverBody{}, ball_of(2, {3, 0, 0})};
    std::vector<SolverJoint> joints{
        SolverJoint{.a = 1, .b = kWorldBody, .anchor_in_a = {0, -1, 0}}};
    EnergyGuard guard;

    /// The energy that a step which keeps so much of the speed leaves, of its start's.
    double left(Real kept, double joint_speed = 0) {
        guard.begin(bodies, {}, joints, joint_speed, 1.0_r / 240);
        bodies[1].velocity_mps *= kept;
        taken_J = guard.end(bodies, joints, {}, 1.0 / 60);
        const double speed = static_cast<double>(bodies[1].velocity_mps.x) / 3;
        return speed * speed;
    }
    double taken_J{0};
};

TEST(EnergyGuard, GivesBackWhatIdealJointsLost) {
    EXPECT_NEAR(Pendulum().left(0.9_r), 1, 1e-6);
    Pendulum gained;
    EXPECT_NEAR(gained.left(1.01_r), 1, 1e-6);
    EXPECT_EQ(gained.taken_J, 0) << "no more than the joints' share";
    const double little = 1 - 1e-5;
    EXPECT_NEAR(Pendulum().left(static_cast<Real>(little)), little * little, 1e-6)
        << "what swings and comes back is left alone";
}

TEST(EnergyGuard, KnowsTheWorkOfGravityOnJoints) {
    Pendulum rising;
    rising.bodies[1].acceleration_mps2 = {0, -10, 0};
    rising.guard.begin(rising.bodies, {}, rising.joints, 0, 1.0_r / 240);
    rising.bodies[1].delta_position_m = {0, 0.2_r, 0};  // 4 J of 9
    rising.bodies[1].velocity_mps *= 0.5_r;
    EXPECT_EQ(rising.guard.end(rising.bodies, rising.joints, {}, 1.0 / 60), 0);
    EXPECT_NEAR(rising.bodies[1].velocity_mps.x, std::sqrt(5.0), 1e-5);
}

TEST(EnergyGuard, GivesNothingBackWhereEnergyMayGo) {
    const Real kept = 0.9_r;
    const double left = static_cast<double>(kept) * static_cast<double>(kept);
    EXPECT_NEAR(Pendulum().left(kept, 0.1), left, 1e-6) << "a joint that was just hit";
    Pendulum damped;
    damped.bodies[1].angular_damping_factor = 0.99_r;
    EXPECT_NEAR(damped.left(kept), left, 1e-6);
    Pendulum limited;
    limited.joints[0].limits = {{-1, 1}};
    EXPECT_NEAR(limited.left(kept), left, 1e-6);
    Pendulum sprung;
    sprung.joints[0].kind = JointKind::Spring;
    EXPECT_NEAR(sprung.left(kept), left, 1e-6);
    Pendulum stopped;
    EXPECT_NEAR(stopped.left(0.1_r), 0.04, 1e-6) << "four times what is left at most";
}

/// Scaled, it would keep its energy and not its angular momentum.
TEST(EnergyGuard, GivesNothingBackToWhatIsHeldByNothing) {
    TwoBodies pair;
    pair.bodies[1].velocity_mps = {1, 0, 0};
    pair.bodies[2].velocity_mps = {-2, 0, 0};
    const std::vector<SolverJoint> joints{SolverJoint{.a = 1, .b = 2}};
    pair.guard.begin(pair.bodies, {}, joints, 0, 1.0_r / 240);
    for (SolverBody& body : pair.bodies) body.velocity_mps *= 0.9_r;
    pair.guard.end(pair.bodies, joints, {}, 1.0 / 60);
    EXPECT_NEAR(pair.bodies[1].velocity_mps.x, 0.9, 1e-6);
}

}  // namespace
}  // namespace plumbline::physics
