#include "engine/scene/simulation/entity_lookup.h"
#include "engine/study/ghost/ghost.h"
#include "engine/study/workers/worker_pool.h"
#include "tests/scenarios/scene_run.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace plumbline::study {
namespace {

using test::SceneRun;

std::filesystem::path scene(const std::string& name) {
    return test::repository() / "assets/scenes" / name;
}

GhostStart start_of(SceneRun& run, const std::string& name, const Setting& setting) {
    GhostStart start{
        .scene = scene(name), .setting = setting, .from = scene_start_of(*run.simulation)};
    for (const scene::MovingBody& moving : run.simulation->moving_bodies()) {
        const physics::BodyState state = run.simulation->physics.state(moving.body);
        start.bodies.push_back(
            {.name = name_of_mark(*run.simulation, scene::mark_of(moving.entity)),
             .position_m = Vec3d(state.world_from_body.position),
             .orientation = Quatd(state.world_from_body.orientation)});
    }
    return start;
}

double largest_m(const GhostState& ghost, const SceneRun& run) {
    double largest = 0;
    for (std::size_t i = 0; i < ghost.bodies.size(); ++i) {
        const physics::BodyId body = run.simulation->moving_bodies()[i].body;
        largest = std::max(
            largest,
            glm::distance(ghost.bodies[i].position_m,
                          Vec3d(run.simulation->physics.state(body).world_from_body.position)));
    }
    return largest;
}

class GhostJob : public testing::Test {
protected:
    GhostJob() { ::setenv("PLUMBLINE_DATA", PL_SOURCE_DIR, 1); }
    GhostState answer(const std::string& body) {
        const Result<GhostState> state = parse_ghost_state(reply(body));
        EXPECT_TRUE(state.ok());
        return state ? *state : GhostState{};
    }

    std::string reply(const std::string& body) { return run_ghost_job_(body).value(); }

private:
    RunJob run_ghost_job_{ghost_jobs()};
};

TEST_F(GhostJob, AGhostOfTheSameSettingGoesTheSameWay) {
    const std::string name = "bench/peers/heavy10.toml";
    SceneRun run(name);
    run.step(30);
    const GhostState start = answer(start_body(start_of(run, name, {})));
    EXPECT_DOUBLE_EQ(start.time_s, 0.5);
    EXPECT_EQ(largest_m(start, run), 0);
    const GhostState later = answer(go_on_body(0.5));
    run.step(30);
    EXPECT_DOUBLE_EQ(later.time_s, 1.0);
    // It starts from the visible world's impulses too.
    EXPECT_EQ(largest_m(later, run), 0);
    EXPECT_GT(later.cpu_ms, 0);
}

TEST_F(GhostJob, AFallIsTheSameAtEveryRate) {
    SceneRun run("falling_cube.toml");
    run.step(6);
    answer(start_body(start_of(run, "falling_cube.toml", {.step_hz = 240, .substeps = 8})));
    const GhostState later = answer(go_on_body(0.5));
    run.step(30);
    EXPECT_NEAR(later.time_s, run.simulation->time_s(), 1e-9);
    EXPECT_LT(largest_m(later, run), 1e-5);
}

TEST_F(GhostJob, ThingsFallWhatNobodyKnowsStaysAndWhatIsGoneGoes) {
    SceneRun run("bench/peers/heavy10.toml");
    run.step(30);
    ASSERT_GE(run.simulation->moving_bodies().size(), 2U);
    // Without what it carries the upper one falls; play drops a thing beside.
    run.simulation->registry.destroy(run.simulation->moving_bodies()[0].entity);
    scene::EntityDescription crate;
    crate.name = "oddity";
    crate.world_from_body.position = {3, 2, 1};
    crate.visual = scene::Primitive{physics::BoxShape{}};
    crate.body.emplace();
    crate.body->kind = physics::BodyKind::Dynamic;
    run.simulation->spawn(crate);
    crate.name = "crate";
    crate.world_from_body.position = {-3, 2, 1};
    run.simulation->spawn(crate);
    run.step(1);
    GhostStart start = start_of(run, "bench/peers/heavy10.toml", {});
    const std::size_t oddity = start.bodies.size() - 2;
    const Vec3d there = start.bodies[oddity].position_m;
    answer(start_body(start));
    const GhostState later = answer(go_on_body(0.5));
    ASSERT_EQ(later.bodies.size(), start.bodies.size());
    EXPECT_EQ(start.bodies[oddity].name, "oddity#1");
    EXPECT_EQ(later.bodies[oddity].position_m, there) << "of no prefab that is known";
    EXPECT_EQ(start.bodies.back().name, "crate#1");
    EXPECT_LT(later.bodies.back().position_m.y, 1.7) << "one of the things for every scene";
    run.step(30);
    EXPECT_LT(
        glm::distance(later.bodies[0].position_m,
                      Vec3d(run.simulation->physics.state(run.simulation->moving_bodies()[0].body)
                                .world_from_body.position)),
        1e-3);
}

TEST_F(GhostJob, RefusesWhatItCannotDo) {
    EXPECT_THROW(reply("{}"), std::exception);
    GhostStart nowhere{.scene = "/nowhere/at/all.toml"};
    EXPECT_THROW(reply(start_body(nowhere)), std::exception);
    EXPECT_THROW(reply(go_on_body(1)), std::exception);
    EXPECT_FALSE(parse_ghost_state("[]").ok());
}

TEST_F(GhostJob, BytesThatAreNoneAreRefused) {
    SceneRun run("falling_cube.toml");
    const std::string good = start_body(start_of(run, "falling_cube.toml", {}));
    EXPECT_NO_THROW(reply(good));
    const auto with = [&](const std::string& from, const std::string& to) {
        std::string text = good;
        return text.replace(text.find(from), from.size(), to);
    };
    EXPECT_THROW(reply(with("\"world\":\"", "\"world\":\"zz")), std::exception);
    EXPECT_THROW(reply(with("\"world\":\"", "\"world\":\"ffffffff")), std::exception);
    EXPECT_THROW(reply(with("small_step", "big_step")), std::exception);
    EXPECT_THROW(reply(go_on_body(1)), std::exception) << "no world is left of it";
    EXPECT_NO_THROW(reply(good));
    EXPECT_EQ(answer(go_on_body(1e-9)).time_s, 1.0 / 60) << "one step at least";
}

}  // namespace
}  // namespace plumbline::study
