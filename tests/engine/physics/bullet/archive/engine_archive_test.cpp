// The engine of a saved game.
#include "engine/core/io/archive.h"
#include "tests/engine/physics/test_world.h"

#include <cstdint>
#include <string>
#include <vector>

namespace plumbline::physics {
namespace {

/// A pair of joined boxes, a wheel on a motor, and a box that has slept for a while.
struct SavedWorld {
    TestWorld test;
    std::vector<BodyId> ids;

    explicit SavedWorld(Solver solver)
        : test(WorldDef{.iterations = solver == Solver::SmallStep ? 1 : 10, .solver = solver}) {
        // On a mesh Bullet's own boxes never come to rest.
        if (solver == Solver::SmallStep)
            test.add(flat_mesh(6, 1), {0, 0, 0}, {.kind = BodyKind::Static});
        else
            test.ground();
        for (const Real x : {-2.0_r, -1.0_r, 2.0_r})
            ids.push_back(test.add(BoxShape{}, {x, 0.5_r, 0}));
        ids.push_back(test.add(SphereShape{}, {0, 4, 0}));
        EXPECT_TRUE(test.world
                        .create_joint({.kind = JointKind::Hinge,
                                       .a = ids[0],
                                       .b = ids[1],
                                       .anchor_a_world = {-1.5_r, 1, 0},
                                       .anchor_b_world = {-1.5_r, 1, 0}})
                        .ok());
        EXPECT_TRUE(test.world
                        .create_joint({.kind = JointKind::Hinge,
                                       .a = ids[3],
                                       .anchor_a_world = {0, 4, 0},
                                       .anchor_b_world = {0, 4, 0},
                                       .motor = JointMotor{.target = 3, .max = 50}})
                        .ok());
    }
};

TEST(EngineArchive, SleepConstraintsAndMotorsComeBack) {
    for (const Solver solver : {Solver::SmallStep, Solver::BulletSi}) {
        SCOPED_TRACE(solver_name(solver));
        SavedWorld there(solver);
        there.test.run(2.5);
        ASSERT_FALSE(there.test.world.state(there.ids[2]).awake);
        Archive out;
        there.test.world.serialize(out);
        SavedWorld here(solver);
        Archive in(out.written());
        here.test.world.serialize(in);
        ASSERT_FALSE(in.failed()) << in.fault();
        EXPECT_FALSE(here.test.world.state(here.ids[2]).awake);
        here.test.run(0.5);
        there.test.run(0.5);
        EXPECT_EQ(here.test.hash(here.ids), there.test.hash(there.ids));
        EXPECT_NEAR(glm::length(here.test.spin(here.ids[3])), 3, 1e-2);
    }
}

// A damaged file is refused or read; either way the world may be stepped or thrown away.
TEST(EngineArchive, DamageIsNeverFatal) {
    for (const Solver solver : {Solver::SmallStep, Solver::BulletSi}) {
        SavedWorld there(solver);
        there.test.run(0.5);
        Archive out;
        there.test.world.serialize(out);
        const std::string good(out.written());
        std::uint32_t state = 7;
        const auto next = [&] { return state = state * 1664525U + 1013904223U; };
        int refused = 0;
        for (int round = 0; round < 25; ++round) {
            std::string bad = good;
            bad[(next() >> 8U) % bad.size()] = static_cast<char>(next() >> 24U);
            SavedWorld here(solver);
            Archive in(bad);
            here.test.world.serialize(in);
            refused += in.failed() ? 1 : 0;
            if (!in.failed()) here.test.world.step();
        }
        EXPECT_LT(refused, 25) << "most bytes are numbers of bodies";
    }
}

}  // namespace
}  // namespace plumbline::physics
