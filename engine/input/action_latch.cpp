#include "engine/input/action_latch.h"

#include "engine/core/text/text_case.h"
#include "engine/input/modifier_keys.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace plumbline::input {
namespace {

// A modifier key that begins chords as well drives its own action only once no chord can be meant.
constexpr double kChordWait_s = 0.15;

std::string us_label(int key) {
    if (key <= ' ' || key > '`') return {};
    return std::string(1, to_lower(static_cast<char>(key)));
}

}  // namespace

bool ActionLatch::is_live(Action action) const {
    if (action == Action::Menu) return true;
    return (group_of(action) == ActionGroup::Menu) == focus_.menu_open;
}

bool ActionLatch::matches(const Input& input, const DeviceEvent& event) const {
    if (input.kind == DeviceKind::Label && event.kind == DeviceEventKind::Key && event.code >= 0) {
        const std::string printed = label_of_(event.code);
        return printed.size() == 1 && to_lower(printed[0]) == to_lower(input.label);
    }
    return input.kind == device_of(event.kind) && input.code == event.code;
}

void ActionLatch::press(Action action) {
    const std::size_t i = index_of(action);
    if (step_presses_[i] < 255) ++step_presses_[i];
    ++frame_presses_[i];
    ++presses_seen_[i];
    if (bindings_.hold_mode[i] == HoldMode::Toggle) toggled_.flip(i);
}

// Of the inputs on this key whose modifiers are down, those that ask for the most fire: a chord
// beats the plain key, and the plain key works whatever else is down.
void ActionLatch::on_press(const DeviceEvent& event) {
    on_release(event.kind, event.code);
    const std::uint8_t down = modifiers_down(keys_down_);
    int most = -1;
    std::vector<Holder> found;
    for (std::size_t i = 0; i < kActionCount; ++i) {
        const auto action = static_cast<Action>(i);
        if (!is_live(action)) continue;
        for (const Input& input : bindings_.inputs[i]) {
            if ((input.modifiers & down) != input.modifiers || !matches(input, event)) continue;
            const int asked = std::popcount(input.modifiers);
            if (asked < most) continue;
            if (asked > most) found.clear();
            most = asked;
            found.push_back({action, event.kind, event.code, input.modifiers});
        }
    }
    if (most > 0) end_waiting(found.front().modifiers);
    const bool waits = begins_chords(event);
    for (const Holder& holder : found) {
        if (waits) {
            waiting_.push_back({holder, last_now_s_});
            continue;
        }
        press(holder.action);
        if (event.kind != DeviceEventKind::Wheel) holders_.push_back(holder);
    }
}

bool ActionLatch::begins_chords(const DeviceEvent& event) const {
    if (event.kind != DeviceEventKind::Key) return false;
    const std::uint8_t modifier = modifier_of(event.code);
    if (modifier == 0) return false;
    for (std::size_t i = 0; i < kActionCount; ++i) {
        if (!is_live(static_cast<Action>(i))) continue;
        for (const Input& input : bindings_.inputs[i])
            if ((input.modifiers & modifier) != 0) return true;
    }
    return false;
}

// What the chord's own keys drive by themselves was not meant.
void ActionLatch::end_waiting(std::uint8_t chord) {
    const auto in_chord = [&](const Holder& holder) {
        return holder.kind == DeviceEventKind::Key && (modifier_of(holder.code) & chord) != 0;
    };
    std::erase_if(waiting_, [&](const Waiting& each) { return in_chord(each.holder); });
    std::erase_if(holders_, in_chord);
}

void ActionLatch::start_what_waited(double now_s) {
    std::erase_if(waiting_, [&](const Waiting& each) {
        if (now_s - each.since_s < kChordWait_s) return false;
        press(each.holder.action);
        holders_.push_back(each.holder);
        return true;
    });
}

void ActionLatch::on_release(DeviceEventKind kind, int code) {
    const auto mine = [&](const Holder& h) { return h.kind == kind && h.code == code; };
    std::erase_if(holders_, mine);
    // Let go before it was clear that no chord is meant: a press all the same.
    std::erase_if(waiting_, [&](const Waiting& each) {
        if (!mine(each.holder)) return false;
        press(each.holder.action);
        return true;
    });
}

void ActionLatch::drop_broken_chords() {
    const std::uint8_t down = modifiers_down(keys_down_);
    std::erase_if(holders_, [&](const Holder& h) { return (h.modifiers & down) != h.modifiers; });
}

