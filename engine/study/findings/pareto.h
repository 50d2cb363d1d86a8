// Choices among measured points: the cheapest within a tolerance, the most accurate within a budget, and
// the points that no other beats. Pure functions; indices refer to the span that was given.
#pragma once

#include "engine/study/findings/findings.h"

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace plumbline::study {

/// Instead of a metric: the one that is furthest off.
inline constexpr std::size_t kWorstMetric = std::numeric_limits<std::size_t>::max();

/// What tables ask for: relative errors, and CPU ms for 1/60 s of simulated time.
inline constexpr std::array<double, 3> kTolerances{0.05, 0.01, 0.001};
inline constexpr std::array<double, 3> kBudgets_ms{0.1, 0.5, 2.0};

/// Magnitude, relative as its metric says. Infinity where the point has none: it is not Done, lacks
/// that metric, or an error is not a number.
double error_of(const Point& point, std::size_t metric = kWorstMetric);
/// CPU ms for 1/60 s of simulated time, least of the repeats. Infinity unless Done and measured.
double ms_per_frame(const Point& point);

/// One line of a table: what was asked for, and the point that serves it, if any does.
struct Pick {
    double asked{0};  ///< tolerance, or budget in ms a frame
    std::optional<std::size_t> point;
};

/// Per tolerance the cheapest point whose error is at most that.
std::vector<Pick> cost_to_reach(std::span<const Point> points,
                                std::span<const double> tolerances = kTolerances,
                                std::size_t metric = kWorstMetric);
/// Per budget the most accurate point that costs at most that many ms a frame.
std::vector<Pick> error_at_budget(std::span<const Point> points,
                                  std::span<const double> budgets_ms = kBudgets_ms,
                                  std::size_t metric = kWorstMetric);

/// Points that no other beats in both cost and error, by rising cost. Of equals the first stands.
std::vector<std::size_t> pareto_front(std::span<const Point> points,
                                      std::size_t metric = kWorstMetric);

/// One setting to use. Not `met`: nothing does what was asked, this is what comes nearest.
struct Recommendation {
    std::size_t point{0};
    bool met{false};
};
/// The cheapest within the tolerance, else the most accurate. None: no point has an error.
std::optional<Recommendation> recommend_for_tolerance(std::span<const Point> points,
                                                      double tolerance,
                                                      std::size_t metric = kWorstMetric);
/// The most accurate within the budget, else the cheapest. None: no point has an error.
std::optional<Recommendation> recommend_for_budget(std::span<const Point> points,
                                                   double budget_ms,
                                                   std::size_t metric = kWorstMetric);

}  // namespace plumbline::study
