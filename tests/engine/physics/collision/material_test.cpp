// What two materials make of a contact.
#include "tests/engine/physics/test_world.h"

#include <cmath>

namespace plumbline::physics {
namespace {

/// Highest point of a ball dropped from 1 m, after its first impact.
double apex_after_bounce(Real ground_restitution, Real ball_restitution) {
    TestWorld test(at_hz(240));
    test.ground(0.5_r, ground_restitution);
    const BodyId ball = test.add(SphereShape{.radius_m = 0.1_r},
                                 {0, 1.1_r, 0},
                                 {.kind = BodyKind::Dynamic, .restitution = ball_restitution});
    test.run(std::sqrt(2.0 / kG) + 0.02);
    double apex = 0;
    for (int i = 0; i < 240; ++i) {
        test.world.step();
        apex = std::max(apex, test.at(ball).y - 0.1);
    }
    return apex;
}

TEST(Friction, CombinesAsGeometricMeanAndStopsASlideWhereCoulombSays) {
    // sqrt(0.9 * 0.1) = 0.3: v^2 / (2 mu g) = 4.2473667 m from 5 m/s.
    TestWorld test(at_hz(240));
    test.ground(0.9_r);
    const BodyId box =
        test.add(BoxShape{.size_m = {1, 0.2_r, 1}},
                 {0, 0.1_r, 0},
                 {.kind = BodyKind::Dynamic, .velocity_mps = {5, 0, 0}, .friction = 0.1_r});
    test.run(3.0);
    // Bullet's friction rows use last step's normal force: 1 % covers that and the first contact.
    EXPECT_NEAR(test.at(box).x, 4.2473667, 0.01 * 4.2473667);
    EXPECT_NEAR(test.velocity(box).x, 0.0, 1e-3);
}

TEST(Friction, NoneOnOneSideMeansNone) {
    TestWorld test;
    test.ground(1);
    const BodyId box =
        test.add(BoxShape{.size_m = {1, 0.2_r, 1}},
                 {0, 0.1_r, 0},
                 {.kind = BodyKind::Dynamic, .velocity_mps = {5, 0, 0}, .friction = 0});
    test.run(2.0);
    EXPECT_NEAR(test.velocity(box).x, 5.0, 1e-4);
}

// glTF's KHR_physics_rigid_bodies: average comes before minimum, minimum before maximum, that before the product.
TEST(Friction, CombinesByTheStrongerOfTwoRules) {
    const auto distance_m = [](Solver solver, CombineRule ground, CombineRule box_rule) {
        WorldDef def = at_hz(240);
        def.solver = solver;
        TestWorld test(def);
        test.add(BoxShape{.size_m = {100, 1, 100}},
                 {0, -0.5_r, 0},
                 {.kind = BodyKind::Static, .friction = 0.5_r, .friction_rule = ground});
        const BodyId box = test.add(BoxShape{.size_m = {1, 0.2_r, 1}},
                                    {0, 0.1_r, 0},
                                    {.kind = BodyKind::Dynamic,
                                     .velocity_mps = {4, 0, 0},
                                     .friction = 0.2_r,
                                     .friction_rule = box_rule});
        test.run(9.0);
        return test.at(box).x;
    };
    using enum CombineRule;
    struct Case {
        CombineRule ground;
        CombineRule box;
        double friction;
    };
    for (const Case& each : {Case{Usual, Usual, std::sqrt(0.1)},
                             Case{Multiply, Usual, 0.1},
                             Case{Multiply, Maximum, 0.5},
                             Case{Minimum, Maximum, 0.2},
                             Case{Minimum, Average, 0.35}}) {
        const double predicted_m = 16 / (2 * each.friction * kG);
        for (const Solver solver : {Solver::SmallStep, Solver::BulletSi})
            EXPECT_NEAR(distance_m(solver, each.ground, each.box), predicted_m, 0.02 * predicted_m)
                << each.friction << " " << solver_name(solver);
    }
}

TEST(Restitution, CombinesByTheStrongerOfTwoRules) {
    const auto apex_m = [](CombineRule rule) {
        TestWorld test(at_hz(240));
        test.add(BoxShape{.size_m = {100, 1, 100}},
                 {0, -0.5_r, 0},
                 {.kind = BodyKind::Static, .restitution = 0.8_r});
        const BodyId ball =
            test.add(SphereShape{.radius_m = 0.1_r},
                     {0, 1.1_r, 0},
                     {.kind = BodyKind::Dynamic, .restitution = 0.4_r, .restitution_rule = rule});
        test.run(std::sqrt(2.0 / kG) + 0.02);
        double apex = 0;
        for (int i = 0; i < 240; ++i) {
            test.world.step();
            apex = std::max(apex, test.at(ball).y - 0.1);
        }
        return apex;
    };
    EXPECT_NEAR(apex_m(CombineRule::Usual), 0.64, 0.01);
    EXPECT_NEAR(apex_m(CombineRule::Average), 0.36, 0.01);
    EXPECT_NEAR(apex_m(CombineRule::Minimum), 0.16, 0.01);
    EXPECT_NEAR(apex_m(CombineRule::Multiply), 0.32 * 0.32, 0.01);
}

TEST(Restitution, CombinesAsMaximum) {
    const double both = apex_after_bounce(0.5_r, 0.5_r);
    EXPECT_EQ(apex_after_bounce(0, 0.5_r), both);
    EXPECT_EQ(apex_after_bounce(0.5_r, 0), both);
    // e^2 H = 0.25 m. Stock Bullet adds a fifth of the overlap per step to the rebound, so that its
    // bounces come out too high by a share that depends on where in the step the impact falls.
    EXPECT_GT(both, 0.24);
    EXPECT_LT(both, 0.45);
    EXPECT_LT(apex_after_bounce(0, 0), 0.05);
}

}  // namespace
}  // namespace plumbline::physics
