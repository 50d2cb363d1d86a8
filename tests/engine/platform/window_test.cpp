// Needs an X server: CTest runs it under xvfb-run.
#include "engine/platform/window.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <thread>

namespace plumbline::platform {
namespace {

class WindowTest : public testing::Test {
protected:
    void SetUp() override {
        Result<std::unique_ptr<Window>> opened =
            Window::open({.title = "window test", .width = 320, .height = 200, .vsync = false});
        ASSERT_TRUE(opened.ok()) << opened.error().message;
        window_ = std::move(*opened);
    }

    /// Polls until `done` likes a snapshot; the X server answers in its own time.
    template <class Done>
    bool poll_until(Done done) {
        for (int i = 0; i < 500; ++i) {
            if (done(window_->poll_input())) return true;
            std::this_thread::sleep_for(std::chrono::milliseconds{10});
        }
        return false;
    }

    static bool x_command(const std::string& arguments) {
        const std::string command = "xdotool " + arguments + " >/dev/null 2>&1";
        return std::system(command.c_str()) == 0;
    }

    std::unique_ptr<Window> window_;
};

TEST_F(WindowTest, OpensWithAUsableContext) {
    EXPECT_EQ(window_->framebuffer_size().width, 320);
    EXPECT_EQ(window_->framebuffer_size().height, 200);
    EXPECT_GE(window_->content_scale(), 0.5F);
    EXPECT_NE(window_->gl_loader()("glDrawElementsInstanced"), nullptr);
    window_->present();
    EXPECT_FALSE(window_->poll_input().close_requested);
}

TEST_F(WindowTest, FollowsResizes) {
    ASSERT_TRUE(x_command("search --name '^window test$' windowsize 400 300"));
    EXPECT_TRUE(
        poll_until([&](const InputSnapshot&) { return window_->framebuffer_size().width == 400; }));
    EXPECT_EQ(window_->framebuffer_size().height, 300);
}

TEST_F(WindowTest, IsNoLargerThanTheMonitor) {  // of 1024 x 768
    Result<std::unique_ptr<Window>> large =
        Window::open({.title = "large", .width = 1280, .height = 720, .vsync = false});
    ASSERT_TRUE(large.ok());
    EXPECT_EQ((*large)->window_size().width, 1024);
    EXPECT_EQ((*large)->window_size().height, 720);
    (*large)->show("larger", 2000, 2000);
    EXPECT_TRUE(poll_until([&](const InputSnapshot&) {
        (*large)->poll_input();
        return (*large)->window_size().height == 768;
    }));
    EXPECT_EQ((*large)->window_size().width, 1024);
}

TEST_F(WindowTest, ResizeStormEndsAtTheLastSize) {  // A11
    for (int i = 0; i < 10; ++i) {
        const int width = 100 + (i * 37) % 300;
        ASSERT_TRUE(x_command("search --name '^window test$' windowsize " + std::to_string(width) +
                              " 150"));
        static_cast<void>(window_->poll_input());
        window_->present();
    }
    EXPECT_TRUE(poll_until([&](const InputSnapshot&) {
        return window_->framebuffer_size().width == 100 + 333 % 300;
    }));
}

TEST_F(WindowTest, AHiddenWindowHasNoPixels) {  // A10
    ASSERT_TRUE(x_command("search --name '^window test$' windowunmap"));
    bool lost_focus = false;
    EXPECT_TRUE(poll_until([&](const InputSnapshot& input) {
        lost_focus = lost_focus || input.lost_focus;
        return window_->iconified();
    }));
    EXPECT_TRUE(lost_focus);
    EXPECT_EQ(window_->framebuffer_size().width, 0);
    EXPECT_EQ(window_->framebuffer_size().height, 0);
    window_->present();
    ASSERT_TRUE(x_command("search --name '^window test$' windowmap"));
    EXPECT_TRUE(poll_until([&](const InputSnapshot&) { return !window_->iconified(); }));
    EXPECT_EQ(window_->framebuffer_size().width, 320);
}

TEST_F(WindowTest, KeysArriveAndGoUpAgain) {
    ASSERT_TRUE(x_command("search --name '^window test$' windowfocus --sync key --delay 50 w"));
    bool pressed = false;
    bool released = false;
    EXPECT_TRUE(poll_until([&](const InputSnapshot& input) {
        for (const DeviceEvent& event : input.events) {
            if (event.kind != DeviceEventKind::Key || event.code != 'W') continue;
            (event.pressed ? pressed : released) = true;
        }
        return pressed && released;
    }));
}

TEST_F(WindowTest, AHeldKeySurvivesASlowFrame) {
    ASSERT_TRUE(x_command("search --name '^window test$' windowfocus --sync keydown w"));
    ASSERT_TRUE(poll_until([](const InputSnapshot& input) { return input.keys['W']; }));
    std::this_thread::sleep_for(std::chrono::milliseconds{300});
    const InputSnapshot slow = window_->poll_input();
    EXPECT_FALSE(slow.stalled);
    EXPECT_TRUE(slow.keys['W']);
    EXPECT_TRUE(x_command("keyup w"));
    EXPECT_TRUE(poll_until([](const InputSnapshot& input) { return !input.keys['W']; }));
}

TEST_F(WindowTest, CapturedPointerMovesByCounts) {
    window_->capture_pointer(true);
    EXPECT_TRUE(window_->pointer_captured());
    double right = 0.0;
    EXPECT_TRUE(poll_until([&](const InputSnapshot& input) {
        right += input.mouse_counts[0];
        x_command("mousemove_relative 7 0");
        return right > 0.0;
    }));
    EXPECT_EQ(window_->pointer_jumps_dropped(), 0U);
    window_->capture_pointer(false);
    EXPECT_FALSE(window_->pointer_captured());
}

TEST_F(WindowTest, LosingTheFocusFreesThePointer) {  // C1
    ASSERT_TRUE(x_command("search --name '^window test$' windowfocus --sync keydown w"));
    ASSERT_TRUE(poll_until([](const InputSnapshot& input) { return input.keys['W']; }));
    window_->capture_pointer(true);
    Result<std::unique_ptr<Window>> other =
        Window::open({.title = "other window", .width = 100, .height = 100, .vsync = false});
    ASSERT_TRUE(other.ok());
    ASSERT_TRUE(x_command("search --name '^other window$' windowfocus"));
    EXPECT_TRUE(poll_until([](const InputSnapshot& input) { return input.lost_focus; }));
    EXPECT_FALSE(window_->pointer_captured());
    EXPECT_FALSE(window_->poll_input().keys['W']);
    EXPECT_TRUE(x_command("keyup w"));
}

TEST_F(WindowTest, FullscreenAndBack) {
    window_->set_fullscreen(true);
    EXPECT_TRUE(
        poll_until([&](const InputSnapshot&) { return window_->framebuffer_size().width > 320; }));
    EXPECT_TRUE(window_->fullscreen());
    window_->set_fullscreen(false);
    EXPECT_FALSE(window_->fullscreen());
    EXPECT_TRUE(
        poll_until([&](const InputSnapshot&) { return window_->framebuffer_size().width == 320; }));
}

TEST_F(WindowTest, KeysHaveTheNamesPrintedOnThem) {
    EXPECT_EQ(printed_key_name('W'), "w");
    EXPECT_EQ(printed_key_name('1'), "1");
    EXPECT_EQ(printed_key_name(321), "Keypad 1");
    EXPECT_EQ(printed_key_name(32), "Space");
    EXPECT_EQ(printed_key_name(301), "F12");
    EXPECT_EQ(printed_key_name(-1), "");
}

}  // namespace
}  // namespace plumbline::platform
