#include "engine/study/findings/difference.h"

#include <algorithm>
#include <cmath>

namespace plumbline::study {

Difference paired_difference(std::span<const double> with, std::span<const double> without) {
    const std::size_t pairs = std::min(with.size(), without.size());
    Difference difference{.pairs = static_cast<int>(pairs)};
    if (pairs == 0) return difference;
    const auto count = static_cast<double>(pairs);
    for (std::size_t i = 0; i < pairs; ++i) difference.mean += (with[i] - without[i]) / count;
    if (pairs == 1) return difference;
    double squares = 0;
    for (std::size_t i = 0; i < pairs; ++i) {
        const double off = with[i] - without[i] - difference.mean;
        squares += off * off;
    }
    difference.standard_error = std::sqrt(squares / (count - 1.0) / count);
    return difference;
}

}  // namespace plumbline::study
