// Whether the person should be told that physics itself is too slow for real time.
#pragma once

#include <optional>

namespace plumbline::app {

/// Looks at the time that FrameClock dropped for want of CPU time, over the latest seconds.
class SlowMotion {
public:
    static constexpr double kLook_s = 3.0;
    static constexpr double kShareFelt = 0.1;
    static constexpr double kSilence_s = 60.0;  ///< between one notice and the next

    /// Once a frame; too_slow_s: FrameClock::too_slow_s(). The share of the latest seconds that was
    /// lost, when it is felt and was not told for a while.
    std::optional<double> look(double now_s, double too_slow_s);

private:
    std::optional<double> since_s_;
    double lost_before_s_{0};
    std::optional<double> told_s_;
};

}  // namespace plumbline::app
