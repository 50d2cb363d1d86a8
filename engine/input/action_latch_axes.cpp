#include "engine/core/math.h"
#include "engine/input/action_latch.h"
#include "engine/input/stick.h"

#include <algorithm>
#include <cmath>

namespace plumbline::input {
namespace {

constexpr float kTriggerHysteresis = 0.1F;
constexpr float kRestZone = 0.3F;  // a stick that came closer to its centre is trusted
constexpr double kMaxLookStep_s = 0.1;

/// Walking follows the stick's travel; everything else is pressed when an axis passes a threshold.
bool is_analog(Action action) {
    return action == Action::Forward || action == Action::Back || action == Action::Left ||
           action == Action::Right;
}

}  // namespace

void ActionLatch::follow_axis(Action action, const Input& source, const InputSnapshot& input) {
    const auto axis = static_cast<std::size_t>(source.code);
    const bool is_trigger = axis >= kTriggerAxis;
    float amount = 0.0F;
    if (is_trigger) {
        amount = trigger_travel(input.pad_axes[axis]);
    } else {
        const std::size_t x = axis & ~std::size_t{1};
        const auto shaped = shape_stick(input.pad_axes[x], input.pad_axes[x + 1], bindings_.tuning);
        amount = std::max(shaped[axis - x] * static_cast<float>(source.direction), 0.0F);
    }
    const auto held = std::ranges::find_if(axis_holders_, [&](const AxisHolder& h) {
        return h.action == action && h.axis == axis && h.direction == source.direction;
    });
    const bool was_held = held != axis_holders_.end();
    const float threshold =
        is_analog(action) && !is_trigger
            ? 0.0F
            : bindings_.tuning.trigger_threshold - (was_held ? kTriggerHysteresis : 0.0F);
    const bool is_held = axis_trusted_[axis] && amount > 0.0F && amount >= threshold;
    if (is_held && was_held) {
        held->amount = amount;
    } else if (is_held) {
        axis_holders_.push_back({action, axis, source.direction, amount});
        press(action);
        last_device_ = LastDevice::Gamepad;
    } else if (was_held) {
        axis_holders_.erase(held);
    }
}

// Some pads report half-pressed triggers or a pushed stick until they are first touched: an axis
// counts only after it has been seen at rest.
void ActionLatch::follow_axes(const InputSnapshot& input) {
    for (std::size_t axis = 0; axis < input.pad_axes.size(); ++axis) {
        const float value = input.pad_axes[axis];
        const float travel = axis >= kTriggerAxis ? trigger_travel(value) : std::abs(value);
        if (travel < kRestZone) axis_trusted_[axis] = true;
    }
    for (std::size_t i = 0; i < kActionCount; ++i) {
        const auto action = static_cast<Action>(i);
        if (!is_live(action)) continue;
        for (const Input& source : bindings_.inputs[i])
            if (source.kind == DeviceKind::PadAxis) follow_axis(action, source, input);
    }
}

void ActionLatch::follow_look(const InputSnapshot& input, double elapsed_s) {
    const Tuning& tuning = bindings_.tuning;
    const double up = tuning.invert_y ? -1.0 : 1.0;
    double yaw_deg = 0.0;
    double pitch_deg = 0.0;
    for (const Input& source : bindings_.of(Action::Look)) {
        if (source.kind == DeviceKind::MouseMove && !focus_.ui_mouse && !focus_.pointer) {
            const double right = input.mouse_counts[0];
            const double down = input.mouse_counts[1];
            if (!std::isfinite(right) || !std::isfinite(down)) continue;
            const auto deg_per_count = static_cast<double>(tuning.mouse_deg_per_count);
            yaw_deg -= right * deg_per_count;
            pitch_deg -= down * deg_per_count * up;
            if (right != 0.0 || down != 0.0) last_device_ = LastDevice::KeyboardMouse;
        } else if (source.kind == DeviceKind::PadStick && input.pad_present) {
            const std::size_t x = source.code == 0 ? 0 : 2;
            if (!axis_trusted_[x] || !axis_trusted_[x + 1]) continue;
            const auto shaped = shape_stick(input.pad_axes[x], input.pad_axes[x + 1], tuning);
            const double step_deg = static_cast<double>(tuning.pad_look_deg_per_s) *
                                    std::clamp(elapsed_s, 0.0, kMaxLookStep_s);
            yaw_deg -= static_cast<double>(shaped[0]) * step_deg;
            pitch_deg -= static_cast<double>(shaped[1]) * step_deg * up;
            if (shaped[0] != 0.0F || shaped[1] != 0.0F) last_device_ = LastDevice::Gamepad;
        }
    }
    if (yaw_deg == 0.0 && pitch_deg == 0.0) return;
    yaw_rad_ += radians_from_degrees(yaw_deg);
    pitch_rad_ += radians_from_degrees(pitch_deg);
    ++presses_seen_[index_of(Action::Look)];
}

}  // namespace plumbline::input
