#include "tests/engine/physics/test_world.h"

#include <cmath>
#include <limits>

namespace plumbline::physics {
namespace {

/// Boxes that fall, meet and settle.
std::vector<BodyId> heap(TestWorld& test, int count) {
    std::vector<BodyId> ids;
    for (int i = 0; i < count; ++i) {
        const Real x = 0.13_r * static_cast<Real>(i % 5);
        const Real z = 0.17_r * static_cast<Real>(i % 3);
        ids.push_back(test.add(BoxShape{.size_m = {0.5_r, 0.4_r, 0.6_r}},
                               {x, 0.5_r + 0.5_r * static_cast<Real>(i), z},
                               {.kind = BodyKind::Dynamic, .mass_kg = 2}));
    }
    return ids;
}

TEST(Determinism, SameCallsSameBits) {
    const auto run = [](bool draw, std::size_t ballast) {
        // Ballast moves the heap's addresses: no result may depend on them.
        std::vector<std::vector<char>> junk(ballast, std::vector<char>(777));
        TestWorld test;
        test.ground();
        const auto ids = heap(test, 20);
        LineList lines;
        for (int i = 0; i < 180; ++i) {
            test.world.step();
            if (draw) test.world.add_debug_lines(lines);
        }
        EXPECT_EQ(lines.vertices.empty(), !draw);
        return test.hash(ids);
    };
    const std::uint64_t first = run(false, 0);
    EXPECT_EQ(run(false, 0), first);
    EXPECT_EQ(run(false, 1000), first);
    EXPECT_EQ(run(true, 13), first) << "drawing outlines must not change the run";
}

TEST(Determinism, MeasuringAndAskingChangeNothing) {
    const auto run = [](bool curious) {
        TestWorld test;
        test.ground();
        const auto ids = heap(test, 10);
        const ShapeId ball = test.shape(SphereShape{});
        for (int i = 0; i < 120; ++i) {
            test.world.step();
            if (!curious) continue;
            test.world.cast_ray({0, 20, 0}, {0, -1, 0});
            test.world.overlaps(ball, {.position = {0, 0.5_r, 0}}, 0.1_r);
            test.world.all_contacts();
            test.world.energy();
        }
        return test.hash(ids);
    };
    EXPECT_EQ(run(true), run(false));
}

/// Takes one body of a heap out at step 30 by `how`; the rest must not tell the difference.
template <class Fn>
std::uint64_t rest_of_heap(Fn&& how, std::size_t* quarantined = nullptr) {
    TestWorld test;
    test.ground();
    auto ids = heap(test, 12);
    const BodyId victim = ids[5];
    for (int i = 0; i < 150; ++i) {
        if (i == 30) how(test.world, victim);
        test.world.step();
    }
    ids.erase(ids.begin() + 5);
    if (quarantined != nullptr) *quarantined = test.world.quarantined().size();
    return test.hash(ids);
}

TEST(Quarantine, RestGoesOnAsIfTheBodyHadBeenRemoved) {
    const std::uint64_t removed =
        rest_of_heap([](PhysicsWorld& world, BodyId id) { world.destroy_body(id); });
    std::size_t count = 0;
    EXPECT_EQ(rest_of_heap(
                  [](PhysicsWorld& world, BodyId id) {
                      world.set_velocity(id, {0, kNan, 0}, {0, 0, 0});
                  },
                  &count),
              removed);
    EXPECT_EQ(count, 1U);
    EXPECT_EQ(rest_of_heap([](PhysicsWorld& world, BodyId id) {
                  world.apply_force(id, {kNan, 0, 0});
              }),
              removed);
    EXPECT_EQ(rest_of_heap([](PhysicsWorld& world, BodyId id) {
                  world.apply_torque(id, {0, 0, std::numeric_limits<Real>::infinity()});
              }),
              removed);
    EXPECT_EQ(rest_of_heap([](PhysicsWorld& world, BodyId id) {
                  world.set_pose(id, {.position = {0, kNan, 0}});
              }),
              removed);
}

TEST(Quarantine, BodyStaysWhereItLastWasSound) {
    TestWorld test;
    const BodyId body = test.add(BoxShape{}, {0, 8, 0});
    test.run(0.5);
    const Vec3d last = test.at(body);
    test.world.set_velocity(body, {kNan, 0, 0}, {0, 0, 0});
    test.run(0.5);
    EXPECT_EQ(test.at(body), last);
    EXPECT_EQ(test.velocity(body), Vec3d(0, 0, 0));
    ASSERT_EQ(test.world.quarantined().size(), 1U);
    EXPECT_EQ(test.world.quarantined()[0], body);
    EXPECT_TRUE(test.world.contains(body));
    EXPECT_FALSE(test.world.state(body).awake);
    EXPECT_EQ(test.world.awake_count(), 0U);
    test.world.destroy_body(body);
    EXPECT_FALSE(test.world.contains(body));
}

TEST(Quarantine, GroundAndPlatformsDoNotObeyNonsense) {
    TestWorld test;
    const BodyId ground = test.ground();
    const BodyId lift = test.add(BoxShape{}, {3, 0, 0}, {.kind = BodyKind::Kinematic});
    const BodyId box = test.add(BoxShape{}, {0, 0.5_r, 0});
    test.world.set_pose(ground, {.position = {kNan, 0, 0}});
    test.world.move_kinematic(lift, {.position = {0, kNan, 0}});
    test.run(0.5);
    EXPECT_TRUE(test.world.quarantined().empty());
    EXPECT_NEAR(test.at(box).y, 0.5, 0.01);
    EXPECT_EQ(test.at(lift), Vec3d(3, 0, 0));
}

TEST(Quarantine, BodiesFlungOutOfTheWorldAreTakenOut) {
    TestWorld test;
    const BodyId far = test.add(BoxShape{}, {0, 0, 0});
    test.world.set_pose(far, {.position = {1e18_r, 0, 0}});
    const BodyId near = test.add(BoxShape{}, {0, 8, 0});
    test.run(1.0);
    ASSERT_EQ(test.world.quarantined().size(), 1U);
    EXPECT_EQ(test.world.quarantined()[0], far);
    EXPECT_NEAR(test.at(near).y, 8 - 0.5 * kG, 1e-5);
}

TEST(Quarantine, AbsurdForcesAreLimitedNotFatal) {
    TestWorld test;
    test.ground();
    const BodyId pebble = test.add(BoxShape{.size_m = {0.1_r, 0.1_r, 0.1_r}},
                                   {0, 3, 0},
                                   {.kind = BodyKind::Dynamic, .mass_kg = 0.01_r});
    test.world.apply_force(pebble, {1e9_r, 0, 0});
    test.world.apply_torque(pebble, {0, 1e30_r, 0});
    test.world.step();
    EXPECT_TRUE(test.world.quarantined().empty());
    EXPECT_LE(glm::length(test.velocity(pebble)), 1e4 * 1.001);
    EXPECT_GT(test.velocity(pebble).x, 9e3);
    test.world.set_velocity(pebble, {1e20_r, 0, 0}, {0, 0, 0});
    test.world.step();
    EXPECT_LE(glm::length(test.velocity(pebble)), 1e4 * 1.001);
    EXPECT_TRUE(test.world.quarantined().empty());
}

class ThinWall : public testing::TestWithParam<double> {};

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
            swept += test.world.feature_use().swept_bodies;
        }
        if (test.at(box).x > 20) ++through;
    }
    EXPECT_EQ(through, 0);
    EXPECT_GT(swept, 0U);
}

