// Another solver, rate or gravity in the middle of a run.
#include "tests/engine/physics/test_world.h"

#include <cmath>
#include <limits>

namespace plumbline::physics {
namespace {

constexpr int kThings = 30;

BodyDef thing(int i) {
    return {.kind = BodyKind::Dynamic,
            .mass_kg = 1.0_r + static_cast<Real>(i % 4),
            .center_of_mass_m = i % 5 == 0 ? std::optional<Vec3>{{0, -0.1_r, 0}} : std::nullopt,
            .friction = 0.6_r,
            .restitution = i % 3 == 0 ? 0.4_r : 0.0_r,
            .angular_damping_per_s = i % 2 == 0 ? 0.3_r : 0.0_r};
}

ShapeDef shape_of(int i) {
    if (i % 3 == 0) return SphereShape{.radius_m = 0.4_r};
    if (i % 3 == 1) return BoxShape{.size_m = {1, 0.5_r, 0.7_r}};
    return CapsuleShape{.radius_m = 0.3_r, .height_m = 0.6_r};
}

struct MixedHeap {
    explicit MixedHeap(const WorldDef& def) : test(def) { test.ground(0.6_r); }

    void drop() {
        for (int i = 0; i < kThings; ++i) {
            const auto n = static_cast<Real>(i);
            ids.push_back(
                test.add(shape_of(i), {std::sin(n), 1 + 0.6_r * n, std::cos(3 * n)}, thing(i)));
        }
    }
    /// The same bodies where `other` left them.
    void copy(const MixedHeap& other) {
        for (int i = 0; i < kThings; ++i) {
            const BodyState state = other.test.world.state(other.ids[static_cast<std::size_t>(i)]);
            BodyDef def = thing(i);
            def.shape = test.shape(shape_of(i));
            def.world_from_body = state.world_from_body;
            def.velocity_mps = state.velocity_mps;
            def.angular_velocity_radps = state.angular_velocity_radps;
            ids.push_back(test.world.create_body(def));
        }
    }
    std::uint64_t hash_after(int steps) {
        for (int i = 0; i < steps; ++i) test.world.step();
        return test.hash(ids);
    }

