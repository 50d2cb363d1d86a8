#include "engine/input/action_latch.h"

#include "engine/core/math.h"
#include "engine/input/modifier_keys.h"
#include "engine/input/stick.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace plumbline::input {
namespace {

constexpr std::size_t kTriggerAxis = 4;  // this one and the next are triggers
constexpr float kTriggerHysteresis = 0.1F;
constexpr float kRestZone = 0.3F;  // a stick that came closer to its centre is trusted
constexpr double kMaxLookStep_s = 0.1;
constexpr double kJump_counts = 1'000.0;  // in a frame of kJumpFrame_s or less
constexpr double kLargestJump_counts = 4'000.0;
constexpr double kJumpFrame_s = 0.02;
// A modifier key that begins chords as well drives its own action only once no chord can be meant.
constexpr double kChordWait_s = 0.15;

constexpr std::size_t index_of(Action action) {
    return static_cast<std::size_t>(action);
}

/// Walking follows the stick's travel; everything else is pressed when an axis passes a threshold.
bool is_analog(Action action) {
    return action == Action::Forward || action == Action::Back || action == Action::Left ||
           action == Action::Right;
}

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

std::string us_label(int key) {
    if (key <= ' ' || key > '`') return {};
    return std::string(1, lower(static_cast<char>(key)));
}

/// An input that holds its action down, and the key or button that does so.
struct Holder {
    Action action;
    DeviceEventKind kind;
    int code;
    std::uint8_t modifiers;
};

/// A modifier key that may yet become part of a chord.
struct Waiting {
    Holder holder;
    double since_s;
};

/// The same for axes, which come as states, not events.
struct AxisHolder {
    Action action;
    std::size_t axis;
    int direction;
    float amount;
};

}  // namespace

struct ActionLatch::Impl {
    Bindings bindings;
    LabelLookup label_of{us_label};
    std::vector<Holder> holders;
    std::vector<Waiting> waiting;
    std::vector<AxisHolder> axis_holders;
    std::bitset<kActionCount> toggled;
    std::array<std::uint8_t, kActionCount> step_presses{};
    std::array<int, kActionCount> frame_presses{};
    std::array<std::uint64_t, kActionCount> presses_seen{};
    std::bitset<kKeyCount> keys_down;  // as of the event being read
    std::array<bool, kPadAxisCount> axis_trusted{};
    double yaw_rad{0.0};
    double pitch_rad{0.0};
    double last_now_s{0.0};
    std::uint64_t jumps_dropped{0};
    LastDevice last_device{LastDevice::KeyboardMouse};
    InputFocus focus{};
    bool updated_once{false};
    bool pad_present{false};

    bool is_live(Action action) const;
    bool matches(const Input& input, const DeviceEvent& event) const;
    void press(Action action);
    bool begins_chords(const DeviceEvent& event) const;
    void on_press(const DeviceEvent& event);
    void end_waiting(std::uint8_t chord);
    void start_what_waited(double now_s);
    void on_release(DeviceEventKind kind, int code);
    void drop_broken_chords();
    void on_event(const DeviceEvent& event);
    void release_everything();
    void release_keyboard();
    void release_pad();
    void follow_axes(const InputSnapshot& input);
    void follow_axis(Action action, const Input& source, const InputSnapshot& input);
    void follow_look(const InputSnapshot& input, double elapsed_s);
    void drop_sudden_focus_changes(const InputSnapshot& input, const InputFocus& now);
    float amount_of(Action action) const;
};

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
                return printed.size() == 1 && lower(printed[0]) == lower(input.label);
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
    constexpr int kEscape = 256;
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
    if (is_key && focus.ui_keyboard && event.code != kEscape) return;
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

