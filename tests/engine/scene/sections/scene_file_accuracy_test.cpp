#include "engine/scene/accuracy.h"
#include "tests/engine/scene/sections/scene_file_fixture.h"

namespace plumbline::scene {
namespace {

TEST_F(SceneFileTest, AccuracyKeysOverrideThePreset) {
    const Outcome outcome = load(R"([accuracy]
preset = "precise"
iterations = 33
solver = "bullet_dantzig"
tolerance = 0.02
)");
    ASSERT_TRUE(outcome.scene.ok());
    const Accuracy& accuracy = outcome.scene->accuracy;
    EXPECT_EQ(accuracy.preset, "precise");
    EXPECT_EQ(accuracy.step_hz, 120);
    EXPECT_FALSE(accuracy.substeps);
    EXPECT_EQ(accuracy.iterations, 33);
    EXPECT_EQ(accuracy.solver, physics::Solver::BulletDantzig);
    EXPECT_NEAR(accuracy.tolerance.value_or(0), 0.02, 1e-6);
}

TEST_F(SceneFileTest, AutoTakesAToleranceOrABudget) {
    const Outcome outcome = load("[accuracy]\npreset = \"auto\"\nbudget_ms = 0.5\nstep_hz = 120\n");
    ASSERT_TRUE(outcome.scene.ok());
    EXPECT_TRUE(outcome.faults.empty());
    const Accuracy& accuracy = outcome.scene->accuracy;
    EXPECT_NEAR(accuracy.budget_ms.value_or(0), 0.5, 1e-6);
    EXPECT_FALSE(accuracy.tolerance);
    EXPECT_TRUE(accuracy.step_hz_given);
    EXPECT_FALSE(accuracy.solver_given);
    EXPECT_FALSE(load("[accuracy]\nbudget_ms = 1\ntolerance = 0.1\n").scene.ok());
    EXPECT_FALSE(load("[accuracy]\nbudget_ms = 0\n").scene.ok());
}

TEST_F(SceneFileTest, PresetsGetFinerFromDraftToReference) {
    double last = 0;
    for (const char* preset : {"draft", "balanced", "precise", "reference"}) {
        const Outcome outcome = load(fmt::format("[accuracy]\npreset = \"{}\"\n", preset));
        ASSERT_TRUE(outcome.scene.ok());
        EXPECT_TRUE(outcome.faults.empty());
        const physics::WorldDef def = world_def(*outcome.scene, {});
        const double work = def.substeps * def.iterations / def.step_s;
        EXPECT_GT(work, last) << preset;
        last = work;
    }
}

TEST_F(SceneFileTest, SolversByName) {
    using physics::Solver;
    for (const auto& [name, solver] : {std::pair{"bullet_si", Solver::BulletSi},
                                       std::pair{"bullet_nncg", Solver::BulletNncg},
                                       std::pair{"bullet_dantzig", Solver::BulletDantzig},
                                       std::pair{"bullet_pgs", Solver::BulletPgs}}) {
        const Outcome outcome = load(fmt::format("[accuracy]\nsolver = \"{}\"\n", name));
        ASSERT_TRUE(outcome.scene.ok());
        EXPECT_EQ(outcome.scene->accuracy.solver, solver) << name;
    }
}

TEST_F(SceneFileTest, NumbersOfTheFileGoBeforeThePresets) {
    const Outcome outcome =
        load("[accuracy]\nstep_hz = 120\nsubsteps = 4\niterations = 1\nsolver = \"small_step\"\n");
    ASSERT_TRUE(outcome.scene.ok());
    EXPECT_EQ(outcome.scene->accuracy.solver, physics::Solver::SmallStep);
    const physics::WorldDef def = world_def(*outcome.scene, {});
    EXPECT_DOUBLE_EQ(def.step_s, 1.0 / 120);
    EXPECT_EQ(def.substeps, 4);
    EXPECT_EQ(def.substeps_max, 4) << "a number alone means exactly so many";
    EXPECT_EQ(def.iterations, 1);
    EXPECT_TRUE(outcome.faults.empty());
}

TEST_F(SceneFileTest, PresetsKeepTheirShortestSubstepAtLowerRates) {
    const auto most_at = [this](const char* preset, int step_hz) {
        const Outcome outcome = load(fmt::format("[accuracy]\npreset = \"{}\"\n", preset));
        return world_def(*outcome.scene, {.step_hz = step_hz}).substeps_max;
    };
    EXPECT_EQ(most_at("balanced", 60), 16);
    EXPECT_EQ(most_at("balanced", 30), 32);
    EXPECT_EQ(most_at("balanced", 50), 20);
    EXPECT_EQ(most_at("balanced", 240), 16);
    EXPECT_EQ(most_at("precise", 60), 64);
    EXPECT_EQ(most_at("precise", 30), 64) << "no more than an island may have";
    const Outcome own = load("[accuracy]\nsubsteps = 2\nsubsteps_max = 8\n");
    EXPECT_EQ(world_def(*own.scene, {.step_hz = 30}).substeps_max, 8);
}

TEST_F(SceneFileTest, ThreadsAreANumberOrByTheMachine) {
    const auto threads_of = [this](const char* text, std::optional<int> over = {}) {
        const Outcome outcome = load(fmt::format("[accuracy]\n{}\n", text));
        EXPECT_TRUE(outcome.scene.ok() && outcome.faults.empty()) << text;
        return world_def(*outcome.scene, {.threads = over}).threads;
    };
    EXPECT_EQ(threads_of(""), 1);
    EXPECT_EQ(threads_of("threads = 3"), 3);
    EXPECT_EQ(threads_of("threads = 64"), 64);
    EXPECT_GE(threads_of("threads = \"auto\""), 1);
    EXPECT_EQ(threads_of("threads = 3", 2), 2);
    EXPECT_GE(threads_of("threads = 64", kAutoThreads), 1);
    for (const char* bad : {"0", "-1", "65", "1000", "2.5", "\"many\"", "true", "[2]"}) {
        const Outcome outcome = load(fmt::format("[accuracy]\nthreads = {}\n", bad));
        EXPECT_FALSE(outcome.scene.ok()) << bad;
        ASSERT_EQ(outcome.faults.size(), 1U) << bad;
        EXPECT_NE(outcome.faults.front().find("64"), std::string::npos) << outcome.faults.front();
    }
}

TEST_F(SceneFileTest, NumbersDoNotCarryOverToTheOtherKindOfSolver) {
    const Outcome outcome = load("[accuracy]\nsubsteps = 4\nsubsteps_max = 8\niterations = 1\n");
    ASSERT_TRUE(outcome.scene.ok());
    const physics::WorldDef own = world_def(*outcome.scene, {});
    EXPECT_EQ(own.substeps, 4);
    EXPECT_EQ(own.substeps_max, 8);
    const physics::WorldDef other =
        world_def(*outcome.scene, {.solver = physics::Solver::BulletSi});
    EXPECT_EQ(other.substeps, 1);
    EXPECT_EQ(other.iterations, 10);
}

}  // namespace
}  // namespace plumbline::scene
