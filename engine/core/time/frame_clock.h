// Wall time in, whole fixed steps out: the only clock of the simulation.
#pragma once

namespace plumbline {

/// What one frame owes the simulation.
struct FrameTime {
    int steps{0};        ///< whole fixed steps to run now
    float blend{0};      ///< 0…1: how far the frame stands between the last two poses
    double lost_s{0};    ///< dropped in this frame because nobody was there to see it
    double budget_s{0};  ///< wall time that stepping may take in this frame
};

/// Turns uneven frames into even steps (Fiedler 2004, "Fix Your Timestep!"). A slow frame loses no
/// time: however long a frame took, all of its steps are due. Time is dropped in two cases only, and
/// counted:
/// - a hole of more than kHole_s (a suspended machine, a debugger) is no slow frame: kAfterHole_s
///   of it run;
/// - stepping used up the frame's budget, three quarters of the time that has passed: physics itself
///   is too slow. The caller stops and says so to drop(). Then the next frame is due before the
///   debt has grown, so a slow machine shows slow motion, not a spiral.
/// Negative and non-finite intervals count as 0.
class FrameClock {
public:
    /// Far longer than the longest frame that somebody still plays at.
    static constexpr double kHole_s = 4.0;
    static constexpr double kAfterHole_s = 0.25;
    /// At most 4 times as long as without physics are the frames of a machine that is too slow for it.
    static constexpr double kStepShare = 0.75;
    /// Less than this is not felt, whatever share it is.
    static constexpr double kLeastBudget_s = 0.05;

    /// step_s > 0.
    explicit FrameClock(double step_s);

    /// now_s: a steady clock. The first call owes nothing.
    FrameTime advance(double now_s);
    /// So many of the steps that were due did not run, for lack of CPU time.
    void drop(int steps);

    void set_paused(bool paused) { paused_ = paused; }
    bool paused() const { return paused_; }
    /// Time stands still as in a pause, which the person's own pause neither ends nor knows: while a
    /// menu is open.
    void hold(bool held) { held_ = held; }
    bool stands_still() const { return paused_ || held_; }
    /// Runs one step in the next frame, paused or not.
    void request_step() { step_requested_ = true; }

    /// 1 is real time; clamped to [1/16, 4]. A non-finite speed changes nothing.
    void set_speed(double speed);
    double speed() const { return speed_; }

    /// From the next frame on steps are as long as this; > 0. Time that is owed stays owed.
    void set_step(double step_s);

    double lost_s() const { return lost_s_; }          ///< total so far, in simulated time
    double too_slow_s() const { return too_slow_s_; }  ///< the part of it that drop() told
    double step_s() const { return step_s_; }

private:
    double step_s_;
    double speed_{1.0};
    double pending_s_{0.0};
    double last_now_s_{0.0};
    double lost_s_{0.0};
    double too_slow_s_{0.0};
    bool started_{false};
    bool paused_{false};
    bool held_{false};
    bool step_requested_{false};
};

}  // namespace plumbline