void ActionLatch::Impl::follow_axis(Action action,
                                    const Input& source,
                                    const InputSnapshot& input) {
    const auto axis = static_cast<std::size_t>(source.code);
    const bool is_trigger = axis >= kTriggerAxis;
    float amount = 0.0F;
    if (is_trigger) {
        amount = trigger_travel(input.pad_axes[axis]);
    } else {
        const std::size_t x = axis & ~std::size_t{1};
        const auto shaped = shape_stick(input.pad_axes[x], input.pad_axes[x + 1], bindings.tuning);
        amount = std::max(shaped[axis - x] * static_cast<float>(source.direction), 0.0F);
    }
    const auto held = std::ranges::find_if(axis_holders, [&](const AxisHolder& h) {
        return h.action == action && h.axis == axis && h.direction == source.direction;
    });
    const bool was_held = held != axis_holders.end();
    const float threshold =
        is_analog(action) && !is_trigger
            ? 0.0F
            : bindings.tuning.trigger_threshold - (was_held ? kTriggerHysteresis : 0.0F);
    const bool is_held = axis_trusted[axis] && amount > 0.0F && amount >= threshold;
    if (is_held && was_held) {
        held->amount = amount;
    } else if (is_held) {
        axis_holders.push_back({action, axis, source.direction, amount});
        press(action);
        last_device = LastDevice::Gamepad;
    } else if (was_held) {
        axis_holders.erase(held);
    }
}

// Some pads report half-pressed triggers or a pushed stick until they are first touched: an axis
// counts only after it has been seen at rest.
void ActionLatch::Impl::follow_axes(const InputSnapshot& input) {
    for (std::size_t axis = 0; axis < input.pad_axes.size(); ++axis) {
        const float value = input.pad_axes[axis];
        const float travel = axis >= kTriggerAxis ? trigger_travel(value) : std::abs(value);
        if (travel < kRestZone) axis_trusted[axis] = true;
    }
    for (std::size_t i = 0; i < kActionCount; ++i) {
        const auto action = static_cast<Action>(i);
        if (!is_live(action)) continue;
        for (const Input& source : bindings.inputs[i])
            if (source.kind == DeviceKind::PadAxis) follow_axis(action, source, input);
    }
}

void ActionLatch::Impl::follow_look(const InputSnapshot& input, double elapsed_s) {
    const Tuning& tuning = bindings.tuning;
    const double up = tuning.invert_y ? -1.0 : 1.0;
    double yaw_deg = 0.0;
    double pitch_deg = 0.0;
    for (const Input& source : bindings.of(Action::Look)) {
        if (source.kind == DeviceKind::MouseMove && !focus.ui_mouse) {
            const double right = input.mouse_counts[0];
            const double down = input.mouse_counts[1];
            const double limit = std::clamp(
                kJump_counts * elapsed_s / kJumpFrame_s, kJump_counts, kLargestJump_counts);
            // Written so that a number which is none fails too.
            if (!(std::abs(right) <= limit && std::abs(down) <= limit)) {
                ++jumps_dropped;
                continue;
            }
            const auto deg_per_count = static_cast<double>(tuning.mouse_deg_per_count);
            yaw_deg -= right * deg_per_count;
            pitch_deg -= down * deg_per_count * up;
            if (right != 0.0 || down != 0.0) last_device = LastDevice::KeyboardMouse;
        } else if (source.kind == DeviceKind::PadStick && input.pad_present) {
            const std::size_t x = source.code == 0 ? 0 : 2;
            if (!axis_trusted[x] || !axis_trusted[x + 1]) continue;
            const auto shaped = shape_stick(input.pad_axes[x], input.pad_axes[x + 1], tuning);
            const double step_deg = static_cast<double>(tuning.pad_look_deg_per_s) *
                                    std::clamp(elapsed_s, 0.0, kMaxLookStep_s);
            yaw_deg -= static_cast<double>(shaped[0]) * step_deg;
            pitch_deg -= static_cast<double>(shaped[1]) * step_deg * up;
            if (shaped[0] != 0.0F || shaped[1] != 0.0F) last_device = LastDevice::Gamepad;
        }
    }
    if (yaw_deg == 0.0 && pitch_deg == 0.0) return;
    yaw_rad += radians_from_degrees(yaw_deg);
    pitch_rad += radians_from_degrees(pitch_deg);
    ++presses_seen[index_of(Action::Look)];
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

std::uint64_t ActionLatch::mouse_jumps_dropped() const {
    return impl_->jumps_dropped;
}

}  // namespace plumbline::input
