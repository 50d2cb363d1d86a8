// Runs of scenes as the lines that workers and studies exchange.
#include "tests/engine/study/scenes/scene_run_fixture.h"

#include <string>

namespace plumbline::study {
namespace {

TEST_F(SceneRunTest, AJobSaysWhatTheRunSays) {
    const SceneRun run = run_of(kFalling);
    const Result<SceneAnswer> here = SceneRunner().run(run);
    const Result<SceneAnswer> told = parse_scene_answer(scene_jobs()(scene_job_body(run)).value());
    ASSERT_TRUE(here);
    ASSERT_TRUE(told);
    EXPECT_EQ(told->mass_kg, here->mass_kg);
    ASSERT_EQ(told->traces.size(), 1U);
    EXPECT_EQ(told->traces[0].moments.at(2).bodies.at(0).position_m,
              here->traces[0].moments.at(2).bodies.at(0).position_m);
    EXPECT_EQ(told->traces[0].moments.at(2).energy_J, here->traces[0].moments.at(2).energy_J);
    EXPECT_EQ(told->cost.work_per_s, here->cost.work_per_s);
}

TEST_F(SceneRunTest, JobsThatAreNoneAreRefused) {
    for (const char* body : {"", "[]", "{}", "{\"scene\": 3}", "no JSON"}) {
        const Result<std::string> answer = scene_jobs()(body);
        ASSERT_FALSE(answer) << body;
        EXPECT_FALSE(answer.error().message.empty()) << body;
    }
    EXPECT_FALSE(parse_scene_answer("{"));
}

TEST_F(SceneRunTest, JobsThatCannotBeRunAreRefusedByTheirNumbers) {
    SceneRun run = run_of(kFalling);
    const auto refused = [&] {
        const Result<std::string> answer = scene_jobs()(scene_job_body(run));
        return answer ? std::string() : answer.error().message;
    };
    const std::string said = "expected a run of a scene with moments, copies and a step rate";
    run.moments.clear();
    EXPECT_EQ(refused(), said);
    run.moments = {1};
    run.copies = 0;
    EXPECT_EQ(refused(), said);
    run.copies = 1;
    run.setting.step_hz = 0;
    EXPECT_EQ(refused(), said);
    run.setting.step_hz = 60;
    EXPECT_EQ(refused(), "");
    run.scene = "/nowhere/at all.toml";
    EXPECT_NE(refused().find("at all.toml"), std::string::npos);
}

}  // namespace
}  // namespace plumbline::study
