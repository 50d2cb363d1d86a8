#include "engine/study/setting.h"

#include <gtest/gtest.h>

namespace plumbline::study {
namespace {

using physics::Solver;

TEST(Setting, TextSaysWhatIsAsked) {
    EXPECT_EQ(setting_text({}), "small_step 60 Hz x 2-16, float32");
    EXPECT_EQ(setting_text({.step_hz = 120, .substeps = 4, .iterations = 2}),
              "small_step 120 Hz x 4, 2 it, float32");
    EXPECT_EQ(setting_text({.solver = Solver::BulletSi,
                            .substeps = 1,
                            .iterations = 10,
                            .precision = Precision::Float64}),
              "bullet_si 60 Hz x 1, 10 it, float64");
    EXPECT_EQ(setting_text({.fidelity = {{"cloth", scene::Fidelity::Draft}}}),
              "small_step 60 Hz x 2-16, float32, cloth draft");
}

TEST(Setting, LinesAreKeysOfAccuracy) {
    EXPECT_EQ(accuracy_lines({.substeps_max = 8}),
              "solver = \"small_step\"\nstep_hz = 60\nsubsteps = 2\nsubsteps_max = 8\n"
              "iterations = 1\n");
    EXPECT_EQ(accuracy_lines({.solver = Solver::BulletNncg, .substeps = 1, .iterations = 20}),
              "solver = \"bullet_nncg\"\nstep_hz = 60\nsubsteps = 1\niterations = 20\n");
    EXPECT_TRUE(accuracy_lines({.fidelity = {{"rope", scene::Fidelity::Precise}}})
                    .ends_with("iterations = 1\n[effects.rope]\nfidelity = \"precise\"\n"));
}

TEST(Setting, AWorldAndASceneGetTheSame) {
    const Setting settings[] = {{},
                                {.substeps_max = 1},
                                {.step_hz = 240, .substeps = 16, .iterations = 3},
                                {.solver = Solver::BulletDantzig, .substeps = 4, .iterations = 50}};
    for (const Setting& setting : settings) {
        const physics::WorldDef own = world_def(setting);
        const physics::WorldDef of_scene =
            scene::world_def(scene::SceneDescription{}, overrides(setting));
        EXPECT_EQ(own.solver, of_scene.solver) << setting_text(setting);
        EXPECT_EQ(own.step_s, of_scene.step_s) << setting_text(setting);
        EXPECT_EQ(own.substeps, of_scene.substeps) << setting_text(setting);
        EXPECT_EQ(own.substeps_max, of_scene.substeps_max) << setting_text(setting);
        EXPECT_EQ(own.iterations, of_scene.iterations) << setting_text(setting);
        EXPECT_LE(own.substeps, own.substeps_max) << setting_text(setting);
    }
}

}  // namespace
}  // namespace plumbline::study