INSTANTIATE_TEST_SUITE_P(Speeds, ThinWall, testing::Values(50.0, 200.0, 400.0));

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
    EXPECT_EQ(test.world.feature_use().swept_bodies, 0U);
    EXPECT_EQ(test.world.feature_use().sweep_ms, 0.0);
    EXPECT_FALSE(test.world.feature_use().swept);
    const BodyId fast = shoot(5, 13, ContinuousCollision::Auto);
    shoot(10, 13, ContinuousCollision::Off);
    shoot(15, 1, ContinuousCollision::On);
    test.world.step();
    EXPECT_EQ(test.world.feature_use().swept_bodies, 2U);
    EXPECT_EQ(test.world.feature_use().swept, fast) << "the first of them";
    test.world.set_features({.continuous_collision = false});
    test.world.step();
    EXPECT_EQ(test.world.feature_use().swept_bodies, 0U);
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

TEST(Frozen, StandsInTheAirAndFallsAgain) {
    TestWorld test;
    const BodyId box = test.add(BoxShape{}, {0, 8, 0}, {.kind = BodyKind::Dynamic, .mass_kg = 3});
    test.run(0.5);
    test.world.set_frozen(box, true);
    const Vec3d held = test.at(box);
    test.run(1.0);
    EXPECT_EQ(test.at(box), held);
    EXPECT_TRUE(test.world.frozen(box));
    EXPECT_EQ(test.world.mass_properties(box).mass_kg, 3);
    test.world.set_frozen(box, false);
    test.run(0.5);
    EXPECT_NEAR(test.at(box).y, held.y - 0.5 * kG * 0.25, 1e-5);
}

