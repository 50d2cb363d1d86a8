// Wall time in, whole fixed steps out: the only clock of the simulation.
#pragma once

namespace plumbline {

/// What one frame owes the simulation.
struct FrameTime {
    int steps{0};      ///< whole fixed steps to run now
    float blend{0};    ///< 0…1: how far the picture stands between the last two poses
    double lost_s{0};  ///< wall time dropped in this frame because the cap was reached
};

/// Turns uneven frames into even steps (Fiedler 2004, "Fix Your Timestep!"). Time beyond the cap is
/// dropped and counted, never caught up with: a slow machine shows slow motion, not a spiral.
/// Negative, non-finite and huge intervals are survived: they count as 0 or as the cap.
class FrameClock {
public:
    /// step_s > 0; max_steps_per_frame >= 1.
    FrameClock(double step_s, int max_steps_per_frame);

    /// now_s: a steady clock. The first call owes nothing.
    FrameTime advance(double now_s);

    void set_paused(bool paused) { paused_ = paused; }
    bool paused() const { return paused_; }
    /// Runs one step in the next frame, paused or not.
    void request_step() { step_requested_ = true; }

    /// 1 is real time; clamped to [1/16, 4]. A non-finite speed changes nothing.
    void set_speed(double speed);
    double speed() const { return speed_; }

    /// From the next frame on steps are as long as this; > 0. Time that is owed stays owed.
    void set_step(double step_s);

    double lost_s() const { return lost_s_; }  ///< total so far
    double step_s() const { return step_s_; }

private:
    double step_s_;
    int max_steps_per_frame_;
    double speed_{1.0};
    double pending_s_{0.0};
    double last_now_s_{0.0};
    double lost_s_{0.0};
    bool started_{false};
    bool paused_{false};
    bool step_requested_{false};
};

}  // namespace plumbline
