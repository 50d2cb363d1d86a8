// SOURCES A39: a body that is held along an axis never leaves its place there, whatever pushes it.
#include "tests/engine/physics/test_world.h"

namespace plumbline::physics {
namespace {

constexpr Real kSide_m = 2.5_r;

class LinearFactor : public testing::TestWithParam<Solver> {
protected:
    WorldDef def() const {
        WorldDef def = GetParam() == Solver::SmallStep ? in_small_steps() : WorldDef{};
        def.solver = GetParam();
        def.iterations = GetParam() == Solver::SmallStep ? 1 : 10;
        return def;
    }
};

TEST_P(LinearFactor, AHeapOfBallsStaysInItsPlane) {
    TestWorld test(def());
    test.ground();
    std::vector<BodyId> balls;
    for (int i = 0; i < 16; ++i) {
        const Real x = kSide_m * (static_cast<Real>(i % 4) - 1.5_r) + 0.01_r * static_cast<Real>(i);
        balls.push_back(test.add(SphereShape{1.2_r},
                                 {x, 1.5_r + kSide_m * static_cast<Real>(i / 4), 3},
                                 {.kind = BodyKind::Dynamic, .linear_factor = {1, 1, 0}}));
    }
    // A free ball comes in across the plane, and is stopped by it or leaves it.
    test.add(SphereShape{1.2_r},
             {0.3_r, 2, -6},
             {.kind = BodyKind::Dynamic, .mass_kg = 5, .velocity_mps = {0, 2, 12}});
    test.world.apply_impulse(balls[3], {4, 0, 40});
    for (int step = 0; step < 240; ++step) {
        test.world.apply_force(balls[7], {0, 0, 500});
        test.world.step();
        for (const BodyId ball : balls) ASSERT_EQ(test.at(ball).z, 3) << "step " << step;
    }
    for (const BodyId ball : balls) EXPECT_EQ(test.velocity(ball).z, 0);
    EXPECT_GT(test.at(balls[15]).y, 1.1) << "they rest on the ground and on each other";
}

TEST_P(LinearFactor, AlongTheFreeAxesABodyFallsAsEveryOther) {
    TestWorld test(def());
    const BodyId held =
        test.add(BoxShape{}, {0, 100, 0}, {.kind = BodyKind::Dynamic, .linear_factor = {1, 1, 0}});
    const BodyId free = test.add(BoxShape{}, {5, 100, 0});
    test.run(2);
    EXPECT_EQ(test.at(held).y, test.at(free).y);
}

TEST_P(LinearFactor, HeldAlongTheVerticalNothingFalls) {
    TestWorld test(def());
    const BodyId held = test.add(
        BoxShape{},
        {0, 100, 0},
        {.kind = BodyKind::Dynamic, .velocity_mps = {3, -4, 0}, .linear_factor = {1, 0, 1}});
    test.run(2);
    EXPECT_EQ(test.at(held).y, 100);
    EXPECT_NEAR(test.at(held).x, 6, 1e-4);
}

TEST_P(LinearFactor, AnImpulseOffCentreTurnsAsTheForceOfAStepDoes) {
    WorldDef world = def();
    world.gravity_mps2 = {0, 0, 0};
    for (const Vec3& along : {Vec3{0, 0, 6}, Vec3{0, 6, 0}, Vec3{2, 3, 6}}) {
        TestWorld test(world);
        const BodyDef held{.kind = BodyKind::Dynamic, .mass_kg = 2, .linear_factor = {1, 1, 0}};
        const BodyId pushed = test.add(BoxShape{}, {0, 0, 0}, held);
        const BodyId struck = test.add(BoxShape{}, {9, 0, 0}, held);
        test.world.apply_force(pushed, along * 60.0_r, Vec3{0.5_r, 0, 0});
        test.world.apply_impulse(struck, along, Vec3{9.5_r, 0, 0});
        test.world.step();
        EXPECT_NEAR(glm::length(test.spin(pushed) - test.spin(struck)), 0, 1e-4);
        EXPECT_NEAR(glm::length(test.velocity(pushed) - test.velocity(struck)), 0, 1e-5);
        EXPECT_EQ(test.velocity(struck).z, 0);
        // m a^2 / 6 = 1/3, the arm 0.5 m.
        const Vec3d whole = 1.5 * glm::cross(Vec3d{1, 0, 0}, Vec3d(along));
        EXPECT_NEAR(glm::length(test.spin(struck) - whole), 0, 1e-4);
    }
}

INSTANTIATE_TEST_SUITE_P(WithEverySolver,
                         LinearFactor,
                         testing::Values(Solver::SmallStep, Solver::BulletSi),
                         [](const auto& each) { return std::string(solver_name(each.param)); });

}  // namespace
}  // namespace plumbline::physics