TEST(Sleep, PileSleepsAndWakesWhenItsSupportGoes) {
    TestWorld test;
    test.ground();
    const BodyId lower = test.add(BoxShape{}, {0, 0.5_r, 0});
    const BodyId upper = test.add(BoxShape{}, {0, 1.5_r, 0});
    test.run(4.0);
    EXPECT_EQ(test.world.awake_count(), 0U);
    test.world.destroy_body(lower);
    EXPECT_EQ(test.world.awake_count(), 1U);
    test.run(0.25);
    EXPECT_LT(test.at(upper).y, 1.5 - 0.5 * kG * 0.25 * 0.25 + 0.02);
}

TEST(Sleep, SlowMoversKeepMoving) {
    TestWorld test;
    test.ground(0);
    const BodyId slider =
        test.add(BoxShape{.size_m = {1, 0.2_r, 1}},
                 {0, 0.1_r, 0},
                 {.kind = BodyKind::Dynamic, .velocity_mps = {0.1_r, 0, 0}, .friction = 0});
    test.run(10.0);
    EXPECT_NEAR(test.at(slider).x, 1.0, 0.01);

    TestWorld space(weightless());
    const BodyId drifting = space.add(
        BoxShape{}, {0, 0, 0}, {.kind = BodyKind::Dynamic, .velocity_mps = {0.001_r, 0, 0}});
    space.run(10.0);
    EXPECT_NEAR(space.at(drifting).x, 0.01, 1e-6);
}

TEST(Totals, EnergyAndMomentumOfAThrow) {
    TestWorld test;
    test.add(BoxShape{},
             {0, 8, 0},
             {.kind = BodyKind::Dynamic, .mass_kg = 2, .velocity_mps = {3, 4, 0}});
    const Energy start = test.world.energy();
    EXPECT_NEAR(start.kinetic_J, 25.0, 1e-4);
    EXPECT_NEAR(start.potential_J, 2 * kG * 8, 1e-4);
    test.run(1.0);
    const Energy end = test.world.energy();
    EXPECT_NEAR(end.total_J(), start.total_J(), 200 * kRounding);
    EXPECT_NEAR(test.world.momentum_kgmps().x, 6.0, 10 * kRounding);
    EXPECT_NEAR(test.world.momentum_kgmps().y, 2 * (4 - kG), 20 * kRounding);
}

}  // namespace
}  // namespace plumbline::physics
