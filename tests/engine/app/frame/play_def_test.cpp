// What of the command line holds for the next scene of a session.
#include "engine/app/frame/play_def.h"

#include <gtest/gtest.h>

namespace plumbline::app {
namespace {

PlayDef asked_for_everything() {
    PlayDef def;
    def.start_page = true;
    def.first_message = "welcome";
    def.camera_path = "path";
    def.seconds = 10.0;
    def.record = "play.tape";
    def.report = "report.json";
    def.steps.replay = "old.tape";
    def.steps.first_step = 7;
    return def;
}

TEST(NextScene, TimeRunsOnAndWhatWasOfTheSceneBeforeIsGone) {
    PlayDef def = asked_for_everything();
    continue_with_next(def, {.chosen_s = 99.0, .seconds = 4.0, .steps = 0, .report = "{}"});
    EXPECT_FALSE(def.start_page);
    EXPECT_EQ(def.first_message, "");
    EXPECT_EQ(def.camera_path, "");
    EXPECT_EQ(def.seconds, 6.0);
    EXPECT_EQ(def.steps.replay, "");
    EXPECT_EQ(def.steps.first_step, 0U);
    EXPECT_EQ(def.chosen_s, 99.0);
    EXPECT_EQ(def.report, "report.json");
    EXPECT_EQ(def.report_before, "{}");
    EXPECT_EQ(def.record, "play.tape") << "no time went on behind the start page";
}

TEST(NextScene, ARecordingIsOfTheFirstSceneInWhichTimeWentOn) {
    PlayDef def = asked_for_everything();
    testing::internal::CaptureStderr();
    continue_with_next(def, {.seconds = 4.0, .steps = 1});
    const std::string log = testing::internal::GetCapturedStderr();
    const std::string words = "a recording is of one scene: play.tape ends with the one before";
    EXPECT_EQ(def.first_message, words);
    EXPECT_NE(log.find(words), std::string::npos) << log;
    EXPECT_EQ(def.record, "");
    def.seconds.reset();
    continue_with_next(def, {.seconds = 1.0, .steps = 5});
    EXPECT_EQ(def.first_message, "") << "said once";
    EXPECT_FALSE(def.seconds.has_value());
}

}  // namespace
}  // namespace plumbline::app
