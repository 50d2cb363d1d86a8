// Bodies: made, pushed, frozen, taken out.
#include "engine/physics/totals.h"
#include "tests/engine/physics/test_world.h"

namespace plumbline::physics {
namespace {

TEST(PhysicsWorldBodies, AnImpulseTurnsByTheArmAndMovesByTheMass) {
    TestWorld test(weightless());
    const BodyId cube = test.add(BoxShape{}, {3, 0, 0}, {.kind = BodyKind::Dynamic, .mass_kg = 2});
    test.world.apply_impulse(cube, {0, 4, 0}, Vec3{3.5_r, 0, 0});
    EXPECT_NEAR(glm::length(test.velocity(cube) - Vec3d{0, 2, 0}), 0, 1e-6);
    // m a^2 / 6 = 1/3; the arm times the impulse 2: 6 rad/s.
    EXPECT_NEAR(glm::length(test.spin(cube) - Vec3d{0, 0, 6}), 0, 1e-5);
    test.world.apply_impulse(cube, {0, -4, 0});
    EXPECT_NEAR(test.velocity(cube).y, 0, 1e-6);
    EXPECT_NEAR(test.spin(cube).z, 6, 1e-5) << "at the centre of mass: no turning";
}

TEST(PhysicsWorldBodies, ForcesLastForOneStep) {
    TestWorld test(weightless());
    const BodyId cube = test.add(BoxShape{}, {0, 0, 0}, {.kind = BodyKind::Dynamic, .mass_kg = 2});
    test.world.apply_force(cube, {0, 6, 0}, Vec3{0.5_r, 0, 0});
    test.world.step();
    EXPECT_NEAR(test.velocity(cube).y, 3.0 / 60, 1e-6);
    EXPECT_NEAR(test.spin(cube).z, 3.0 * 3.0 / 60, 1e-5);
    test.world.step();
    EXPECT_NEAR(test.velocity(cube).y, 3.0 / 60, 1e-6);
}

TEST(PhysicsWorldBodies, FallByTheirGravityFactor) {
    for (const Solver solver : {Solver::SmallStep, Solver::BulletSi}) {
        TestWorld test({.solver = solver});
        const BodyId balloon =
            test.add(BoxShape{},
                     {0, 0, 0},
                     {.kind = BodyKind::Dynamic, .mass_kg = 2, .gravity_factor = -0.5_r});
        const BodyId free =
            test.add(BoxShape{}, {9, 0, 0}, {.kind = BodyKind::Dynamic, .gravity_factor = 0});
        test.run(1.0);
        EXPECT_NEAR(test.velocity(balloon).y, kG / 2, 1e-4) << solver_name(solver);
        EXPECT_EQ(test.velocity(free), Vec3d(0, 0, 0));
        // What it gained it took from a field that pulls up.
        EXPECT_NEAR(energy(test.world).kinetic_J + energy(test.world).potential_J, 0, 0.5);
        test.world.apply_force(balloon, {0, 60, 0});
        test.world.step();
        EXPECT_NEAR(test.velocity(balloon).y, kG / 2 * (61.0 / 60) + 0.5, 1e-3);
    }
}

TEST(PhysicsWorldBodies, HaveTheirMomentsAboutTheAxesThatAreGiven) {
    TestWorld test(weightless());
    const Real half = std::sqrt(0.5_r);  // a quarter turn about y: the first axis is the body's -z
    const BodyId cube = test.add(BoxShape{},
                                 {0, 0, 0},
                                 {.kind = BodyKind::Dynamic,
                                  .mass_kg = 2,
                                  .inertia_kgm2 = Vec3{1, 2, 2.5_r},
                                  .body_from_inertia = {half, 0, half, 0}});
    test.world.apply_torque(cube, {6, 6, 6});
    test.world.step();
    EXPECT_NEAR(test.spin(cube).x, 6 / 2.5 / 60, 1e-4);
    EXPECT_NEAR(test.spin(cube).y, 6 / 2.0 / 60, 1e-4);
    EXPECT_NEAR(test.spin(cube).z, 6 / 1.0 / 60, 1e-3);
}

TEST(PhysicsWorldBodies, WhatCannotMoveDoesNotObey) {
    TestWorld test(weightless());
    const BodyId wall = test.add(BoxShape{}, {0, 0, 0}, {.kind = BodyKind::Static});
    const BodyId lift = test.add(BoxShape{}, {5, 0, 0}, {.kind = BodyKind::Kinematic});
    const BodyId held = test.add(BoxShape{}, {9, 0, 0});
    test.world.set_frozen(held, true);
    for (const BodyId id : {wall, lift, held}) {
        test.world.apply_impulse(id, {1, 0, 0});
        test.world.apply_force(id, {60, 0, 0});
        if (id != lift) test.world.set_velocity(id, {1, 0, 0}, {0, 1, 0});
        test.world.step();
        EXPECT_EQ(test.velocity(id), (Vec3d{0, 0, 0}));
        EXPECT_EQ(test.world.state(id).frozen, id == held);
    }
    test.world.set_frozen(lift, true);
    EXPECT_FALSE(test.world.state(lift).frozen) << "dynamic bodies only";
    EXPECT_EQ(test.world.state(wall).mass.mass_kg, Real{0});
}

// The origin is 0.3 m above the centre of mass: it goes round as the body spins.
TEST(PhysicsWorldBodies, VelocitiesAreOfTheOrigin) {
    TestWorld test(weightless());
    const BodyId tumbler = test.add(SphereShape{},
                                    {0, 0, 0},
                                    {.kind = BodyKind::Dynamic,
                                     .center_of_mass_m = Vec3{0, -0.3_r, 0},
                                     .velocity_mps = {1, 0, 0},
                                     .angular_velocity_radps = {0, 0, 2}});
    EXPECT_NEAR(glm::length(test.velocity(tumbler) - Vec3d{1, 0, 0}), 0, 1e-6);
    // Of the centre: 1 + omega x r = 1 + 2 * 0.3.
    EXPECT_NEAR(momentum_kgmps(test.world).x, 1.6, 1e-5);
}

TEST(PhysicsWorldBodies, AReservedPlaceIsTakenByTheNextBody) {
    TestWorld test;
    const BodyId first = test.add(BoxShape{}, {0, 0, 0});
    const BodyId second = test.add(BoxShape{}, {2, 0, 0});
    EXPECT_FALSE(test.world.reserve_body(first)) << "somebody has it";
    test.world.destroy_body(second);
    test.world.destroy_body(second);
    EXPECT_FALSE(test.world.contains(second));
    EXPECT_EQ(body_count(test.world), 1U);
    ASSERT_TRUE(test.world.reserve_body(second));
    EXPECT_EQ(test.add(BoxShape{}, {2, 0, 0}), second);
}

}  // namespace
}  // namespace plumbline::physics