    TestWorld test;
    std::vector<BodyId> ids;
};

TEST(Reconfigure, GoesOnAsANewWorldWouldFromTheSameStates) {
    std::vector<WorldDef> defs;
    for (const Solver solver :
         {Solver::SmallStep, Solver::BulletSi, Solver::BulletNncg, Solver::BulletDantzig}) {
        defs.push_back({.substeps = 3, .substeps_max = 3, .iterations = 4, .solver = solver});
    }
    defs.push_back({.gravity_mps2 = {0, -1.62_r, 0.1_r}, .solver = Solver::BulletSi});
    defs.push_back({.gravity_mps2 = {0, 3, 0}, .step_s = 1.0 / 100, .solver = Solver::SmallStep});
    for (std::size_t from = 0; from < defs.size(); ++from) {
        for (std::size_t to = 0; to < defs.size(); ++to) {
            SCOPED_TRACE(from * 10 + to);
            // Those go on with their contacts: the next tests.
            if ((defs[from].solver == Solver::SmallStep) == (defs[to].solver == Solver::SmallStep))
                continue;
            MixedHeap changed(defs[from]);
            changed.drop();
            changed.hash_after(70);
            MixedHeap fresh(defs[to]);
            fresh.copy(changed);
            changed.test.world.reconfigure(defs[to]);
            EXPECT_EQ(changed.test.world.def().solver, defs[to].solver);
            ASSERT_EQ(changed.hash_after(0), changed.test.hash(changed.ids));
            ASSERT_EQ(changed.hash_after(60), fresh.hash_after(60));
        }
    }
}

/// H88: a pile at rest goes on pressing as hard as its weight does, and nothing moves. Sub-steps of
/// another length would let its contacts give way less or more.
TEST(Reconfigure, APileGoesOnPressingAtAnotherRate) {
    TestWorld test(in_small_steps());
    const BodyId ground = test.ground();
    test.world.set_contact_events(ground, true);
    std::vector<BodyId> boxes;
    for (int i = 0; i < 4; ++i)
        boxes.push_back(test.add(BoxShape{},
                                 {0, 0.5_r + static_cast<Real>(i), 0},
                                 {.kind = BodyKind::Dynamic, .mass_kg = 2, .can_sleep = false}));
    test.run(2);
    for (const int substeps : {1, 8, 2, 4}) {
        const double hz = 240.0 / substeps;
        WorldDef def = in_small_steps(substeps);
        def.step_s = 1 / hz;
        test.world.reconfigure(def);
        for (int i = 0; i < 3; ++i) {
            test.world.step();
            ASSERT_EQ(test.world.report().contacts.size(), 1U);
            EXPECT_NEAR(static_cast<double>(test.world.report().contacts[0].impulse_Ns) * hz,
                        4 * 2 * kG,
                        1e-3 * 4 * 2 * kG)
                << hz << " Hz, step " << i;
        }
        for (const BodyId box : boxes) EXPECT_LT(glm::length(test.velocity(box)), 1e-4) << hz;
    }
}

/// How much of its weight a box's contacts do not carry in the next step.
double lack_Ns(TestWorld& test, Real mass_kg) {
    test.world.step();
    EXPECT_EQ(test.world.report().contacts.size(), 1U);
    return static_cast<double>(mass_kg) * kG * test.world.def().step_s -
           static_cast<double>(test.world.report().contacts[0].impulse_Ns);
}

/// ... and with Bullet's solvers, of which one goes on with what another's contacts carried. They
/// start from 85 % of it at least. What one sweep lacks is linear in what it starts from: at most 15 %
/// of what it lacks in a new world, which starts from nothing.
TEST(Reconfigure, ABoxGoesOnPressingWithAnotherOfBulletsSolvers) {
    constexpr Real kBox_kg = 2;
    for (const Solver from : {Solver::BulletSi, Solver::BulletNncg}) {
        for (const Solver to : {Solver::BulletSi, Solver::BulletNncg}) {
            SCOPED_TRACE(std::string(solver_name(from)) + " " + std::string(solver_name(to)));
            BodyDef box{.kind = BodyKind::Dynamic, .mass_kg = kBox_kg, .can_sleep = false};
            TestWorld test({.substeps = 2, .iterations = 40, .solver = from});
            test.world.set_contact_events(test.ground(), true);
            const BodyId resting = test.add(BoxShape{}, {0, 0.5_r, 0}, box);
            test.run(2);

            const WorldDef def{.step_s = 1.0 / 120, .substeps = 1, .iterations = 1, .solver = to};
            TestWorld fresh(def);
            fresh.world.set_contact_events(fresh.ground(), true);
            box.shape = fresh.shape(BoxShape{});
            box.world_from_body = test.world.state(resting).world_from_body;
            fresh.world.create_body(box);
            const double from_nothing_Ns = lack_Ns(fresh, kBox_kg);
            ASSERT_GT(from_nothing_Ns, 0.02 * static_cast<double>(kBox_kg) * kG * def.step_s);

            test.world.reconfigure(def);
            EXPECT_LT(std::abs(lack_Ns(test, kBox_kg)), 0.16 * from_nothing_Ns);
        }
    }
}

TEST(Reconfigure, SleepersSleepOnAtAnotherRate) {
    for (const Solver solver : {Solver::SmallStep, Solver::BulletSi}) {
        WorldDef def = in_small_steps();
        def.solver = solver;
        TestWorld test(def);
        test.ground();
        const BodyId box = test.add(BoxShape{}, {0, 0.5_r, 0});
        test.run(4.0);
        ASSERT_FALSE(test.world.state(box).awake);
        const Vec3d there = test.at(box);
        def.step_s = 1.0 / 240;
        test.world.reconfigure(def);
        test.run(0.5);
        EXPECT_FALSE(test.world.state(box).awake);
        EXPECT_EQ(test.at(box), there);
    }
}

TEST(Reconfigure, FlightStaysOnItsParabola) {
    TestWorld test(in_small_steps());
    const BodyId ball = test.add(
        SphereShape{}, {0, 50, 0}, {.kind = BodyKind::Dynamic, .velocity_mps = {3, 10, 0}});
    test.run(0.5);
    WorldDef fine = in_small_steps(2);
    fine.step_s = 1.0 / 240;
    test.world.reconfigure(fine);
    test.run(0.5);
    EXPECT_NEAR(test.at(ball).x, 3.0, 1e-5);
    EXPECT_NEAR(test.at(ball).y, 50 + 10 - 0.5 * kG, 2e-5);
}

TEST(Reconfigure, NewGravityReachesSleepers) {
    TestWorld test(in_small_steps());
    test.ground();
    const BodyId box = test.add(BoxShape{}, {0, 0.5_r, 0});
    test.run(2.0);
    ASSERT_FALSE(test.world.state(box).awake);
    WorldDef up = in_small_steps();
    up.gravity_mps2 = {0, 2, 0};
    test.world.reconfigure(up);
    test.run(1.0);
    EXPECT_NEAR(test.velocity(box).y, 2.0, 0.01);
}

TEST(Reconfigure, KeepsWhatIsFrozenTakenOutOrOnItsWay) {
    TestWorld test(in_small_steps());
    test.ground();
    const BodyId frozen = test.add(BoxShape{}, {0, 5, 0});
    const BodyId invalid = test.add(BoxShape{}, {4, 5, 0});
    const BodyId lift = test.add(BoxShape{}, {8, 5, 0}, {.kind = BodyKind::Kinematic});
    test.world.set_frozen(frozen, true);
    test.world.apply_force(invalid, {std::numeric_limits<Real>::quiet_NaN(), 0, 0});
    test.world.step();
    ASSERT_EQ(test.world.report().isolated.size(), 1U);
    const Vec3d left_at = test.at(invalid);
    test.world.move_kinematic(lift, {.position = {8, 5.1_r, 0}});
    test.world.reconfigure({.solver = Solver::BulletSi});
    test.world.step();
    EXPECT_NEAR(test.at(lift).y, 5.1, 1e-6);
    test.world.reconfigure(in_small_steps());
    test.run(1.0);
    EXPECT_TRUE(test.world.state(frozen).frozen);
    EXPECT_EQ(test.at(frozen), (Vec3d{0, 5, 0}));
    EXPECT_EQ(test.at(invalid), left_at);
    EXPECT_EQ(test.world.report().isolated.size(), 1U);
    test.world.set_frozen(frozen, false);
    test.run(0.5);
    EXPECT_LT(test.at(frozen).y, 4.0);
}

TEST(Reconfigure, JointsHoldOn) {
    for (const Solver to : {Solver::BulletSi, Solver::SmallStep}) {
        for (const Solver from : {Solver::BulletSi, Solver::SmallStep}) {
            WorldDef def = in_small_steps();
            def.solver = from;
            TestWorld test(def);
            const BodyId bob = test.add(SphereShape{.radius_m = 0.1_r}, {1, 5, 0});
            ASSERT_TRUE(test.world
                            .create_joint({.kind = JointKind::BallAndSocket,
                                           .a = bob,
                                           .anchor_a_world = {0, 5, 0},
                                           .anchor_b_world = {0, 5, 0}})
                            .ok());
            test.run(0.4);
            def.solver = to;
            test.world.reconfigure(def);
            test.run(2.0);
            EXPECT_NEAR(glm::length(test.at(bob) - Vec3d{0, 5, 0}), 1.0, 0.05);
        }
    }
}

}  // namespace
}  // namespace plumbline::physics
