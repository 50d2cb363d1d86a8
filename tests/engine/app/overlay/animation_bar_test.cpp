// The bar under a model with animations, clicked as a person would.
#include "engine/app/overlay/overlay_panels_impl.h"
#include "engine/app/ui/canvas_impl.h"

#include <gtest/gtest.h>

namespace plumbline::app {
namespace {

class AnimationBarTest : public testing::Test {
protected:
    AnimationBarTest() { canvas_.resize(1280, 720, 1.0F, 0.0F); }

    /// One frame with the pointer there; the height that the bar takes.
    double frame(double x, double y, bool down) {
        InputSnapshot input;
        input.now_s = now_s_ += 0.02;
        input.cursor_px = {x, y};
        input.buttons[0] = down;
        canvas_.begin(input);
        Requests requests;
        const float taken = panels::draw_animation_bar(bar_, canvas_.font_px(), requests);
        for (const Request& request : requests)
            asked_ = std::get<SetAnimation>(std::get<WorldRequest>(request));
        const ImGuiIO& io = ImGui::GetIO();
        wants_mouse_ = io.WantCaptureMouse;
        canvas_.end();
        return static_cast<double>(taken);
    }
    void click(double x, double y) {
        frame(x, y, false);
        frame(x, y, false);
        frame(x, y, true);
        frame(x, y, false);
    }

    double font_px() const { return static_cast<double>(canvas_.font_px()); }

    ui::Canvas canvas_;
    AnimationBar bar_{.name = "walk", .length_s = 2.0, .time_s = 0.5};
    std::optional<SetAnimation> asked_{};  ///< the latest
    double now_s_{0};
    bool wants_mouse_{false};
};

TEST_F(AnimationBarTest, StandsInTheMiddleOfTheBottomAndTakesItsHeight) {
    frame(1, 1, false);
    const double taken = frame(1, 1, false);
    EXPECT_GT(taken, font_px());
    EXPECT_LT(taken, font_px() * 5.0);
    const double y = 720.0 - font_px() * 0.8 - 5.0;
    for (const double x : {640.0, 640.0 - 350.0, 640.0 + 350.0}) {
        frame(x, y, false);
        frame(x, y, false);
        EXPECT_TRUE(wants_mouse_) << x;
    }
    frame(640.0, 720.0 - taken - 10.0, false);
    frame(640.0, 720.0 - taken - 10.0, false);
    EXPECT_FALSE(wants_mouse_);
}

TEST_F(AnimationBarTest, ItsButtonsStopAndGoToTheNextAndItsSliderSetsTheTime) {
    const double taken = frame(1, 1, false);
    const double y = 720.0 - font_px() * 0.8 - (taken - font_px() * 0.8) * 0.5;
    const double left = 640.0 - std::min(1280.0 * 0.7, font_px() * 44.0) * 0.5;
    EXPECT_FALSE(asked_) << "nothing is asked for by itself";
    click(left + 25.0, y);
    EXPECT_EQ(asked_, (SetAnimation{.time_s = 0.5, .paused = true}));
    bar_.paused = true;
    click(left + 25.0, y);
    EXPECT_EQ(asked_, (SetAnimation{.time_s = 0.5, .paused = false}));
    click(left + 75.0, y);
    EXPECT_EQ(asked_, (SetAnimation{.time_s = 0, .paused = true, .next = true}));
    const double right = 1280.0 - left;
    frame(right - 60.0, y, false);
    frame(right - 60.0, y, false);
    frame(right - 60.0, y, true);
    frame(2000.0, y, true);  // dragged beyond its end
    frame(2000.0, y, true);
    EXPECT_EQ(asked_, (SetAnimation{.time_s = 2.0, .paused = true}));
}

}  // namespace
}  // namespace plumbline::app
