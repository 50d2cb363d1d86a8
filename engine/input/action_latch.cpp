#include "engine/core/text/text_case.h"
#include "engine/input/action_latch_impl.h"
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

bool ActionLatch::Impl::is_live(Action action) const {
    if (action == Action::Menu) return true;
    return (group_of(action) == ActionGroup::Menu) == focus.menu_open;
}

bool ActionLatch::Impl::matches(const Input& input, const DeviceEvent& event) const {
    switch (event.kind) {
        case DeviceEventKind::Key:
            if (input.kind == DeviceKind::Key) return input.code == event.code;
            if (input.kind == DeviceKind::Label && event.code >= 0) {
                const std::string printed = label_of(event.code);
                return printed.size() == 1 && to_lower(printed[0]) == to_lower(input.label);
            }
            return false;
        case DeviceEventKind::MouseButton:
            return input.kind == DeviceKind::MouseButton && input.code == event.code;
        case DeviceEventKind::Wheel:
            return input.kind == DeviceKind::Wheel && input.code == event.code;
        case DeviceEventKind::PadButton:
            return input.kind == DeviceKind::PadButton && input.code == event.code;
    }
    return false;
}

void ActionLatch::Impl::press(Action action) {
    const std::size_t i = index_of(action);
    if (step_presses[i] < 255) ++step_presses[i];
    ++frame_presses[i];
    ++presses_seen[i];
    if (bindings.hold_mode[i] == HoldMode::Toggle) toggled.flip(i);
}

// Of the inputs on this key whose modifiers are down, those that ask for the most fire: a chord
// beats the plain key, and the plain key works whatever else is down.
void ActionLatch::Impl::on_press(const DeviceEvent& event) {
    on_release(event.kind, event.code);
    const std::uint8_t down = modifiers_down(keys_down);
    int most = -1;
    std::vector<Holder> found;
    for (std::size_t i = 0; i < kActionCount; ++i) {
        const auto action = static_cast<Action>(i);
        if (!is_live(action)) continue;
        for (const Input& input : bindings.inputs[i]) {
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
            waiting.push_back({holder, last_now_s});
            continue;
        }
        press(holder.action);
        if (event.kind != DeviceEventKind::Wheel) holders.push_back(holder);
    }
}

bool ActionLatch::Impl::begins_chords(const DeviceEvent& event) const {
    if (event.kind != DeviceEventKind::Key) return false;
    const std::uint8_t modifier = modifier_of(event.code);
    if (modifier == 0) return false;
    for (std::size_t i = 0; i < kActionCount; ++i) {
        if (!is_live(static_cast<Action>(i))) continue;
        for (const Input& input : bindings.inputs[i])
            if ((input.modifiers & modifier) != 0) return true;
    }
    return false;
}

// What the chord's own keys drive by themselves was not meant.
void ActionLatch::Impl::end_waiting(std::uint8_t chord) {
    const auto in_chord = [&](const Holder& holder) {
        return holder.kind == DeviceEventKind::Key && (modifier_of(holder.code) & chord) != 0;
    };
    std::erase_if(waiting, [&](const Waiting& each) { return in_chord(each.holder); });
    std::erase_if(holders, in_chord);
}

void ActionLatch::Impl::start_what_waited(double now_s) {
    std::erase_if(waiting, [&](const Waiting& each) {
        if (now_s - each.since_s < kChordWait_s) return false;
        press(each.holder.action);
        holders.push_back(each.holder);
        return true;
    });
}

void ActionLatch::Impl::on_release(DeviceEventKind kind, int code) {
    const auto mine = [&](const Holder& h) { return h.kind == kind && h.code == code; };
    std::erase_if(holders, mine);
    // Let go before it was clear that no chord is meant: a press all the same.
    std::erase_if(waiting, [&](const Waiting& each) {
        if (!mine(each.holder)) return false;
        press(each.holder.action);
        return true;
    });
}

void ActionLatch::Impl::drop_broken_chords() {
    const std::uint8_t down = modifiers_down(keys_down);
    std::erase_if(holders, [&](const Holder& h) { return (h.modifiers & down) != h.modifiers; });
}

void ActionLatch::Impl::on_event(const DeviceEvent& event) {
    const bool is_key = event.kind == DeviceEventKind::Key;
    if (is_key && event.code >= 0 && event.code < kKeyCount)
        keys_down[static_cast<std::size_t>(event.code)] = event.pressed;
    if (!event.pressed) {
        on_release(event.kind, event.code);
        if (is_key) drop_broken_chords();
        return;
    }
    last_device =
        event.kind == DeviceEventKind::PadButton ? LastDevice::Gamepad : LastDevice::KeyboardMouse;
    // A text field gets what is typed, but Escape always leads out.
    if (is_key && focus.ui_keyboard && event.code != kEscapeKey) return;
    const bool is_mouse =
        event.kind == DeviceEventKind::MouseButton || event.kind == DeviceEventKind::Wheel;
    if (is_mouse && focus.ui_mouse) return;
    on_press(event);
}

