// The difference between two ways to do a thing, measured in turns.
#pragma once

#include <span>

namespace plumbline::study {

/// A difference of means, with its standard error.
struct Difference {
    double mean{0};
    double standard_error{0};
    int pairs{0};

    /// At least two standard errors from zero.
    bool is_significant() const {
        return pairs > 1 && (mean < 0 ? -mean : mean) > 2.0 * standard_error;
    }
};
/// Of pairs measured next to each other, with[i] - without[i]: what drifts slowly falls out.
Difference paired_difference(std::span<const double> with, std::span<const double> without);

}  // namespace plumbline::study
