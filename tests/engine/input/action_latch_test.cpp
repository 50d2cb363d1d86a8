#include "tests/engine/input/hands.h"

#include <limits>

namespace plumbline::input {
namespace {

TEST(ActionLatch, APressIsSeenByExactlyOneStep) {
    Hands hands;
    hands.tap('Q');
    hands.frame();
    hands.frame();  // frames without a step lose nothing
    const Actions first = hands.latch.take();
    EXPECT_EQ(first.presses(Action::Drop), 1);
    EXPECT_FALSE(first.is_held(Action::Drop));
    const Actions second = hands.latch.take();  // nor do steps count twice
    EXPECT_EQ(second.presses(Action::Drop), 0);
}

TEST(ActionLatch, QuickPressesAreCounted) {
    Hands hands;
    for (int i = 0; i < 3; ++i) hands.tap('Q');
    hands.frame();
    EXPECT_EQ(hands.latch.take().presses(Action::Drop), 3);
    EXPECT_EQ(hands.latch.presses_seen()[static_cast<std::size_t>(Action::Drop)], 3U);
}

TEST(ActionLatch, FramesHaveACountOfTheirOwn) {
    Hands hands;
    hands.tap('Q');
    hands.frame();
    EXPECT_EQ(hands.latch.take_frame_presses(Action::Drop), 1);
    EXPECT_EQ(hands.latch.take_frame_presses(Action::Drop), 0);
    EXPECT_EQ(hands.latch.take().presses(Action::Drop), 1);
}

TEST(ActionLatch, AKeyHeldIsHeldInEveryStep) {
    Hands hands;
    hands.key('W', true);
    hands.frame();
    for (int i = 0; i < 3; ++i) {
        const Actions actions = hands.latch.take();
        EXPECT_TRUE(actions.is_held(Action::Forward));
        EXPECT_EQ(actions.amount_of(Action::Forward), 1.0F);
        EXPECT_EQ(actions.presses(Action::Forward), i == 0 ? 1 : 0);
    }
    hands.key('W', false);
    hands.frame();
    EXPECT_FALSE(hands.latch.take().is_held(Action::Forward));
}

TEST(ActionLatch, OfTwoKeysOneStillHolds) {  // C10
    Hands hands;
    constexpr int kUp = 265;
    hands.key('W', true);
    hands.key(kUp, true);
    hands.key('W', false);
    hands.frame();
    EXPECT_TRUE(hands.latch.take().is_held(Action::Forward));
    hands.key(kUp, false);
    hands.frame();
    EXPECT_FALSE(hands.latch.take().is_held(Action::Forward));
}

TEST(ActionLatch, ToggleHoldsUntilTheNextPress) {
    Hands hands;  // grab is a toggle by default
    hands.tap('E');
    hands.frame();
    EXPECT_TRUE(hands.latch.take().is_held(Action::Grab));
    hands.frame();
    EXPECT_TRUE(hands.latch.take().is_held(Action::Grab));
    hands.tap('E');
    hands.frame();
    EXPECT_FALSE(hands.latch.take().is_held(Action::Grab));
    hands.tap('E');
    hands.frame();
    hands.latch.release(Action::Grab);
    EXPECT_FALSE(hands.latch.take().is_held(Action::Grab));
}

TEST(ActionLatch, HoldModesComeFromTheFile) {
    Hands hands("[hold]\ngrab = \"hold\"\ncrouch = \"toggle\"\n");
    hands.tap('E');
    hands.tap(341);
    hands.frame();
    const Actions actions = hands.latch.take();
    EXPECT_FALSE(actions.is_held(Action::Grab));
    EXPECT_TRUE(actions.is_held(Action::Crouch));
}

TEST(ActionLatch, OnlyTheChordFires) {  // C12
    Hands hands("[view]\nhelp = [\"shift+f3\"]\n");
    for (const int shift : {kLeftShift, kRightShift}) {
        hands.key(shift, true);
        hands.key(kF3, true);
        hands.frame();
        const Actions actions = hands.latch.take();
        EXPECT_EQ(actions.presses(Action::Help), 1);
        EXPECT_EQ(actions.presses(Action::Stats), 0);
        hands.key(shift, false);  // breaks the chord; the plain key waits for its own press
        hands.frame();
        const Actions broken = hands.latch.take();
        EXPECT_FALSE(broken.is_held(Action::Help));
        EXPECT_FALSE(broken.is_held(Action::Stats));
        hands.key(kF3, false);
        hands.frame();
    }
    hands.tap(kF3);
    hands.frame();
    EXPECT_EQ(hands.latch.take().presses(Action::Stats), 1);
}

TEST(ActionLatch, APlainKeyWorksWhateverModifiersAreDown) {
    Hands hands;
    hands.key(kLeftShift, true);
    hands.key('W', true);
    for (int i = 0; i < 12; ++i) hands.frame();  // by then no chord can be meant
    const Actions actions = hands.latch.take();
    EXPECT_TRUE(actions.is_held(Action::Forward));
    EXPECT_TRUE(actions.is_held(Action::Sprint));
}

// Ctrl+R reads the scene again, and Ctrl alone crouches or flies down.
TEST(ActionLatch, AChordsOwnKeysDriveNothing) {
    Hands hands;
    hands.key(kLeftControl, true);
    for (int i = 0; i < 6; ++i) {
        hands.frame();  // 0.1 s
        EXPECT_FALSE(hands.latch.take().is_held(Action::Crouch));
    }
    hands.tap('R');
    for (int i = 0; i < 30; ++i) {
        hands.frame();
        const Actions actions = hands.latch.take();
        EXPECT_FALSE(actions.is_held(Action::Crouch));
        EXPECT_EQ(actions.presses(Action::Crouch), 0);
    }
    hands.key(kLeftControl, false);
    hands.frame();
    EXPECT_EQ(hands.latch.take().presses(Action::Crouch), 0);
    EXPECT_EQ(hands.latch.take_frame_presses(Action::Reload), 1);
    EXPECT_EQ(hands.latch.take_frame_presses(Action::Reset), 0);
}

TEST(ActionLatch, AChordAfterAllEndsWhatItsKeyHeld) {
    Hands hands;
    hands.key(kLeftControl, true);
    for (int i = 0; i < 12; ++i) hands.frame();
    EXPECT_TRUE(hands.latch.take().is_held(Action::Crouch));
    hands.tap('R');
    hands.frame();
    EXPECT_FALSE(hands.latch.take().is_held(Action::Crouch));
}

TEST(ActionLatch, AModifierThatIsTappedIsAPressOfItsOwn) {
    Hands hands("[hold]\ncrouch = \"toggle\"\n");
    hands.tap(kLeftControl);
    hands.frame();
    EXPECT_EQ(hands.latch.take().presses(Action::Crouch), 1);
    EXPECT_TRUE(hands.latch.take().is_held(Action::Crouch));
}

TEST(ActionLatch, AModifierThatBeginsNoChordActsAtOnce) {
    Hands hands("[view]\nfilm = [\"f6\"]\n");  // the only chord with Shift is gone
    hands.key(kLeftShift, true);
    hands.frame();
    EXPECT_TRUE(hands.latch.take().is_held(Action::Sprint));
}

TEST(ActionLatch, TheLongerChordWins) {
    Hands hands("[view]\nhelp = [\"ctrl+k\"]\nfog = [\"ctrl+shift+k\"]\nhud = [\"k\"]\n");
    hands.key(341, true);
    hands.key(kLeftShift, true);
    hands.tap('K');
    hands.frame();
    const Actions actions = hands.latch.take();
    EXPECT_EQ(actions.presses(Action::Fog), 1);
    EXPECT_EQ(actions.presses(Action::Help), 0);
    EXPECT_EQ(actions.presses(Action::Hud), 0);
}

TEST(ActionLatch, ANotchIsAPressAndARelease) {
    Hands hands;
    hands.wheel(0);
    hands.wheel(0);
    hands.frame();
    const Actions actions = hands.latch.take();
    EXPECT_EQ(actions.presses(Action::Push), 2);
    EXPECT_FALSE(actions.is_held(Action::Push));
}

TEST(ActionLatch, LosingTheFocusReleasesEverything) {  // C1
    Hands hands;
    hands.key('W', true);
    hands.tap('E');
    hands.tap('Q');
    hands.next.mouse_counts = {100.0, 0.0};
    hands.frame();
    hands.next.lost_focus = true;
    hands.next.focused = false;
    hands.frame();
    const Actions actions = hands.latch.take();
    EXPECT_TRUE(actions.held.none());
    EXPECT_EQ(actions.presses(Action::Drop), 0);
    EXPECT_EQ(actions.look_yaw_rad, 0.0F);
    // Back again, with the key still down: it counts from its next press on.
    hands.next.focused = true;
    hands.frame();
    EXPECT_TRUE(hands.latch.take().held.none());
    hands.key('W', false);
    hands.key('W', true);
    hands.frame();
    EXPECT_TRUE(hands.latch.take().is_held(Action::Forward));
}

TEST(ActionLatch, AStallReleasesEverything) {  // C2
    Hands hands;
    hands.key('W', true);
    hands.frame();
    hands.next.stalled = true;
    hands.frame();
    EXPECT_TRUE(hands.latch.take().held.none());
}

TEST(ActionLatch, AnOpenMenuTakesTheInput) {
    Hands hands;
    hands.key('W', true);
    hands.tap(kEscape);
    hands.frame();
    EXPECT_EQ(hands.latch.take_frame_presses(Action::Menu), 1);
    hands.tap('Q');
    hands.tap(257);
    hands.next.mouse_counts = {50.0, 50.0};
    hands.frame({.menu_open = true});
    const Actions actions = hands.latch.take();
    EXPECT_TRUE(actions.held.none());
    EXPECT_EQ(actions.presses(Action::Drop), 0);
    EXPECT_EQ(actions.look_yaw_rad, 0.0F);
    EXPECT_EQ(hands.latch.take_frame_presses(Action::Accept), 1);
    hands.tap(kEscape);
    hands.frame({.menu_open = true});
    EXPECT_EQ(hands.latch.take_frame_presses(Action::Menu), 1);
    hands.frame();  // closed: W is still down and needs a new press
    EXPECT_FALSE(hands.latch.take().is_held(Action::Forward));
}

TEST(ActionLatch, ATextFieldGetsTheKeysAndEscapeLeadsOut) {  // C13
    Hands hands;
    hands.key('W', true);
    hands.frame();
    hands.tap('Q');
    hands.tap(kEscape);
    hands.frame({.ui_keyboard = true});
    const Actions actions = hands.latch.take();
    EXPECT_EQ(actions.presses(Action::Drop), 0);
    EXPECT_FALSE(actions.is_held(Action::Forward));
    EXPECT_EQ(hands.latch.take_frame_presses(Action::Menu), 1);
}

TEST(ActionLatch, APanelGetsTheMouseButNotTheReleases) {
    Hands hands;
    hands.button(0, true);
    hands.frame();
    EXPECT_TRUE(hands.latch.take().is_held(Action::Throw));
    hands.button(0, false);
    hands.wheel(0);
    hands.frame({.ui_mouse = true});
    const Actions actions = hands.latch.take();
    EXPECT_FALSE(actions.is_held(Action::Throw));
    EXPECT_EQ(actions.presses(Action::Push), 0);
}

TEST(ActionLatch, NewBindingsReleaseWhatTheOldOnesHeld) {
    Hands hands;
    hands.key('W', true);
    hands.frame();
    hands.latch.set_bindings(load_bindings({}, {"drop=w"}, hands.faults));
    EXPECT_TRUE(hands.latch.take().held.none());
    hands.key('W', false);
    hands.tap('W');
    hands.frame();
    const Actions actions = hands.latch.take();
    EXPECT_EQ(actions.presses(Action::Drop), 1);
    EXPECT_EQ(actions.presses(Action::Forward), 0);
}

TEST(ActionLatch, UnknownKeysAndFloodsAreSurvived) {  // C4, C14
    Hands hands;
    hands.next.events.push_back({DeviceEventKind::Key, -1, true});
    hands.next.events.push_back({DeviceEventKind::Key, 100'000, true});
    for (int i = 0; i < 10'000; ++i) hands.tap('Q');
    hands.frame();
    EXPECT_EQ(hands.latch.take().presses(Action::Drop), 255);
    EXPECT_TRUE(hands.latch.take().held.none());
}

TEST(ActionLatch, UnpluggingThePadReleasesWhatItHeld) {  // C5
    Hands hands;
    hands.plug_pad();
    hands.next.pad_axes[1] = -1.0F;
    hands.pad_button(1, true);
    hands.frame();
    hands.key('D', true);
    hands.frame();
    EXPECT_TRUE(hands.latch.take().is_held(Action::Crouch));
    hands.next.pad_present = false;
    hands.frame();
    const Actions actions = hands.latch.take();
    EXPECT_FALSE(actions.is_held(Action::Forward));
    EXPECT_FALSE(actions.is_held(Action::Crouch));
    EXPECT_TRUE(actions.is_held(Action::Right));  // the keyboard's own
    EXPECT_EQ(hands.latch.last_device(), LastDevice::KeyboardMouse);
}

TEST(ActionLatch, HintsFollowTheLastDevice) {
    Hands hands;
    EXPECT_EQ(hands.latch.last_device(), LastDevice::KeyboardMouse);
    hands.pad_button(0, true);
    hands.frame();
    EXPECT_EQ(hands.latch.last_device(), LastDevice::Gamepad);
    hands.key('W', true);
    hands.frame();
    EXPECT_EQ(hands.latch.last_device(), LastDevice::KeyboardMouse);
}

TEST(ActionLatch, LabelsMatchWhatTheKeyPrints) {
    Hands hands("[view]\nhelp = [\"label:q\"]\n");
    hands.latch.set_label_lookup([](int key) -> std::string {
        if (key == 'A') return "q";  // a French keyboard
        if (key == 320) return "Keypad 0";
        return {};
    });
    hands.tap('Q');
    hands.frame();
    EXPECT_EQ(hands.latch.take().presses(Action::Help), 0);
    hands.tap('A');
    hands.frame();
    const Actions actions = hands.latch.take();
    EXPECT_EQ(actions.presses(Action::Help), 1);
    EXPECT_EQ(actions.presses(Action::Left), 1);  // places keep working
}

}  // namespace
}  // namespace plumbline::input
