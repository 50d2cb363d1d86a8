#include "engine/app/accuracy/accuracy_control.h"

#include "engine/core/io/files.h"
#include "engine/scene/scene_file.h"
#include "tests/engine/app/session_fixture.h"

#include <gtest/gtest.h>

namespace plumbline::app {
namespace {

const std::string kCase = "[scene]\ntitle = \"H99 a cube in the air\"\n" +
                          cube_text("cube", "0, 50, 0") +
                          R"([hard_case]
id = "H99"
shows = "A cube that falls."
known_to_fail = "nobody"
seconds = 1
[[hard_case.pass]]
measure = "height_m"
of = ["cube"]
above = 1
)";

void step(Session& session, AccuracyControl& accuracy, int times) {
    for (int i = 0; i < times; ++i) {
        effects::advance(*session.simulation, *session.effects, *session.game, {});
        if (session.judge) session.judge->after_step(*session.simulation);
        accuracy.after_step();
    }
}

// What the panel shows is of the setting in force, from the case's start.
TEST_F(SessionTest, AnotherSettingStartsAHardCaseAnew) {
    folder_.write("scene.toml", kCase);
    const auto session = open();
    ASSERT_TRUE(session && session->judge);
    AccuracyControl accuracy(*session);
    accuracy.watch(true);
    step(*session, accuracy, 61);
    EXPECT_TRUE(session->judge->has_ended());
    EXPECT_EQ(session->judge->verdict(), study::Verdict::Pass);
    const FrameClock clock(session->simulation->step_s());
    EXPECT_GT(accuracy.gauges(clock).cost.step_ms.size(), 50U);
    const study::Setting other{
        .solver = physics::Solver::BulletSi, .step_hz = 120, .substeps = 1, .substeps_max = 1};
    ASSERT_TRUE(session->apply(SetAccuracy{other}).ok());
    EXPECT_EQ(session->judge->verdict(), study::Verdict::Undecided);
    EXPECT_FALSE(session->judge->has_ended());
    EXPECT_EQ(session->simulation->steps(), 0U);
    EXPECT_EQ(accuracy.setting(), other);
    accuracy.take_answers();
    EXPECT_TRUE(accuracy.gauges(clock).cost.step_ms.empty()) << "those of the world before";
    ASSERT_TRUE(session->apply(StartAgain{}).ok());
    EXPECT_EQ(accuracy.setting(), other) << "until another scene is opened";
    ASSERT_TRUE(session->reload().ok());
    EXPECT_EQ(accuracy.setting().solver, physics::Solver::SmallStep) << "the file's own";
}

}  // namespace
}  // namespace plumbline::app
