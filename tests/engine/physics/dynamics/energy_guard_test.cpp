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

    void begin() { guard.begin(bodies, contacts, {}, 1.0_r / 240); }
    double end() { return guard.end(bodies, std::span<const SolverJoint>{}, 1.0 / 60); }
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

}  // namespace
}  // namespace plumbline::physics
