// How bodies go from pose to pose: led, swept, stopped.
#include "tests/engine/physics/test_world.h"

namespace plumbline::physics {
namespace {

class ThinWall : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Speeds, ThinWall, testing::Values(50.0, 200.0, 400.0));

TEST_P(ThinWall, StopsFastBoxesWhenSwept) {
    int through = 0;
    std::uint32_t swept = 0;
    for (int i = 0; i < 10; ++i) {
        TestWorld test(weightless());
        test.add(BoxShape{.size_m = {0.02_r, 8, 8}}, {20, 0, 0}, {.kind = BodyKind::Static});
        const Quat turned =
            glm::angleAxis(0.3_r * static_cast<Real>(i), glm::normalize(Vec3{1, 2, 3}));
        const BodyId box = test.world.create_body(
            {.kind = BodyKind::Dynamic,
             .shape = test.shape(BoxShape{.size_m = {0.4_r, 0.4_r, 0.4_r}}),
             .world_from_body = {.position = {0.37_r * static_cast<Real>(i), 0, 0},
                                 .orientation = turned},
             .velocity_mps = {static_cast<Real>(GetParam()), 0, 0}});
        for (int step = 0; step < 60; ++step) {
            test.world.step();
            swept += test.world.report().use.swept_bodies;
        }
        if (test.at(box).x > 20) ++through;
    }
    EXPECT_EQ(through, 0);
    EXPECT_GT(swept, 0U);
}

TEST(ContinuousCollision, RunsOnlyForBodiesThatOutrunThemselves) {
    TestWorld test(weightless());
    // Inner radius 0.2 m: at 60 Hz the limit is 12 m/s.
    const auto shoot = [&test](Real z, Real speed, ContinuousCollision ccd) {
        return test.add(BoxShape{.size_m = {0.4_r, 0.4_r, 0.4_r}},
                        {0, 0, z},
                        {.kind = BodyKind::Dynamic, .velocity_mps = {speed, 0, 0}, .ccd = ccd});
    };
    shoot(0, 11, ContinuousCollision::Auto);
    test.world.step();
    EXPECT_EQ(test.world.report().use.swept_bodies, 0U);
    EXPECT_EQ(test.world.report().use.sweep_ms, 0.0);
    EXPECT_FALSE(test.world.report().use.swept);
    const BodyId fast = shoot(5, 13, ContinuousCollision::Auto);
    shoot(10, 13, ContinuousCollision::Off);
    shoot(15, 1, ContinuousCollision::On);
    test.world.step();
    EXPECT_EQ(test.world.report().use.swept_bodies, 2U);
    EXPECT_EQ(test.world.report().use.swept, fast) << "the first of them";
    test.world.set_features({.continuous_collision = false});
    test.world.step();
    EXPECT_EQ(test.world.report().use.swept_bodies, 0U);
}

TEST(Kinematic, PlatformCarriesItsRider) {
    TestWorld test;
    const BodyId lift = test.add(
        BoxShape{.size_m = {4, 0.4_r, 4}}, {0, 0, 0}, {.kind = BodyKind::Kinematic, .friction = 1});
    const BodyId rider =
        test.add(BoxShape{}, {0, 0.7_r, 0}, {.kind = BodyKind::Dynamic, .friction = 1});
    test.run(0.5);
    const double started = test.at(rider).x;
    for (int i = 1; i <= 120; ++i) {
        const Real t = static_cast<Real>(i) / 60;
        // Eases in, so that friction can follow: 0.5 m/s2.
        test.world.move_kinematic(lift, {.position = {0.25_r * t * t, 0.1_r * t, 0}});
        test.world.step();
        EXPECT_NEAR(test.at(lift).x, static_cast<double>(0.25_r * t * t), 1e-5)
            << "exactly on time";
    }
    EXPECT_NEAR(test.velocity(lift).x, 1.0, 0.01);
    EXPECT_NEAR(test.at(rider).x - started, 1.0, 0.02);
    EXPECT_NEAR(test.at(rider).y, 0.7 + 0.2, 0.02);
    test.world.step();
    EXPECT_EQ(test.velocity(lift), Vec3d(0, 0, 0)) << "nobody moved it in this step";
}

TEST(Kinematic, MovesThroughSubstepsAndPushesSleepers) {
    TestWorld test(at_hz(60, 4));
    test.ground();
    const BodyId box = test.add(BoxShape{}, {2, 0.5_r, 0});
    test.run(5.0);
    ASSERT_FALSE(test.world.state(box).awake);
    const BodyId plough =
        test.add(BoxShape{}, {0, 0.55_r, 0}, {.kind = BodyKind::Kinematic, .filter = {.group = 1}});
    for (int i = 1; i <= 120; ++i) {
        test.world.move_kinematic(plough, {.position = {static_cast<Real>(i) / 60, 0.55_r, 0}});
        test.world.step();
    }
    EXPECT_GE(test.at(box).x, 2.98);
}

}  // namespace
}  // namespace plumbline::physics
