// Looking, sticks and triggers, and what hints are about.
#include "tests/engine/input/hands.h"

#include <limits>

namespace plumbline::input {
namespace {

TEST(ActionLatchAxes, LookTurnsByTheTunedAngle) {
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
TEST(ActionLatchAxes, AFreePointerPointsAndDoesNotLook) {
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

TEST(ActionLatchAxes, LookAddsUpOverFramesWithoutASteps) {
    Hands hands("[tuning]\ninvert_y = true\nmouse_deg_per_count = 0.1\n");
    for (int i = 0; i < 4; ++i) {
        hands.next.mouse_counts = {-10.0, 10.0};
        hands.frame();
    }
    const Actions actions = hands.latch.take();
    EXPECT_NEAR(actions.look_yaw_rad, radians_from_degrees(4.0F), 1e-6F);
    EXPECT_NEAR(actions.look_pitch_rad, radians_from_degrees(4.0F), 1e-6F);
}

// A flick of a mouse with many counts per inch, or a slow frame that adds up many reports.
TEST(ActionLatchAxes, AFrameTurnsTheViewAsFarAsTheMouseWent) {
    Hands hands("[tuning]\nmouse_deg_per_count = 0.01\n");
    hands.next.mouse_counts = {-6'000.0, 0.0};
    hands.frame();
    EXPECT_NEAR(hands.latch.take().look_yaw_rad, radians_from_degrees(60.0F), 1e-5F);
}

TEST(ActionLatchAxes, CountsThatAreNotFiniteTurnNothing) {
    Hands hands;
    for (const double counts :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        hands.next.mouse_counts = {counts, 0.0};
        hands.frame();
        EXPECT_EQ(hands.latch.take().look_yaw_rad, 0.0F) << counts;
    }
}

TEST(ActionLatchAxes, TheStickTurnsBySpeedAndTime) {
    Hands hands;
    hands.plug_pad();
    hands.next.pad_axes[2] = 1.0F;
    for (int i = 0; i < 30; ++i) hands.frame();
    // 180 degrees a second for half a second, to the right.
    EXPECT_NEAR(hands.latch.take().look_yaw_rad, radians_from_degrees(-90.0F), 1e-4F);
    EXPECT_EQ(hands.latch.last_device(), LastDevice::Gamepad);
}

TEST(ActionLatchAxes, TheStickWalksByItsTravel) {
    Hands hands;
    hands.plug_pad();
    hands.next.pad_axes[1] = -0.565F;  // half the travel, squared
    hands.frame();
    const Actions actions = hands.latch.take();
    EXPECT_TRUE(actions.is_held(Action::Forward));
    EXPECT_NEAR(actions.amount_of(Action::Forward), 0.25F, 1e-5F);
    EXPECT_FALSE(actions.is_held(Action::Back));
}

TEST(ActionLatchAxes, TriggersPressAtTheirThreshold) {
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

TEST(ActionLatchAxes, AxesCountOnceTheyHaveBeenAtRest) {  // C7: stuck, drifting, never touched
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

TEST(ActionLatchAxes, ATriggerLetsGoATenthBelowItsThreshold) {
    Hands hands;  // the threshold is 0.5; a trigger goes from -1 to 1
    hands.plug_pad();
    const auto held_at = [&](float travel) {
        hands.next.pad_axes[5] = 2.0F * travel - 1.0F;
        hands.frame();
        return hands.latch.take().is_held(Action::Throw);
    };
    EXPECT_FALSE(held_at(0.49F));
    EXPECT_TRUE(held_at(0.51F));
    EXPECT_TRUE(held_at(0.41F)) << "no flutter about the threshold";
    EXPECT_FALSE(held_at(0.39F));
    EXPECT_FALSE(held_at(0.45F));
}

TEST(ActionLatchAxes, ALongFrameTurnsNoMoreThanATenthOfASecond) {
    Hands hands;
    hands.plug_pad();
    hands.next.pad_axes[2] = -1.0F;
    hands.next.now_s += 5.0;
    hands.frame();
    EXPECT_NEAR(hands.latch.take().look_yaw_rad, radians_from_degrees(180.0 * 0.1), 1e-6);
}

TEST(ActionLatchAxes, InvertedLookingGoesTheOtherWayForMouseAndStick) {
    for (const bool inverted : {false, true}) {
        Hands hands(inverted ? "[tuning]\ninvert_y = true\n" : "");
        hands.plug_pad();
        hands.next.mouse_counts = {0.0, 100.0};  // down
        hands.frame();
        EXPECT_NEAR(
            hands.latch.take().look_pitch_rad, radians_from_degrees(inverted ? 6.6 : -6.6), 1e-6);
        hands.next.pad_axes[3] = 1.0F;  // pulled towards oneself: down
        hands.frame();
        EXPECT_NEAR(hands.latch.take().look_pitch_rad,
                    radians_from_degrees((inverted ? 180.0 : -180.0) * kFrame_s),
                    1e-6);
    }
}

}  // namespace
}  // namespace plumbline::input
