// Runs of small scenes, held against what can be worked out.
#include "tests/engine/study/scenes/scene_run_fixture.h"

#include <cmath>

namespace plumbline::study {
namespace {

TEST_F(SceneRunTest, AFallingBallIsWhereGalileoSays) {
    SceneRun run = run_of(kFalling);
    for (const int step_hz : {30, 60, 240}) {
        run.setting.step_hz = step_hz;
        const Result<SceneAnswer> answer = SceneRunner().run(run);
        ASSERT_TRUE(answer);
        EXPECT_EQ(answer->bodies, 1U);
        EXPECT_NEAR(answer->body_size_m, std::sqrt(3.0), 0.1);
        const Trace& trace = answer->traces.at(0);
        ASSERT_EQ(trace.status, RunStatus::Done);
        ASSERT_EQ(trace.moments.size(), 3U);
        for (const Moment& moment : trace.moments) {
            const double t = moment.time_s;
            EXPECT_NEAR(moment.bodies.at(0).position_m.x, 1 + 3 * t, 1e-4);
            EXPECT_NEAR(moment.bodies.at(0).position_m.y, 100 - 0.5 * 9.81 * t * t, 1e-3);
            EXPECT_NEAR(moment.layout.center_m.y, moment.bodies.at(0).position_m.y, 1e-9);
        }
        EXPECT_NEAR(trace.moments[1].time_s, 0.5, 1e-9);
        EXPECT_NEAR(trace.end_s, 1.0, 1e-9);
        // From 9 J of sideways speed to that and what a fall of 1 s gives.
        EXPECT_NEAR(trace.energy_turnover_J, 9 + 9.81 * 9.81, 0.1);
        EXPECT_EQ(trace.penetration_m, 0.0);
    }
}

TEST_F(SceneRunTest, EffectsWhoseFidelityIsOpenAreListed) {
    const std::string dragged = std::string(kFalling) + "drag = {}\n";
    SceneRun run = run_of(dragged);
    const Result<SceneAnswer> open = SceneRunner().run(run);
    ASSERT_TRUE(open);
    EXPECT_EQ(open->effects, std::vector<std::string>{"drag"});
    run.setting.fidelity = {{"drag", scene::Fidelity::Draft}};
    const Result<SceneAnswer> coarse = SceneRunner().run(run);
    ASSERT_TRUE(coarse);
    EXPECT_NE(coarse->traces[0].moments[1].bodies.at(0).position_m.y,
              open->traces[0].moments[1].bodies.at(0).position_m.y);
    run = run_of(dragged + "[effects.drag]\nfidelity = \"precise\"\n");
    const Result<SceneAnswer> given = SceneRunner().run(run);
    ASSERT_TRUE(given);
    EXPECT_TRUE(given->effects.empty());
}

TEST_F(SceneRunTest, RepeatsAreForTheClockAlone) {
    SceneRun run = run_of(kFalling);
    run.repeats = 3;
    const Result<SceneAnswer> answer = SceneRunner().run(run);
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->traces.size(), 1U);
    EXPECT_EQ(answer->cost.repeats, 3);  // the first one warmed up
    EXPECT_GT(answer->cost.ms_per_s_min, 0.0);
    EXPECT_GE(answer->cost.ms_per_s_median, answer->cost.ms_per_s_min);
    EXPECT_GE(answer->cost.ms_per_s_max, answer->cost.ms_per_s_median);
}

TEST_F(SceneRunTest, CopiesStartWithinTheirShift) {
    SceneRun run = run_of(kFalling);
    run.copies = 4;
    run.shift_m = 1e-3;
    const Result<SceneAnswer> answer = SceneRunner().run(run);
    ASSERT_TRUE(answer);
    ASSERT_EQ(answer->traces.size(), 4U);
    for (const Trace& trace : answer->traces) {
        const Vec3d start = trace.moments[0].bodies.at(0).position_m;
        EXPECT_LE(std::abs(start.x - 1.0), 1.1e-3);
        EXPECT_NE(start.x,
                  answer->traces[(&trace == &answer->traces[0]) ? 1 : 0]
                      .moments[0]
                      .bodies.at(0)
                      .position_m.x);
    }
}

TEST_F(SceneRunTest, ASceneWhereNothingMovesIsRefused) {
    const SceneRun run = run_of(
        "[[entity]]\nname = \"floor\"\n[entity.body]\nkind = \"static\"\n"
        "shape = { box = [9, 1, 9] }\n");
    const Result<SceneAnswer> answer = SceneRunner().run(run);
    ASSERT_FALSE(answer);
    EXPECT_EQ(answer.error().exit_code, ExitCode::Refused);
    EXPECT_NE(answer.error().message.find("nothing in it moves"), std::string::npos);
}

TEST_F(SceneRunTest, TooMuchTimeStopsIt) {
    SceneRun run = run_of(kFalling);
    run.cpu_limit_s = 0;
    const Result<SceneAnswer> answer = SceneRunner().run(run);
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->traces.at(0).status, RunStatus::TimedOut);
    EXPECT_LT(answer->traces[0].end_s, 1.0);
    EXPECT_LT(answer->traces[0].moments.size(), 3U);
}

}  // namespace
}  // namespace plumbline::study
