// The keys of [tuning]: one table for reading, ranges and printing.
#pragma once

#include "engine/input/bindings.h"

#include <span>

namespace plumbline::input {

/// Either a flag or a number with its range.
struct TuningKey {
    std::string_view name;
    float Tuning::*number{nullptr};
    bool Tuning::*flag{nullptr};
    double min{0.0};
    double max{0.0};
};

std::span<const TuningKey> tuning_keys();
std::span<const std::string_view> tuning_key_names();
const TuningKey* find_tuning_key(std::string_view name);  ///< null where there is none

}  // namespace plumbline::input
