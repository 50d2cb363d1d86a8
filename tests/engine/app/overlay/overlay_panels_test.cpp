// What is written over the image, line by line.
#include "engine/app/overlay/overlay_panels_impl.h"
#include "tests/engine/app/session_fixture.h"

#include <gtest/gtest.h>

namespace plumbline::app {
namespace {

class OverlayPanels : public SessionTest {
protected:
    OverlayPanels() : session_(open()), accuracy_(*session_, false) {}

    OverlayInput input() {
        return {.parts = parts_,
                .hud = hud_,
                .simulation = *session_->simulation,
                .report = report_,
                .clock = clock_,
                .bindings = bindings_,
                .device = input::LastDevice::KeyboardMouse,
                .ledger = ledger_,
                .accuracy = accuracy_};
    }
    static std::vector<std::string> words_of(const std::vector<ui::HudLine>& lines) {
        std::vector<std::string> words;
        for (const ui::HudLine& line : lines) words.push_back(line.text);
        return words;
    }

    std::unique_ptr<Session> session_;
    AccuracyControl accuracy_;
    OverlayParts parts_;
    scene::HudContent hud_;
    FrameReport report_;
    FrameClock clock_{1.0 / 60.0};
    input::Bindings bindings_{input::built_in_bindings()};
    std::vector<effects::LedgerLine> ledger_;
};

using Words = std::vector<std::string>;

TEST_F(OverlayPanels, NothingIsWrittenWhereAllIsAsUsualOrTheHudIsHidden) {
    const ui::HudTexts plain = panels::hud_texts(input());
    for (const auto& lines : {plain.status, plain.verdict, plain.side, plain.target, plain.hint})
        EXPECT_TRUE(lines.empty());
    parts_.hud = false;
    hud_.chosen_thing = "barrel";
    OverlayInput full = input();
    full.captions = {"a bell"};
    full.hint = FirstStep::Walk;
    const ui::HudTexts hidden = panels::hud_texts(full);
    EXPECT_TRUE(hidden.status.empty());
    EXPECT_TRUE(hidden.hint.empty());
    EXPECT_TRUE(hidden.captions.empty());
}

TEST_F(OverlayPanels, TheStatusNamesWhatIsNotAsUsual) {
    hud_.chosen_thing = "barrel";
    clock_.set_paused(true);
    clock_.set_speed(0.5);
    OverlayInput now = input();
    now.camera_path = "a path is recorded";
    now.sound_silent = true;
    now.lines_not_shown = 12;
    EXPECT_EQ(words_of(panels::hud_texts(now).status),
              Words{"Q: barrel   a path is recorded   paused   speed 0.5x   no sound device   "
                    "12 lines not shown"});
}

TEST_F(OverlayPanels, AHintNamesTheKeysOfWhatIsToBeDone) {
    OverlayInput now = input();
    now.hint = FirstStep::Walk;
    EXPECT_TRUE(panels::hud_texts(now).hint.at(0).text.starts_with("W A S D: "));
    now.hint = FirstStep::Drop;
    EXPECT_TRUE(panels::hud_texts(now).hint.at(0).text.starts_with("Q: "));
}

TEST_F(OverlayPanels, AGoalTellsHowItStandsAndHowItEnded) {
    hud_.goal = scene::GoalState{
        .text = "knock them over", .counted = 3, .wanted = 5, .left_s = 61.2, .throws_left = 2};
    EXPECT_EQ(words_of(panels::hud_texts(input()).verdict),
              (Words{"knock them over", "3 of 5   1:02 left   2 throws left"}));
    hud_.goal = scene::GoalState{.text = "knock them over",
                                 .counted = 7,
                                 .wanted = 5,
                                 .end = scene::GoalEnd::Won,
                                 .passed_s = 12.34};
    const std::vector<ui::HudLine> won = panels::hud_texts(input()).verdict;
    EXPECT_EQ(words_of(won), (Words{"knock them over", "5 of 5", "Won in 12.3 s   R: play again"}));
    EXPECT_EQ(won[2].tone, ui::Tone::Good);
    hud_.goal->end = scene::GoalEnd::Lost;
    EXPECT_EQ(panels::hud_texts(input()).verdict[2].text, "Lost   R: play again");
    EXPECT_EQ(panels::hud_texts(input()).verdict[2].tone, ui::Tone::Bad);
}

TEST_F(OverlayPanels, WhatIsLookedAtStandsBelowACrosshairOnly) {
    hud_.looking_at = "oak crate, 30 kg";
    EXPECT_EQ(words_of(panels::hud_texts(input()).target), Words{"oak crate, 30 kg"});
    hud_.crosshair = false;
    EXPECT_TRUE(panels::hud_texts(input()).target.empty());
}

TEST_F(OverlayPanels, StatisticsSayWhatIsNotMeasuredAndWhichEffectsExist) {
    parts_.stats = true;
    report_.add_frame(20.0,
                      {.passes = {{.name = "opaque", .cpu_ms = 1.25}, {"sky", 0.5, 0.25}},
                       .draw_calls = 7,
                       .triangles = 12,
                       .instances = 3,
                       .shadowed_lights = 4,
                       .unshadowed_lights = 2,
                       .scene_width_px = 640,
                       .scene_height_px = 360});
    ledger_ = {{.name = "fog", .calls = 9, .cpu_ms = 0.5, .exists = true},
               {.name = "grass", .exists = false}};
    const Words side = words_of(panels::hud_texts(input()).side);
    const auto has = [&](std::string_view line) {
        return std::ranges::find(side, line) != side.end();
    };
    EXPECT_TRUE(has("50.0 frames/s   frame 20.0 ms   p95 20.0   p99 20.0")) << side[0];
    EXPECT_TRUE(has("image full  640 x 360"));
    EXPECT_TRUE(has("7 draws  12 triangles  3 instances  shadow maps 0 drawn 0 kept"));
    EXPECT_TRUE(has("shadows of 4 lamps, 2 in sight go without"));
    EXPECT_TRUE(has("opaque: cpu 1.25  gpu - ms"));
    EXPECT_TRUE(has("sky: cpu 0.50  gpu 0.25 ms"));
    EXPECT_TRUE(has("fog: 9 calls  0.50 ms"));
    EXPECT_TRUE(std::ranges::none_of(
        side, [](const std::string& line) { return line.starts_with("grass"); }));
    EXPECT_TRUE(std::ranges::any_of(side, [](const std::string& line) {
        return line.starts_with("60 Hz x") && line.find("2 bodies, 2 awake") != line.npos;
    }));
}

TEST(MessageLines, FadeInTheirLastSecondUnlessMotionIsReduced) {
    const std::deque<panels::Message> messages{{"old", 10.5}, {"new", 14.0}, {"past", 9.0}};
    const auto lines = panels::message_lines(messages, 10.0, false);
    ASSERT_EQ(lines.size(), 3U);
    EXPECT_EQ(lines[0].text, "old");
    EXPECT_FLOAT_EQ(lines[0].alpha, 0.5F);
    EXPECT_FLOAT_EQ(lines[1].alpha, 1.0F);
    EXPECT_FLOAT_EQ(lines[2].alpha, 0.05F) << "hardly seen in its last frame";
    EXPECT_FLOAT_EQ(panels::message_lines(messages, 10.0, true)[0].alpha, 1.0F);
    EXPECT_EQ(panels::stem_of("light: 80 %"), "light: ");
    EXPECT_EQ(panels::stem_of("paused"), "paused");
}

}  // namespace
}  // namespace plumbline::app