void ActionLatch::on_event(const DeviceEvent& event) {
    const bool is_key = event.kind == DeviceEventKind::Key;
    if (is_key && event.code >= 0 && event.code < kKeyCount)
        keys_down_[static_cast<std::size_t>(event.code)] = event.pressed;
    if (!event.pressed) {
        on_release(event.kind, event.code);
        if (is_key) drop_broken_chords();
        return;
    }
    last_device_ =
        event.kind == DeviceEventKind::PadButton ? LastDevice::Gamepad : LastDevice::KeyboardMouse;
    // A text field gets what is typed, but Escape always leads out.
    if (is_key && focus_.ui_keyboard && event.code != kEscapeKey) return;
    const bool is_mouse =
        event.kind == DeviceEventKind::MouseButton || event.kind == DeviceEventKind::Wheel;
    if (is_mouse && focus_.ui_mouse) return;
    on_press(event);
}

void ActionLatch::release_everything() {
    holders_.clear();
    waiting_.clear();
    axis_holders_.clear();
    axis_trusted_.fill(false);
    toggled_.reset();
    step_presses_.fill(0);
    for (std::size_t i = 0; i < kActionCount; ++i)
        if (group_of(static_cast<Action>(i)) != ActionGroup::Menu) frame_presses_[i] = 0;
    yaw_rad_ = 0.0;
    pitch_rad_ = 0.0;
}

void ActionLatch::release_keyboard() {
    std::erase_if(holders_, [](const Holder& h) { return h.kind == DeviceEventKind::Key; });
    waiting_.clear();
}

void ActionLatch::release_pad() {
    std::erase_if(holders_, [](const Holder& h) { return h.kind == DeviceEventKind::PadButton; });
    axis_holders_.clear();
    axis_trusted_.fill(false);
    last_device_ = LastDevice::KeyboardMouse;
}

float ActionLatch::amount_of(Action action) const {
    const std::size_t i = index_of(action);
    if (bindings_.hold_mode[i] == HoldMode::Toggle) return toggled_[i] ? 1.0F : 0.0F;
    const auto holds = [&](const Holder& h) { return h.action == action; };
    if (std::ranges::any_of(holders_, holds)) return 1.0F;
    float most = 0.0F;
    for (const AxisHolder& holder : axis_holders_)
        if (holder.action == action) most = std::max(most, holder.amount);
    return most;
}

void ActionLatch::drop_sudden_focus_changes(const InputSnapshot& input, const InputFocus& now) {
    const bool menu_changed = now.menu_open != focus_.menu_open;
    if (input.lost_focus || !input.focused || input.stalled || menu_changed) release_everything();
    if (now.ui_keyboard && !focus_.ui_keyboard) release_keyboard();
    if (pad_present_ && !input.pad_present) release_pad();
    pad_present_ = input.pad_present;
    focus_ = now;
}

ActionLatch::ActionLatch(Bindings bindings) : bindings_(std::move(bindings)), label_of_(us_label) {}

void ActionLatch::update(const InputSnapshot& input, const InputFocus& focus) {
    const double elapsed_s =
        updated_once_ && input.now_s > last_now_s_ ? input.now_s - last_now_s_ : 0.0;
    updated_once_ = true;
    last_now_s_ = input.now_s;
    drop_sudden_focus_changes(input, focus);
    for (const DeviceEvent& event : input.events) on_event(event);
    keys_down_ = input.keys;
    start_what_waited(input.now_s);
    if (!input.focused) {
        release_everything();
        return;
    }
    if (input.pad_present) follow_axes(input);
    if (!focus.menu_open) follow_look(input, elapsed_s);
}

Actions ActionLatch::take() {
    Actions actions;
    for (std::size_t i = 0; i < kActionCount; ++i) {
        actions.amount[i] = amount_of(static_cast<Action>(i));
        actions.held[i] = actions.amount[i] > 0.0F;
    }
    actions.pressed = std::exchange(step_presses_, {});
    actions.look_yaw_rad = pending_yaw_rad();
    actions.look_pitch_rad = pending_pitch_rad();
    actions.pointer = focus_.pointer;
    yaw_rad_ = 0.0;
    pitch_rad_ = 0.0;
    return actions;
}

int ActionLatch::take_frame_presses(Action action) {
    return std::exchange(frame_presses_[index_of(action)], 0);
}

void ActionLatch::release(Action action) {
    toggled_.reset(index_of(action));
    std::erase_if(holders_, [&](const Holder& h) { return h.action == action; });
}

void ActionLatch::engage(Action action) {
    if (bindings_.hold_mode[index_of(action)] == HoldMode::Toggle) toggled_.set(index_of(action));
}

void ActionLatch::set_bindings(Bindings bindings) {
    release_everything();
    bindings_ = std::move(bindings);
}

void ActionLatch::set_label_lookup(LabelLookup lookup) {
    label_of_ = lookup ? std::move(lookup) : LabelLookup{us_label};
}

}  // namespace plumbline::input
