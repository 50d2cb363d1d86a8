// Settings in few letters, for keys and tables where the solver or the rate is said elsewhere.
#pragma once

#include "engine/study/setting.h"

#include <string>

namespace plumbline::study {

/// Without the solver: "60 Hz x 4", "60 Hz, 10 it".
std::string short_setting(const Setting& setting);

/// Without the step rate: "small_step x 4", "small_step x 2-16", "bullet_si, 10 it, float64".
std::string family_name(const Setting& setting);

/// Solver and precision: "bullet_si, float64".
std::string contender_name(const Setting& setting);

}  // namespace plumbline::study
