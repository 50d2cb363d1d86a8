// The accuracy panel: what it offers, and what a click in it asks for.
#include "engine/app/overlay/overlay_panels_impl.h"
#include "engine/app/ui/canvas_impl.h"
#include "tests/engine/app/session_fixture.h"

#include <gtest/gtest.h>

namespace plumbline::app {
namespace {

class AccuracyPanel : public SessionTest {
protected:
    AccuracyPanel() : session_(open()) { canvas_.resize(1280, 720, 1.0F, 0.0F); }

    AccuracyRequest frame(const AccuracyControl& control, double x, double y, bool down) {
        InputSnapshot input;
        input.now_s = now_s_ += 0.02;
        input.cursor_px = {x, y};
        input.buttons[0] = down;
        canvas_.begin(input);
        const AccuracyRequest asked =
            panels::draw_accuracy(control, clock_, canvas_.font_px(), taken_px_);
        canvas_.end();
        return asked;
    }
    /// Presses and lets go at every place of a grid over the panel; all that was asked.
    std::vector<AccuracyRequest> click_everywhere(const AccuracyControl& control) {
        std::vector<AccuracyRequest> asked;
        for (double y = 14.0; y < 718.0; y += 9.0) {
            for (const double share : {0.05, 0.45}) {
                const double x = 1280.0 - static_cast<double>(taken_px_) * (1.0 - share);
                frame(control, x, y, false);
                asked.push_back(frame(control, x, y, true));
                asked.push_back(frame(control, x, y, false));
            }
        }
        return asked;
    }

    std::unique_ptr<Session> session_;
    ui::Canvas canvas_;
    FrameClock clock_{1.0 / 60.0};
    float taken_px_{0};
    double now_s_{0};
};

TEST_F(AccuracyPanel, TakesTheRightEdgeAndAsksForNothingByItself) {
    const AccuracyControl control(*session_, false);
    for (int i = 0; i < 3; ++i) {
        const AccuracyRequest asked = frame(control, 1, 1, false);
        EXPECT_FALSE(asked.setting || asked.start_ghost || asked.stop_ghost || asked.adopt);
    }
    EXPECT_NEAR(taken_px_, canvas_.font_px() * 24.8F, 0.01F);
    canvas_.resize(200, 300, 1.0F, 0.0F);
    frame(control, 1, 1, false);
    EXPECT_NEAR(taken_px_, 200.0F - canvas_.font_px() * 0.8F, 0.01F) << "never out of the window";
}

TEST_F(AccuracyPanel, ClicksAskForASettingAGhostAndACopy) {
    const AccuracyControl control(*session_, false);
    frame(control, 1, 1, false);
    bool adopts = false;
    bool sets = false;
    std::optional<study::Setting> ghost;
    for (const AccuracyRequest& asked : click_everywhere(control)) {
        adopts = adopts || asked.adopt;
        sets = sets || (asked.setting && *asked.setting != control.setting());
        if (asked.start_ghost) ghost = asked.start_ghost;
    }
    EXPECT_TRUE(adopts);
    EXPECT_TRUE(sets);
    // Four times the rate and at least eight sub-steps, in double precision.
    ASSERT_TRUE(ghost.has_value());
    EXPECT_EQ(ghost->step_hz, std::min(4 * control.setting().step_hz, 480));
    EXPECT_EQ(ghost->substeps, std::max(8, 2 * control.setting().substeps));
    EXPECT_EQ(ghost->precision, study::Precision::Float64);
}

TEST_F(AccuracyPanel, ARecordingKeepsItsSetting) {
    const AccuracyControl control(*session_, true);
    frame(control, 1, 1, false);
    for (const AccuracyRequest& asked : click_everywhere(control)) EXPECT_FALSE(asked.setting);
}

}  // namespace
}  // namespace plumbline::app
