// Choices among measured points: the cheapest within a tolerance, the most accurate within a budget, and
// the points that no other beats. Pure functions; indices refer to the span that was given.
#pragma once

#include "engine/study/findings/findings.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace plumbline::study {

/// Magnitude of the metric that is furthest off, relative as that metric says. Infinity where the point
/// has none: it is not Done, or an error is not a number.
double error_of(const Point& point);
/// CPU ms for 1/60 s of simulated time, least of the repeats. Infinity unless Done and measured.
double ms_per_frame(const Point& point);

/// The cheapest point whose error is at most that.
std::optional<std::size_t> cheapest_within(std::span<const Point> points, double tolerance);
/// The most accurate point that costs at most that many ms a frame.
std::optional<std::size_t> most_accurate_within(std::span<const Point> points, double budget_ms);

/// Points that no other beats in both cost and error, by rising cost. Of equals the first stands.
std::vector<std::size_t> pareto_front(std::span<const Point> points);

/// One setting to use. Not `met`: nothing does what was asked, this is what comes nearest.
struct Choice {
    std::size_t point{0};
    bool met{false};
};
/// The cheapest within the tolerance, else the most accurate. None: no point has an error.
std::optional<Choice> choose_for_tolerance(std::span<const Point> points, double tolerance);
/// The most accurate within the budget, else the cheapest. None: no point has an error.
std::optional<Choice> choose_for_budget(std::span<const Point> points, double budget_ms);

}  // namespace plumbline::study
