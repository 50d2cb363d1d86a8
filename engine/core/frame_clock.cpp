#include "engine/core/frame_clock.h"

#include "engine/core/assert.h"

#include <algorithm>

namespace plumbline {

FrameClock::FrameClock(double step_s, int max_steps_per_frame)
    : step_s_(step_s), max_steps_per_frame_(max_steps_per_frame) {
    PL_ASSERT(step_s > 0.0 && max_steps_per_frame >= 1, "a positive step and cap");
}

void FrameClock::set_speed(double speed) {
    if (std::isfinite(speed)) speed_ = std::clamp(speed, 1.0 / 16.0, 4.0);
}

void FrameClock::set_step(double step_s) {
    PL_ASSERT(step_s > 0.0, "a positive step");
    step_s_ = step_s;
}

FrameTime FrameClock::advance(double now_s) {
    double passed_s = 0.0;
    if (std::isfinite(now_s)) {
        if (started_) passed_s = std::max(0.0, now_s - last_now_s_);
        last_now_s_ = now_s;
        started_ = true;
    }

    FrameTime time;
    if (step_requested_) {
        step_requested_ = false;
        time.steps = 1;
    }
    if (paused_) {
        time.blend = 1.0F;
        return time;
    }

    pending_s_ += passed_s * speed_;
    // Rounding must not hold a step back that is due but for the last bit.
    const double slack_s = step_s_ * 1e-9;
    const double cap_s = step_s_ * max_steps_per_frame_;
    if (pending_s_ >= cap_s + step_s_) {
        time.lost_s = pending_s_ - cap_s;
        lost_s_ += time.lost_s;
        pending_s_ = cap_s;
    }
    const int due =
        std::min(static_cast<int>((pending_s_ + slack_s) / step_s_), max_steps_per_frame_);
    time.steps += due;
    pending_s_ = std::max(0.0, pending_s_ - due * step_s_);
    time.blend = static_cast<float>(std::clamp(pending_s_ / step_s_, 0.0, 1.0));
    return time;
}

}  // namespace plumbline
