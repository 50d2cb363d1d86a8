#include "engine/core/time/frame_clock.h"

#include "engine/core/assert.h"

#include <algorithm>
#include <cmath>

namespace plumbline {

FrameClock::FrameClock(double step_s) : step_s_(step_s) {
    PL_ASSERT(step_s > 0.0, "a positive step");
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
    if (stands_still()) {
        time.blend = 1.0F;
        return time;
    }

    if (passed_s > kHole_s) {
        time.lost_s = (passed_s - kAfterHole_s) * speed_;
        lost_s_ += time.lost_s;
        passed_s = kAfterHole_s;
    }
    time.budget_s = std::max(kLeastBudget_s, kStepShare * passed_s);
    pending_s_ += passed_s * speed_;
    // Rounding must not hold a step back that is due but for the last bit.
    const double slack_s = step_s_ * 1e-9;
    const int due = static_cast<int>((pending_s_ + slack_s) / step_s_);
    time.steps += due;
    pending_s_ = std::max(0.0, pending_s_ - due * step_s_);
    time.blend = static_cast<float>(std::clamp(pending_s_ / step_s_, 0.0, 1.0));
    return time;
}

void FrameClock::drop(int steps) {
    PL_ASSERT(steps >= 0, "a number of steps");
    too_slow_s_ += steps * step_s_;
    lost_s_ += steps * step_s_;
}

}  // namespace plumbline
