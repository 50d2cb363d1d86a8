// What is written over the image, line by line.
#include "tests/engine/app/overlay/overlay_fixture.h"

namespace plumbline::app {
namespace {

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
    now.lines_not_shown = 12;
    EXPECT_EQ(words_of(panels::hud_texts(now).status),
              Words{"Q: barrel   a path is recorded   paused   speed 0.5x   "
                    "12 debug lines not shown"});
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

}  // namespace
}  // namespace plumbline::app
