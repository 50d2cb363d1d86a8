#include "engine/scene/environment/plaque.h"

#include <algorithm>
#include <cmath>

namespace plumbline::scene {
namespace {

constexpr double kMean_s = 1;
constexpr double kSamePeriod = 0.1;  // of the mean

}  // namespace

void PlaqueMeter::note(PlaqueQuantity quantity, double value, double step_s) {
    if (quantity == PlaqueQuantity::Period) return note_coordinate(value, step_s);
    if (!measured_) measured_ = value;
    *measured_ += (value - *measured_) * std::min(step_s / kMean_s, 1.0);
}

void PlaqueMeter::note_coordinate(double value, double step_s) {
    if (samples_ == 2 && last_ >= before_ && last_ > value) {
        // The top of the parabola through three steps.
        const double bend = before_ - 2 * last_ + value;
        note_maximum(time_s_ + step_s * (before_ - value) / (2 * bend));
    }
    before_ = last_;
    last_ = value;
    samples_ = std::min(samples_ + 1, 2);
    time_s_ += step_s;
}

void PlaqueMeter::note_maximum(double time_s) {
    if (maximum_s_) {
        const double period_s = time_s - *maximum_s_;
        const bool is_same =
            measured_ && std::abs(period_s - *measured_) < kSamePeriod * *measured_;
        periods_ = is_same ? periods_ + 1 : 1;
        measured_ = is_same ? *measured_ + (period_s - *measured_) / periods_ : period_s;
    }
    maximum_s_ = time_s;
}

void PlaqueMeter::serialize(Archive& archive) {
    archive(measured_, before_, last_, samples_, time_s_, maximum_s_, periods_);
}

}  // namespace plumbline::scene
