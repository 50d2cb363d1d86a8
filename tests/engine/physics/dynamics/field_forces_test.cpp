// Fields in sub-steps: what they push, in which order, and what is counted of it.
#include "engine/physics/dynamics/field_forces.h"

#include "tests/engine/physics/test_world.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace plumbline::physics {
namespace {

/// A spring to the origin for the bodies that it is told of.
class Spring final : public ForceField {
public:
    Spring(double stiffness, std::vector<BodyId> bodies)
        : stiffness_(stiffness), bodies_(std::move(bodies)) {}
    bool acts_on(BodyId body) const override {
        return std::ranges::find(bodies_, body) != bodies_.end();
    }
    void act(std::span<BodyInField* const> bodies, const FieldTime& time) override {
        for (BodyInField* body : bodies)
            body->impulse_Ns -= body->center_m * (stiffness_ * time.h_s);
        asked_ += static_cast<int>(bodies.size());
        in_one_call_ = std::max(in_one_call_, static_cast<int>(bodies.size()));
    }
    void list_pairs(std::vector<Pair>& pairs) const override {
        if (ties_) pairs.emplace_back(bodies_[0], bodies_[1]);
    }
    int substeps() const override { return substeps_; }
    bool carries() const override { return carries_; }
    double added_mass_kg(BodyId) const override { return added_kg_; }

