#include "engine/app/controls/frame_controls.h"

#include "engine/core/text/diagnostics.h"

#include <gtest/gtest.h>

#include <variant>

namespace plumbline::app {
namespace {

/// A game as it was saved: something in the hand, or not; crouched, or not.
class SavedAs final : public scene::Game {
public:
    SavedAs(bool holds, bool crouches) : holds_(holds), crouches_(crouches) {}
    scene::ViewPoint view(const scene::Simulation&, Real, float, float) const override {
        return {};
    }
    bool holds() const override { return holds_; }
    bool crouches() const override { return crouches_; }

private:
    bool holds_;
    bool crouches_;
};

input::Bindings bindings_with(const std::string& modes) {
    Diagnostics faults;
    return input::load_bindings({{"bindings.toml", "[hold]\n" + modes}}, {}, faults);
}

TEST(ResumeToggles, GoOnAsTheSavedGameHasThem) {
    input::ActionLatch latch(bindings_with("grab = \"toggle\"\ncrouch = \"toggle\"\n"));
    for (const bool holds : {true, false, true}) {
        for (const bool crouches : {true, false, true}) {
            resume_toggles(SavedAs(holds, crouches), latch);
            const Actions actions = latch.take();
            EXPECT_EQ(actions.is_held(Action::Grab), holds);
            EXPECT_EQ(actions.is_held(Action::Crouch), crouches);
            EXPECT_EQ(actions.presses(Action::Crouch), 0) << "nobody pressed a key";
        }
    }
}

/// What one press of a key asks for, with the built-in bindings.
Requests asked_by(int key) {
    input::ActionLatch latch(input::built_in_bindings());
    ViewSettings view;
    FrameClock clock(1.0 / 60);
    InputSnapshot input;
    latch.update(input, {});
    input.events = {{DeviceEventKind::Key, key, true}};
    input.keys[static_cast<std::size_t>(key)] = true;
    latch.update(input, {});
    Requests requests;
    apply_frame_actions(latch, view, clock, requests, [](const std::string&) {});
    return requests;
}

TEST(FrameActions, AskForWhatTheLoopDoes) {
    const Requests reset = asked_by('R');
    ASSERT_EQ(reset.size(), 1U);
    EXPECT_EQ(std::get<WorldRequest>(reset[0]), WorldRequest{StartAgain{}});
    constexpr int kF12 = 301;
    const Requests image = asked_by(kF12);
    ASSERT_EQ(image.size(), 1U);
    EXPECT_TRUE(std::holds_alternative<SaveImage>(image[0]));
    for (const int key : {'8', '9', 'W'}) EXPECT_TRUE(asked_by(key).empty());
}

TEST(ResumeToggles, WhatIsHeldByAKeyFollowsTheKey) {
    input::ActionLatch latch(bindings_with("grab = \"hold\"\ncrouch = \"hold\"\n"));
    resume_toggles(SavedAs(true, true), latch);
    const Actions actions = latch.take();
    EXPECT_FALSE(actions.is_held(Action::Grab));
    EXPECT_FALSE(actions.is_held(Action::Crouch));
}

}  // namespace
}  // namespace plumbline::app
