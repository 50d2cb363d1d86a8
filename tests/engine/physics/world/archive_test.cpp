// A world put back from its fields goes on to the same bits: with every solver, among shapes of every
// kind and joints of every kind, while things fall, press, break, are carried and sleep.
#include "engine/core/io/pose_archive.h"
#include "engine/physics/totals.h"
#include "tests/engine/physics/test_world.h"

#include <array>
#include <cmath>

namespace plumbline::physics {
namespace {

HullShape wedge() {
    return {{{-0.4_r, -0.3_r, -0.3_r},
             {0.4_r, -0.3_r, -0.3_r},
             {-0.4_r, -0.3_r, 0.3_r},
             {0.4_r, -0.3_r, 0.3_r},
             {0, 0.4_r, -0.2_r},
             {0, 0.4_r, 0.2_r}}};
}

/// Two boxes across each other.
CompoundShape cross() {
    return {
        {{.shape = BoxShape{{1, 0.2_r, 0.2_r}}},
         {.shape = BoxShape{{0.2_r, 1, 0.2_r}}, .body_from_child = {.position = {0.1_r, 0, 0}}}}};
}

/// A floor of triangles with a hollow.
MeshShape dish() {
    MeshShape mesh;
    constexpr int kSide = 9;
    for (int z = 0; z < kSide; ++z) {
        for (int x = 0; x < kSide; ++x) {
            const Real u = static_cast<Real>(x - kSide / 2);
            const Real v = static_cast<Real>(z - kSide / 2);
            mesh.vertices_m.push_back({u * 1.5_r, 0.03_r * (u * u + v * v), v * 1.5_r});
        }
    }
    for (std::uint32_t z = 0; z + 1 < kSide; ++z) {
        for (std::uint32_t x = 0; x + 1 < kSide; ++x) {
            const std::uint32_t a = z * kSide + x;
            const std::uint32_t b = a + kSide;
            mesh.triangles.push_back({a, b, a + 1});
            mesh.triangles.push_back({a + 1, b, b + 1});
        }
    }
    return mesh;
}

struct Fair {
    explicit Fair(const WorldDef& def) : test(def) {
        test.world.create_body({.shape = test.shape(dish()), .friction = 0.6_r});
        const std::array<ShapeDef, 6> shapes{BoxShape{{0.6_r, 0.4_r, 0.5_r}},
                                             SphereShape{.radius_m = 0.3_r},
                                             CapsuleShape{.radius_m = 0.2_r, .height_m = 0.4_r},
                                             CylinderShape{.radius_m = 0.3_r, .height_m = 0.5_r},
                                             wedge(),
                                             cross()};
        for (int i = 0; i < 24; ++i) {
            const auto n = static_cast<Real>(i);
            ids.push_back(
                test.add(shapes[static_cast<std::size_t>(i) % shapes.size()],
                         {1.5_r * std::sin(n), 1 + 0.4_r * n, 1.5_r * std::cos(2 * n)},
                         {.kind = BodyKind::Dynamic,
                          .mass_kg = 1 + static_cast<Real>(i % 4),
                          .center_of_mass_m =
                              i % 7 == 0 ? std::optional<Vec3>{{0, -0.05_r, 0}} : std::nullopt,
                          .friction = 0.6_r,
                          .rolling_friction = i % 6 == 1 ? 0.01_r : 0,
                          .restitution = i % 3 == 0 ? 0.3_r : 0,
                          .contact_events = true}));
        }
        hang();
        lift = test.add(BoxShape{{1, 0.2_r, 1}}, {3, 0.6_r, 0}, {.kind = BodyKind::Kinematic});
        ids.push_back(lift);
        test.world.set_frozen(ids[4], true);
    }

    /// A chain with a joint of each kind, one of which breaks.
    void hang() {
        constexpr std::array kKinds{JointKind::BallAndSocket,
                                    JointKind::Hinge,
                                    JointKind::Slider,
                                    JointKind::Fixed,
                                    JointKind::Cone,
                                    JointKind::Distance,
                                    JointKind::Spring};
        BodyId above{};
        for (std::size_t i = 0; i < kKinds.size(); ++i) {
            const auto n = static_cast<Real>(i);
            const BodyId link = test.add(BoxShape{{0.3_r, 0.1_r, 0.1_r}},
                                         {-4 + 0.4_r * n, 6, -3},
                                         {.kind = BodyKind::Dynamic, .mass_kg = 0.5_r});
            const Vec3 anchor{-4.2_r + 0.4_r * n, 6, -3};
            JointDef joint{.kind = kKinds[i],
                           .a = link,
                           .b = above,
                           .anchor_a_world = anchor,
                           .anchor_b_world = anchor,
                           .axis_world = {0, 0, 1},
                           .stiffness_Npm = 200,
                           .damping_Nspm = 1,
                           .break_N = kKinds[i] == JointKind::Fixed ? 12.0_r : 0};
            if (kKinds[i] == JointKind::Distance) {
                joint.anchor_b_world.x -= 0.2_r;
                joint.limits = {0.1_r, 0.3_r};
            }
            if (kKinds[i] == JointKind::Hinge) joint.motor = JointMotor{.target = 2, .max = 0.5_r};
            EXPECT_TRUE(test.world.create_joint(joint).ok());
            ids.push_back(link);
            above = link;
        }
    }

