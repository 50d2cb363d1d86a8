#include "engine/study/findings/pareto.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace plumbline::study {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

struct Rated {
    double cost_ms;
    double error;
};

Rated rate(const Point& point) {
    return {ms_per_frame(point), error_of(point)};
}

bool usable(const Point& point) {
    const Rated rated = rate(point);
    return rated.cost_ms < kNone && rated.error < kNone;
}

bool cheaper(const Rated& a, const Rated& b) {
    return a.cost_ms != b.cost_ms ? a.cost_ms < b.cost_ms : a.error < b.error;
}
bool more_accurate(const Rated& a, const Rated& b) {
    return a.error != b.error ? a.error < b.error : a.cost_ms < b.cost_ms;
}

/// The usable points, the best by `before` first.
std::vector<std::size_t> sorted(std::span<const Point> points,
                                bool (*before)(const Rated& a, const Rated& b)) {
    std::vector<std::size_t> places(points.size());
    std::iota(places.begin(), places.end(), std::size_t{0});
    std::erase_if(places, [&](std::size_t i) { return !usable(points[i]); });
    std::ranges::stable_sort(places, before, [&](std::size_t i) { return rate(points[i]); });
    return places;
}

}  // namespace

double error_of(const Point& point) {
    if (point.status != RunStatus::Done || point.errors.empty()) return kNone;
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

std::optional<std::size_t> cheapest_within(std::span<const Point> points, double tolerance) {
    for (const std::size_t i : sorted(points, cheaper)) {
        if (error_of(points[i]) <= tolerance) return i;
    }
    return {};
}

std::optional<std::size_t> most_accurate_within(std::span<const Point> points, double budget_ms) {
    for (const std::size_t i : sorted(points, more_accurate)) {
        if (ms_per_frame(points[i]) <= budget_ms) return i;
    }
    return {};
}

std::vector<std::size_t> pareto_front(std::span<const Point> points) {
    std::vector<std::size_t> front;
    double least_error = kNone;
    for (const std::size_t i : sorted(points, cheaper)) {
        const double error = error_of(points[i]);
        if (error >= least_error) continue;
        least_error = error;
        front.push_back(i);
    }
    return front;
}

std::optional<Choice> choose_for_tolerance(std::span<const Point> points, double tolerance) {
    if (const auto cheapest = cheapest_within(points, tolerance)) return Choice{*cheapest, true};
    if (const auto nearest = most_accurate_within(points, kNone)) return Choice{*nearest, false};
    return {};
}

std::optional<Choice> choose_for_budget(std::span<const Point> points, double budget_ms) {
    if (const auto best = most_accurate_within(points, budget_ms)) return Choice{*best, true};
    if (const auto cheapest = cheapest_within(points, kNone)) return Choice{*cheapest, false};
    return {};
}

}  // namespace plumbline::study
