#include "engine/app/slow_motion.h"

namespace plumbline::app {

std::optional<double> SlowMotion::look(double now_s, double too_slow_s) {
    if (!since_s_) {
        since_s_ = now_s;
        lost_before_s_ = too_slow_s;
        return {};
    }
    const double watched_s = now_s - *since_s_;
    if (watched_s < kLook_s) return {};
    const double share = (too_slow_s - lost_before_s_) / watched_s;
    since_s_ = now_s;
    lost_before_s_ = too_slow_s;
    if (share < kShareFelt || (told_s_ && now_s - *told_s_ < kSilence_s)) return {};
    told_s_ = now_s;
    return share;
}

}  // namespace plumbline::app