    void run(int from, int steps) {
        for (int i = from; i < from + steps; ++i) {
            const Real turn = static_cast<Real>(i) * 0.02_r;
            test.world.move_kinematic(lift, {.position = {3, 1 + 0.4_r * std::sin(turn), 0}});
            if (i % 40 == 20)
                test.world.apply_impulse(ids[static_cast<std::size_t>(i / 40) % 20], {2, 3, -1});
            test.world.step();
        }
    }
    std::string fields() {
        Archive archive;
        test.world.serialize(archive);
        return archive.take();
    }

    TestWorld test;
    std::vector<BodyId> ids;
    BodyId lift{};
};

WorldDef def_of(Solver solver) {
    return {.iterations = solver == Solver::SmallStep ? 1 : 10, .solver = solver};
}

TEST(WorldArchive, PutBackItGoesOnToTheSameBits) {
    for (const Solver solver : kSolvers) {
        // The matrix solvers take seconds for what the others do in a blink.
        const bool is_slow = solver == Solver::BulletDantzig || solver == Solver::BulletPgs;
        for (const int before : {0, 1, 45, 120, 300}) {
            if (is_slow && before != 45) continue;
            SCOPED_TRACE(std::string(solver_name(solver)) + " after " + std::to_string(before));
            Fair there(def_of(solver));
            there.run(0, before);
            const std::string fields = there.fields();

            Fair here(def_of(solver));
            Archive archive(fields);
            here.test.world.serialize(archive);
            ASSERT_FALSE(archive.failed()) << archive.fault();
            EXPECT_EQ(archive.left(), 0U);
            EXPECT_TRUE(here.fields() == fields) << "something was not taken up";
            ASSERT_EQ(here.test.hash(here.ids), there.test.hash(there.ids));
            for (int i = 0; i < 60; ++i) {
                there.run(before + i, 1);
                here.run(before + i, 1);
                ASSERT_EQ(here.test.hash(here.ids), there.test.hash(there.ids)) << "step " << i;
                ASSERT_EQ(here.test.world.report().contacts.size(),
                          there.test.world.report().contacts.size());
            }
        }
    }
}

TEST(WorldArchive, SleepersSleepOnAndWakeTogether) {
    for (const Solver solver : {Solver::SmallStep, Solver::BulletSi}) {
        SCOPED_TRACE(solver_name(solver));
        const auto pile = [&](TestWorld& test) {
            std::vector<BodyId> ids;
            test.ground();
            for (int i = 0; i < 3; ++i)
                ids.push_back(test.add(BoxShape{}, {0, 0.5_r + static_cast<Real>(i), 0}));
            return ids;
        };
        TestWorld there(def_of(solver));
        const std::vector<BodyId> ids = pile(there);
        there.run(6);
        ASSERT_EQ(awake_count(there.world), 0U);
        Archive out;
        there.world.serialize(out);
        TestWorld here(def_of(solver));
        pile(here);
        Archive in(out.written());
        here.world.serialize(in);
        ASSERT_FALSE(in.failed()) << in.fault();
        EXPECT_EQ(awake_count(here.world), 0U);
        for (TestWorld* test : {&there, &here}) {
            test->run(0.2);
            test->world.apply_impulse(ids[2], {1, 0, 0});
            test->run(1);
        }
        EXPECT_EQ(here.hash(ids), there.hash(ids));
    }
}

TEST(WorldArchive, CutAnywhereItFailsAndMayBeThrownAway) {
    Fair there(def_of(Solver::SmallStep));
    there.run(0, 90);
    const std::string fields = there.fields();
    for (std::size_t size = 0; size < fields.size(); size += 1 + fields.size() / 150) {
        Fair here(def_of(Solver::SmallStep));
        Archive archive(std::string_view(fields).substr(0, size));
        here.test.world.serialize(archive);
        EXPECT_TRUE(archive.failed()) << size;
    }
}

TEST(WorldArchive, OtherBodiesAreRefused) {
    TestWorld there;
    there.ground();
    there.add(BoxShape{}, {0, 1, 0});
    Archive out;
    there.world.serialize(out);
    TestWorld here;
    here.ground();
    Archive in(out.written());
    here.world.serialize(in);
    EXPECT_EQ(in.fault(), "its bodies are not those of this scene");
}

}  // namespace
}  // namespace plumbline::physics
