#include "engine/platform/device_events.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace plumbline::platform {
namespace {

constexpr PadReading kNoPad{};

std::size_t count(const InputSnapshot& snapshot, DeviceEventKind kind, int code, bool pressed) {
    return static_cast<std::size_t>(
        std::ranges::count_if(snapshot.events, [&](const DeviceEvent& e) {
            return e.kind == kind && e.code == code && e.pressed == pressed;
        }));
}

TEST(DeviceEvents, KeepsTheOrderAndHandsOverOnce) {
    DeviceEvents events;
    events.on_key('W', true);
    events.on_mouse_button(0, true);
    events.on_key('W', false);
    const InputSnapshot first = events.take(0.0, kNoPad);
    ASSERT_EQ(first.events.size(), 3U);
    EXPECT_EQ(first.events[0].code, 'W');
    EXPECT_EQ(first.events[1].kind, DeviceEventKind::MouseButton);
    EXPECT_FALSE(first.events[2].pressed);
    EXPECT_FALSE(first.keys['W']);
    EXPECT_TRUE(first.buttons[0]);
    const InputSnapshot second = events.take(0.01, kNoPad);
    EXPECT_TRUE(second.events.empty());
    EXPECT_TRUE(second.buttons[0]);
}

TEST(DeviceEvents, RepeatsAndUnknownReleasesAreNoEvents) {
    DeviceEvents events;
    events.on_key('W', true);
    events.on_key('W', true);
    events.on_key('S', false);
    events.on_key(-1, true);
    events.on_key(-1, false);
    events.on_key(5'000, true);
    const InputSnapshot snapshot = events.take(0.0, kNoPad);
    EXPECT_EQ(snapshot.events.size(), 3U);
    EXPECT_EQ(count(snapshot, DeviceEventKind::Key, -1, true), 2U);
}

TEST(DeviceEvents, AFloodIsBoundAndLosesNoRelease) {  // C14
    DeviceEvents events;
    events.on_key('A', true);
    for (int i = 0; i < 10'000; ++i) {
        events.on_key('Q', true);
        events.on_key('Q', false);
    }
    events.on_key('A', false);
    const InputSnapshot snapshot = events.take(0.0, kNoPad);
    EXPECT_LE(snapshot.events.size(), DeviceEvents::kMaxEvents + 2);
    EXPECT_EQ(count(snapshot, DeviceEventKind::Key, 'A', false), 1U);
    EXPECT_EQ(count(snapshot, DeviceEventKind::Key, 'Q', true),
              count(snapshot, DeviceEventKind::Key, 'Q', false));
    events.on_key('Q', true);
    EXPECT_EQ(events.take(0.1, kNoPad).events.size(), 1U);
}

TEST(DeviceEvents, ScrollingComesInWholeNotches) {
    DeviceEvents events;
    for (int i = 0; i < 5; ++i) events.on_scroll(0.0, 0.5);
    events.on_scroll(-2.0, 0.0);
    events.on_scroll(0.0, -1e300);
    events.on_scroll(std::numeric_limits<double>::quiet_NaN(), 1.0);
    const InputSnapshot snapshot = events.take(0.0, kNoPad);
    EXPECT_EQ(count(snapshot, DeviceEventKind::Wheel, 0, true), 2U);
    EXPECT_EQ(count(snapshot, DeviceEventKind::Wheel, 2, true), 2U);
    EXPECT_EQ(count(snapshot, DeviceEventKind::Wheel, 1, true),
              static_cast<std::size_t>(DeviceEvents::kMaxNotches));
}

TEST(DeviceEvents, CapturedMotionStartsAtTheSecondReport) {
    DeviceEvents events;
    events.on_cursor(400.0, 300.0);
    events.set_captured(true);
    events.on_cursor(10.0, 10.0);  // where the pointer was put: no motion
    events.on_cursor(15.0, 8.0);
    const InputSnapshot snapshot = events.take(0.0, kNoPad);
    EXPECT_EQ(snapshot.mouse_counts[0], 5.0);
    EXPECT_EQ(snapshot.mouse_counts[1], -2.0);
    events.set_captured(false);
    events.on_cursor(100.0, 100.0);
    events.on_cursor(130.0, 100.0);
    EXPECT_EQ(events.take(0.01, kNoPad).mouse_counts[0], 0.0);
}

TEST(DeviceEvents, JumpsAreDroppedAndCounted) {  // C9
    DeviceEvents events;
    events.set_captured(true);
    events.on_cursor(0.0, 0.0);
    events.on_cursor(5'000.0, 0.0);
    events.on_cursor(5'003.0, 0.0);
    const InputSnapshot snapshot = events.take(0.0, kNoPad);
    EXPECT_EQ(snapshot.mouse_counts[0], 3.0);
    EXPECT_EQ(events.jumps_dropped(), 1U);
}

TEST(DeviceEvents, CursorIsInFramebufferPixels) {
    DeviceEvents events;
    events.set_pixel_ratio(2.0, 2.0);
    events.on_cursor(100.0, 50.0);
    EXPECT_EQ(events.take(0.0, kNoPad).cursor_px, (std::array<double, 2>{200.0, 100.0}));
}

TEST(DeviceEvents, FocusLossIsToldOnce) {
    DeviceEvents events;
    events.on_focus(false);
    const InputSnapshot lost = events.take(0.0, kNoPad);
    EXPECT_TRUE(lost.lost_focus);
    EXPECT_FALSE(lost.focused);
    const InputSnapshot later = events.take(0.01, kNoPad);
    EXPECT_FALSE(later.lost_focus);
    EXPECT_FALSE(later.focused);
    events.on_focus(true);
    EXPECT_TRUE(events.take(0.02, kNoPad).focused);
    events.on_iconify(true);
    EXPECT_TRUE(events.take(0.03, kNoPad).lost_focus);
}

TEST(DeviceEvents, ADroppedFileIsHandedOverOnce) {  // FAULTS 29
    DeviceEvents events;
    events.on_drop("/models/chair with spaces.glb");
    EXPECT_EQ(events.take(0.0, {}).dropped_files,
              std::vector<std::string>{"/models/chair with spaces.glb"});
    EXPECT_TRUE(events.take(0.1, {}).dropped_files.empty());
}

TEST(DeviceEvents, AStallIsOverAQuarterOfASecond) {  // C2
    DeviceEvents events;
    EXPECT_FALSE(events.take(100.0, kNoPad).stalled);
    EXPECT_FALSE(events.take(100.24, kNoPad).stalled);
    EXPECT_TRUE(events.take(100.50, kNoPad).stalled);
    EXPECT_FALSE(events.take(100.51, kNoPad).stalled);
}

TEST(DeviceEvents, AfterAStallWhatIsReallyDownStaysDown) {
    DeviceEvents events;
    events.on_key('W', true);
    events.on_key('A', true);
    events.on_mouse_button(0, true);
    static_cast<void>(events.take(0.0, kNoPad));
    std::bitset<kKeyCount> keys;
    keys['W'] = true;
    ASSERT_TRUE(events.is_stalled(1.0));
    events.confirm_down(keys, {});
    const InputSnapshot snapshot = events.take(1.0, kNoPad);
    EXPECT_FALSE(snapshot.stalled);
    EXPECT_TRUE(snapshot.keys['W']);
    EXPECT_EQ(count(snapshot, DeviceEventKind::Key, 'A', false), 1U);
    EXPECT_EQ(count(snapshot, DeviceEventKind::MouseButton, 0, false), 1U);
    EXPECT_EQ(count(snapshot, DeviceEventKind::Key, 'W', false), 0U);
    EXPECT_TRUE(events.take(2.0, kNoPad).stalled);  // nobody confirmed this one
}

TEST(DeviceEvents, PadButtonsBecomeEventsAndAPulledPadReleases) {  // C5
    DeviceEvents events;
    PadReading pad{.present = true, .buttons = {}, .axes = {}};
    pad.buttons[3] = true;
    pad.axes = {0.5F, std::numeric_limits<float>::quiet_NaN(), 7.0F, 0.0F, -1.0F, 1.0F};
    const InputSnapshot pressed = events.take(0.0, pad);
    EXPECT_EQ(count(pressed, DeviceEventKind::PadButton, 3, true), 1U);
    EXPECT_EQ(pressed.pad_axes[0], 0.5F);
    EXPECT_EQ(pressed.pad_axes[1], 0.0F);
    EXPECT_EQ(pressed.pad_axes[2], 1.0F);
    const InputSnapshot pulled = events.take(0.01, kNoPad);
    EXPECT_EQ(count(pulled, DeviceEventKind::PadButton, 3, false), 1U);
    EXPECT_EQ(pulled.pad_axes[5], -1.0F);
    EXPECT_FALSE(pulled.pad_present);
}

}  // namespace
}  // namespace plumbline::platform
