// Looking, sticks and triggers, and what hints are about.
#include "tests/engine/input/hands.h"

#include <limits>

namespace plumbline::input {
namespace {

TEST(ActionLatch, LookTurnsByTheTunedAngle) {
    Hands hands;
    hands.next.mouse_counts = {100.0, -50.0};
    hands.frame();
    EXPECT_NEAR(hands.latch.pending_yaw_rad(), radians_from_degrees(-6.6F), 1e-6F);
    const Actions actions = hands.latch.take();
    EXPECT_NEAR(actions.look_yaw_rad, radians_from_degrees(-6.6F), 1e-6F);
    EXPECT_NEAR(actions.look_pitch_rad, radians_from_degrees(3.3F), 1e-6F);
    EXPECT_EQ(hands.latch.take().look_yaw_rad, 0.0F);
    EXPECT_EQ(hands.latch.pending_yaw_rad(), 0.0F);
}

// SOURCES A33: where the pointer is free it points, and turns nothing.
TEST(ActionLatch, AFreePointerPointsAndDoesNotLook) {
    Hands hands;
    hands.next.mouse_counts = {100.0, -50.0};
    hands.frame({.pointer = std::array{0.25F, -0.5F}});
    const Actions actions = hands.latch.take();
    EXPECT_EQ(actions.pointer, (std::array{0.25F, -0.5F}));
    EXPECT_EQ(actions.look_yaw_rad, 0.0F);
    EXPECT_EQ(hands.latch.take().pointer, (std::array{0.25F, -0.5F})) << "it stays there";
    hands.next.mouse_counts = {100.0, -50.0};
    hands.frame();
    EXPECT_FALSE(hands.latch.take().pointer.has_value());
}

TEST(ActionLatch, LookAddsUpOverFramesWithoutASteps) {
    Hands hands("[tuning]\ninvert_y = true\nmouse_deg_per_count = 0.1\n");
    for (int i = 0; i < 4; ++i) {
        hands.next.mouse_counts = {-10.0, 10.0};
        hands.frame();
    }
    const Actions actions = hands.latch.take();
    EXPECT_NEAR(actions.look_yaw_rad, radians_from_degrees(4.0F), 1e-6F);
    EXPECT_NEAR(actions.look_pitch_rad, radians_from_degrees(4.0F), 1e-6F);
}

TEST(ActionLatch, ImpossibleMouseJumpsAreDroppedAndCounted) {  // C9
    Hands hands;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    for (const double jump : {5'000.0, -5'000.0, nan, inf}) {
        hands.next.mouse_counts = {jump, 0.0};
        hands.frame();
        EXPECT_EQ(hands.latch.take().look_yaw_rad, 0.0F) << jump;
    }
    EXPECT_EQ(hands.latch.mouse_jumps_dropped(), 4U);
    hands.next.mouse_counts = {900.0, 0.0};
    hands.frame();
    EXPECT_NE(hands.latch.take().look_yaw_rad, 0.0F);
}

TEST(ActionLatch, TheStickTurnsBySpeedAndTime) {
    Hands hands;
    hands.plug_pad();
    hands.next.pad_axes[2] = 1.0F;
    for (int i = 0; i < 30; ++i) hands.frame();
    // 180 degrees a second for half a second, to the right.
    EXPECT_NEAR(hands.latch.take().look_yaw_rad, radians_from_degrees(-90.0F), 1e-4F);
    EXPECT_EQ(hands.latch.last_device(), LastDevice::Gamepad);
}

TEST(ActionLatch, TheStickWalksByItsTravel) {
    Hands hands;
    hands.plug_pad();
    hands.next.pad_axes[1] = -0.565F;  // half the travel, squared
    hands.frame();
    const Actions actions = hands.latch.take();
    EXPECT_TRUE(actions.is_held(Action::Forward));
    EXPECT_NEAR(actions.amount_of(Action::Forward), 0.25F, 1e-5F);
    EXPECT_FALSE(actions.is_held(Action::Back));
}

TEST(ActionLatch, TriggersPressAtTheirThreshold) {
    Hands hands;
    hands.plug_pad();
    hands.next.pad_axes[5] = -0.1F;  // 45 % of the travel
    hands.frame();
    EXPECT_FALSE(hands.latch.take().is_held(Action::Throw));
    hands.next.pad_axes[5] = 0.1F;
    hands.frame();
    EXPECT_EQ(hands.latch.take().presses(Action::Throw), 1);
    hands.next.pad_axes[5] = -0.1F;  // wobbling about the threshold is one press
    hands.frame();
    hands.next.pad_axes[5] = 0.1F;
    hands.frame();
    const Actions actions = hands.latch.take();
    EXPECT_TRUE(actions.is_held(Action::Throw));
    EXPECT_EQ(actions.presses(Action::Throw), 0);
    hands.next.pad_axes[5] = -1.0F;
    hands.frame();
    EXPECT_FALSE(hands.latch.take().is_held(Action::Throw));
}

TEST(ActionLatch, AxesCountOnceTheyHaveBeenAtRest) {  // C7: stuck, drifting, never touched
    Hands hands;
    hands.next.pad_present = true;
    hands.next.pad_axes = {0.0F, -0.99F, 0.12F, 0.0F, 0.0F, 0.0F};
    hands.frame();
    const Actions actions = hands.latch.take();
    EXPECT_TRUE(actions.held.none());
    EXPECT_EQ(actions.look_yaw_rad, 0.0F);
    hands.next.pad_axes[1] = std::numeric_limits<float>::quiet_NaN();
    hands.frame();
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