    double stiffness_;
    std::vector<BodyId> bodies_;
    int asked_{0};
    int in_one_call_{0};
    int substeps_{4};
    bool ties_{false};
    bool carries_{false};
    double added_kg_{0};
};

BodyDef kilogram() {
    return {.kind = BodyKind::Dynamic, .mass_kg = 1};
}

/// 1 kg on 100 N/m swings with 10 rad/s.
double error_after_m(int substeps, double seconds) {
    TestWorld test(WorldDef{.gravity_mps2 = {0, 0, 0}});
    const BodyId ball = test.add(SphereShape{0.1_r}, {1, 0, 0}, kilogram());
    Spring spring(100, {ball});
    spring.substeps_ = substeps;
    std::array<ForceField*, 1> fields{&spring};
    double time_s = 0;
    while (time_s < seconds - 1e-9) {
        test.world.step(fields);
        time_s += test.world.def().step_s;
    }
    return std::abs(test.at(ball).x - std::cos(10 * time_s));
}

TEST(FieldForces, AreOfSecondOrder) {
    const double coarse = error_after_m(2, 1.0);
    const double fine = error_after_m(8, 1.0);
    EXPECT_LT(coarse, 0.01);
    EXPECT_GT(std::log(coarse / fine) / std::log(4.0), 1.8) << coarse << " " << fine;
}

TEST(FieldForces, KeepEnergyForAMinute) {
    TestWorld test(WorldDef{.gravity_mps2 = {0, 0, 0}});
    const BodyId ball = test.add(SphereShape{0.1_r}, {1, 0, 0}, kilogram());
    Spring spring(100, {ball});
    std::array<ForceField*, 1> fields{&spring};
    double most = 0;
    double least = 1e9;
    for (int i = 0; i < 3600; ++i) {
        test.world.step(fields);
        const Vec3d v(test.world.state(ball).velocity_mps);
        const double energy = 0.5 * glm::dot(v, v) + 50 * glm::dot(test.at(ball), test.at(ball));
        most = std::max(most, energy);
        least = std::min(least, energy);
    }
    EXPECT_NEAR(most, 50, 0.1);
    EXPECT_NEAR(least, 50, 0.1);
}

TEST(FieldForces, AskOnlyOfThoseThatTheyActOn) {
    TestWorld test(WorldDef{.gravity_mps2 = {0, 0, 0}});
    const BodyId pulled = test.add(SphereShape{0.1_r}, {1, 0, 0}, kilogram());
    const BodyId other = test.add(SphereShape{0.1_r}, {3, 0, 0}, kilogram());
    Spring spring(100, {pulled});
    std::array<ForceField*, 1> fields{&spring};
    test.world.step(fields);
    EXPECT_EQ(spring.asked_, 4) << "once a sub-step";
    EXPECT_EQ(test.world.state(other).velocity_mps.x, 0);
    EXPECT_LT(test.world.state(pulled).velocity_mps.x, 0);
    EXPECT_EQ(test.world.report().islands.size(), 1U);
    EXPECT_EQ(test.world.report().islands.front().reason, "field");
}

TEST(FieldForces, TiesAreSolvedTogether) {
    TestWorld test(WorldDef{.gravity_mps2 = {0, 0, 0}});
    Spring spring(100,
                  {test.add(SphereShape{0.1_r}, {1, 0, 0}, kilogram()),
                   test.add(SphereShape{0.1_r}, {3, 0, 0}, kilogram())});
    std::array<ForceField*, 1> fields{&spring};
    test.world.step(fields);
    EXPECT_EQ(spring.in_one_call_, 1);
    spring.ties_ = true;
    test.world.step(fields);
    EXPECT_EQ(spring.in_one_call_, 2);
}

TEST(FieldForces, MassThatMovesAlongIsMovedToo) {
    TestWorld test;
    const BodyId ball = test.add(SphereShape{0.1_r}, {0, 0, 0}, kilogram());
    Spring none(0, {ball});
    none.added_kg_ = 1;
    std::array<ForceField*, 1> fields{&none};
    test.world.step(fields);
    EXPECT_NEAR(static_cast<double>(test.world.state(ball).velocity_mps.y), -kG / 2 / 60, 1e-6);
}

/// A floor of springs: bodies come to rest on a field that carries, and on no other.
TEST(FieldForces, BodiesSleepOnWhatCarries) {
    for (const bool carries : {false, true}) {
        TestWorld test;
        const BodyId ball =
            test.add(SphereShape{0.1_r},
                     {0, static_cast<Real>(-kG / 100), 0},
                     {.kind = BodyKind::Dynamic, .mass_kg = 1, .linear_damping_per_s = 2});
        Spring spring(100, {ball});
        spring.carries_ = carries;
        std::array<ForceField*, 1> fields{&spring};
        for (int i = 0; i < 300; ++i) test.world.step(fields);
        EXPECT_EQ(test.world.state(ball).awake, !carries);
        const int asked = spring.asked_;
        for (int i = 0; i < 60; ++i) test.world.step(fields);
        if (carries) {
            EXPECT_EQ(spring.asked_, asked) << "what sleeps costs nothing";
        }
    }
}

TEST(FieldForces, BulletsSolversAreAskedOnceAStep) {
    TestWorld test(WorldDef{.gravity_mps2 = {0, 0, 0}, .solver = Solver::BulletSi});
    const BodyId ball = test.add(SphereShape{0.1_r}, {1, 0, 0}, kilogram());
    Spring spring(100, {ball});
    std::array<ForceField*, 1> fields{&spring};
    double time_s = 0;
    for (int i = 0; i < 30; ++i, time_s += 1.0 / 60) test.world.step(fields);
    EXPECT_EQ(spring.asked_, 30);
    EXPECT_NEAR(test.at(ball).x, std::cos(10 * time_s), 0.1);
}

TEST(FieldMask, HasABitForEachOfTheFirst32) {
    TestWorld test;
    const BodyId ball = test.add(SphereShape{0.1_r}, {0, 0, 0}, kilogram());
    Spring acts(1, {ball});
    Spring idle(1, {});
    std::vector<ForceField*> fields(40, &idle);
    fields[3] = fields[31] = fields[35] = &acts;
    EXPECT_EQ(field_mask(fields, ball), 0x80000008U);
    EXPECT_EQ(field_mask({}, ball), 0U);
}

}  // namespace
}  // namespace plumbline::physics
