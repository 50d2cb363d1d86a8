// One fixed step: the same bits from the same calls, and who is taken out.
#include "engine/physics/debug_lines.h"
#include "engine/physics/query.h"
#include "engine/physics/totals.h"
#include "tests/engine/physics/test_world.h"

#include <sys/time.h>
#include <unistd.h>

#include <csignal>
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

/// Takes one body of a heap out at step 30 by `how`; the rest must not tell the difference.
template <class Fn>
std::uint64_t rest_of_heap(Fn&& how, std::size_t* isolated = nullptr) {
    TestWorld test;
    test.ground();
    auto ids = heap(test, 12);
    const BodyId victim = ids[5];
    for (int i = 0; i < 150; ++i) {
        if (i == 30) how(test.world, victim);
        test.world.step();
    }
    ids.erase(ids.begin() + 5);
    if (isolated != nullptr) *isolated = test.world.report().isolated.size();
    return test.hash(ids);
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
            if (draw) add_debug_lines(test.world, lines);
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
            cast_ray(test.world, {0, 20, 0}, {0, -1, 0});
            overlaps(test.world, ball, {.position = {0, 0.5_r, 0}}, 0.1_r);
            all_contacts(test.world);
            energy(test.world);
        }
        return test.hash(ids);
    };
    EXPECT_EQ(run(true), run(false));
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
    ASSERT_EQ(test.world.report().isolated.size(), 1U);
    EXPECT_EQ(test.world.report().isolated[0], body);
    EXPECT_TRUE(test.world.contains(body));
    EXPECT_FALSE(test.world.state(body).awake);
    EXPECT_EQ(awake_count(test.world), 0U);
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
    EXPECT_TRUE(test.world.report().isolated.empty());
    EXPECT_NEAR(test.at(box).y, 0.5, 0.01);
    EXPECT_EQ(test.at(lift), Vec3d(3, 0, 0));
}

TEST(Quarantine, BodiesFlungOutOfTheWorldAreTakenOut) {
    TestWorld test;
    const BodyId far = test.add(BoxShape{}, {0, 0, 0});
    test.world.set_pose(far, {.position = {1e18_r, 0, 0}});
    const BodyId near = test.add(BoxShape{}, {0, 8, 0});
    test.run(1.0);
    ASSERT_EQ(test.world.report().isolated.size(), 1U);
    EXPECT_EQ(test.world.report().isolated[0], far);
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
    EXPECT_TRUE(test.world.report().isolated.empty());
    EXPECT_LE(glm::length(test.velocity(pebble)), 1e4 * 1.001);
    EXPECT_GT(test.velocity(pebble).x, 9e3);
    test.world.set_velocity(pebble, {1e20_r, 0, 0}, {0, 0, 0});
    test.world.step();
    EXPECT_LE(glm::length(test.velocity(pebble)), 1e4 * 1.001);
    EXPECT_TRUE(test.world.report().isolated.empty());
}

/// While one lives, the thread is held up for 3 ms after every millisecond.
class Interruptions {
public:
    Interruptions() {
        std::signal(SIGALRM, [](int) {
            usleep(3000);
            come_after(1000);
        });
        come_after(1000);
    }
    Interruptions(const Interruptions&) = delete;
    Interruptions& operator=(const Interruptions&) = delete;
    ~Interruptions() {
        std::signal(SIGALRM, SIG_IGN);
        come_after(0);
        std::signal(SIGALRM, SIG_DFL);
    }

private:
    /// 0: never.
    static void come_after(suseconds_t wait_us) {
        const itimerval timer{.it_interval = {0, 0}, .it_value = {0, wait_us}};
        setitimer(ITIMER_REAL, &timer, nullptr);
    }
};

TEST(StepCost, CountsNothingThatOthersTook) {
    for (const Solver solver : {Solver::SmallStep, Solver::BulletSi}) {
        TestWorld test({.solver = solver});
        test.ground();
        heap(test, 60);
        test.run(1.0);
        const Interruptions interruptions;
        for (int i = 0; i < 50; ++i) {
            test.world.step();
            const StepCost& cost = test.world.report().cost;
            const FeatureUse& use = test.world.report().use;
            const double phases_ms = cost.broad_ms + cost.narrow_ms + cost.solve_ms +
                                     cost.integrate_ms + use.sweep_ms + use.gyro_ms + use.events_ms;
            EXPECT_GT(phases_ms, 0.0);
            EXPECT_LE(phases_ms, cost.total_ms * (1 + 1e-9));
        }
    }
}

}  // namespace
}  // namespace plumbline::physics