void ActionLatch::Impl::release_everything() {
    holders.clear();
    waiting.clear();
    axis_holders.clear();
    axis_trusted.fill(false);
    toggled.reset();
    step_presses.fill(0);
    for (std::size_t i = 0; i < kActionCount; ++i)
        if (group_of(static_cast<Action>(i)) != ActionGroup::Menu) frame_presses[i] = 0;
    yaw_rad = 0.0;
    pitch_rad = 0.0;
}

void ActionLatch::Impl::release_keyboard() {
    std::erase_if(holders, [](const Holder& h) { return h.kind == DeviceEventKind::Key; });
    waiting.clear();
}

void ActionLatch::Impl::release_pad() {
    std::erase_if(holders, [](const Holder& h) { return h.kind == DeviceEventKind::PadButton; });
    axis_holders.clear();
    axis_trusted.fill(false);
    last_device = LastDevice::KeyboardMouse;
}

float ActionLatch::Impl::amount_of(Action action) const {
    const std::size_t i = index_of(action);
    if (bindings.hold_mode[i] == HoldMode::Toggle) return toggled[i] ? 1.0F : 0.0F;
    const auto holds = [&](const Holder& h) { return h.action == action; };
    if (std::ranges::any_of(holders, holds)) return 1.0F;
    float most = 0.0F;
    for (const AxisHolder& holder : axis_holders)
        if (holder.action == action) most = std::max(most, holder.amount);
    return most;
}

void ActionLatch::Impl::drop_sudden_focus_changes(const InputSnapshot& input,
                                                  const InputFocus& now) {
    const bool menu_changed = now.menu_open != focus.menu_open;
    if (input.lost_focus || !input.focused || input.stalled || menu_changed) release_everything();
    if (now.ui_keyboard && !focus.ui_keyboard) release_keyboard();
    if (pad_present && !input.pad_present) release_pad();
    pad_present = input.pad_present;
    focus = now;
}

ActionLatch::ActionLatch(Bindings bindings) : impl_(std::make_unique<Impl>()) {
    impl_->bindings = std::move(bindings);
    impl_->label_of = us_label;
}

ActionLatch::~ActionLatch() = default;

void ActionLatch::update(const InputSnapshot& input, const InputFocus& focus) {
    Impl& latch = *impl_;
    const double elapsed_s =
        latch.updated_once && input.now_s > latch.last_now_s ? input.now_s - latch.last_now_s : 0.0;
    latch.updated_once = true;
    latch.last_now_s = input.now_s;
    latch.drop_sudden_focus_changes(input, focus);
    for (const DeviceEvent& event : input.events) latch.on_event(event);
    latch.keys_down = input.keys;
    latch.start_what_waited(input.now_s);
    if (!input.focused) {
        latch.release_everything();
        return;
    }
    if (input.pad_present) latch.follow_axes(input);
    if (!focus.menu_open) latch.follow_look(input, elapsed_s);
}

Actions ActionLatch::take() {
    Actions actions;
    for (std::size_t i = 0; i < kActionCount; ++i) {
        actions.amount[i] = impl_->amount_of(static_cast<Action>(i));
        actions.held[i] = actions.amount[i] > 0.0F;
    }
    actions.pressed = std::exchange(impl_->step_presses, {});
    actions.look_yaw_rad = pending_yaw_rad();
    actions.look_pitch_rad = pending_pitch_rad();
    actions.pointer = impl_->focus.pointer;
    impl_->yaw_rad = 0.0;
    impl_->pitch_rad = 0.0;
    return actions;
}

int ActionLatch::take_frame_presses(Action action) {
    return std::exchange(impl_->frame_presses[index_of(action)], 0);
}

float ActionLatch::pending_yaw_rad() const {
    return static_cast<float>(impl_->yaw_rad);
}

float ActionLatch::pending_pitch_rad() const {
    return static_cast<float>(impl_->pitch_rad);
}

void ActionLatch::release(Action action) {
    impl_->toggled.reset(index_of(action));
    std::erase_if(impl_->holders, [&](const Holder& h) { return h.action == action; });
}

void ActionLatch::engage(Action action) {
    if (impl_->bindings.hold_mode[index_of(action)] == HoldMode::Toggle)
        impl_->toggled.set(index_of(action));
}

void ActionLatch::set_bindings(Bindings bindings) {
    impl_->release_everything();
    impl_->bindings = std::move(bindings);
}

void ActionLatch::set_label_lookup(LabelLookup lookup) {
    impl_->label_of = lookup ? std::move(lookup) : LabelLookup{us_label};
}

const Bindings& ActionLatch::bindings() const {
    return impl_->bindings;
}

LastDevice ActionLatch::last_device() const {
    return impl_->last_device;
}

const std::array<std::uint64_t, kActionCount>& ActionLatch::presses_seen() const {
    return impl_->presses_seen;
}

}  // namespace plumbline::input
