#include "engine/study/findings/pareto.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace plumbline::study {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

struct Rated {
    double cost_ms;
    double error;
    bool usable() const { return cost_ms < kNone && error < kNone; }
};

Rated rate(const Point& point, std::size_t metric) {
    return {ms_per_frame(point), error_of(point, metric)};
}

bool cheaper(const Rated& a, const Rated& b) {
    return a.cost_ms != b.cost_ms ? a.cost_ms < b.cost_ms : a.error < b.error;
}
bool more_accurate(const Rated& a, const Rated& b) {
    return a.error != b.error ? a.error < b.error : a.cost_ms < b.cost_ms;
}

/// The first by `before` among usable points that `fits` admits.
template <class Fits, class Before>
std::optional<std::size_t> best(std::span<const Point> points,
                                std::size_t metric,
                                Fits fits,
                                Before before) {
    std::optional<std::size_t> found;
    Rated found_rated{kNone, kNone};
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Rated rated = rate(points[i], metric);
        if (!rated.usable() || !fits(rated)) continue;
        if (found && !before(rated, found_rated)) continue;
        found = i;
        found_rated = rated;
    }
    return found;
}

std::optional<std::size_t> cheapest_within(std::span<const Point> points,
                                           double tolerance,
                                           std::size_t metric) {
    return best(
        points, metric, [&](const Rated& rated) { return rated.error <= tolerance; }, cheaper);
}

std::optional<std::size_t> most_accurate_within(std::span<const Point> points,
                                                double budget_ms,
                                                std::size_t metric) {
    return best(
        points,
        metric,
        [&](const Rated& rated) { return rated.cost_ms <= budget_ms; },
        more_accurate);
}

}  // namespace

double error_of(const Point& point, std::size_t metric) {
    if (point.status != RunStatus::Done || point.errors.empty()) return kNone;
    if (metric != kWorstMetric) {
        if (metric >= point.errors.size()) return kNone;
        const double error = std::abs(point.errors[metric]);
        return std::isfinite(error) ? error : kNone;
    }
    double worst = 0.0;
    for (const double error : point.errors) {
        if (!std::isfinite(error)) return kNone;
        worst = std::max(worst, std::abs(error));
    }
    return worst;
}

double ms_per_frame(const Point& point) {
    if (point.status != RunStatus::Done || point.cost.repeats == 0) return kNone;
    const double ms = point.cost.ms_per_s_min / kFrames_per_s;
    return std::isfinite(ms) ? ms : kNone;
}

std::vector<Pick> cost_to_reach(std::span<const Point> points,
                                std::span<const double> tolerances,
                                std::size_t metric) {
    std::vector<Pick> picks;
    for (const double tolerance : tolerances)
        picks.push_back({tolerance, cheapest_within(points, tolerance, metric)});
    return picks;
}

std::vector<Pick> error_at_budget(std::span<const Point> points,
                                  std::span<const double> budgets_ms,
                                  std::size_t metric) {
    std::vector<Pick> picks;
    for (const double budget_ms : budgets_ms)
        picks.push_back({budget_ms, most_accurate_within(points, budget_ms, metric)});
    return picks;
}

std::vector<std::size_t> pareto_front(std::span<const Point> points, std::size_t metric) {
    std::vector<std::size_t> by_cost(points.size());
    std::iota(by_cost.begin(), by_cost.end(), std::size_t{0});
    std::erase_if(by_cost, [&](std::size_t i) { return !rate(points[i], metric).usable(); });
    std::ranges::stable_sort(by_cost, [&](std::size_t a, std::size_t b) {
        return cheaper(rate(points[a], metric), rate(points[b], metric));
    });
    std::vector<std::size_t> front;
    double least_error = kNone;
    for (const std::size_t i : by_cost) {
        const double error = error_of(points[i], metric);
        if (error >= least_error) continue;
        least_error = error;
        front.push_back(i);
    }
    return front;
}

std::optional<Recommendation> recommend_for_tolerance(std::span<const Point> points,
                                                      double tolerance,
                                                      std::size_t metric) {
    if (const auto cheapest = cheapest_within(points, tolerance, metric))
        return Recommendation{*cheapest, true};
    if (const auto nearest = most_accurate_within(points, kNone, metric))
        return Recommendation{*nearest, false};
    return {};
}

std::optional<Recommendation> recommend_for_budget(std::span<const Point> points,
                                                   double budget_ms,
                                                   std::size_t metric) {
    if (const auto best_one = most_accurate_within(points, budget_ms, metric))
        return Recommendation{*best_one, true};
    if (const auto cheapest = cheapest_within(points, kNone, metric))
        return Recommendation{*cheapest, false};
    return {};
}

}  // namespace plumbline::study
