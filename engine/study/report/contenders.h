// The runs of a subject by who made them: a solver in a precision.
#pragma once

#include "engine/study/findings/findings.h"
#include "engine/study/findings/pareto.h"

#include <string>
#include <vector>

namespace plumbline::study {

/// The metric of the diagrams.
inline constexpr std::size_t kFirstMetric = 0;

struct Contender {
    std::string name;
    std::vector<Point> points;
};

/// In the order of their first points.
std::vector<Contender> contenders_of(const Subject& subject);

/// Its cheapest point within a tolerance; null where none is.
const Point* cheapest_at(const Contender& contender, double tolerance, std::size_t metric);
/// Its most accurate point within a budget in ms a frame; null where none is.
const Point* best_for(const Contender& contender, double budget_ms, std::size_t metric);
/// The index of who reaches a tolerance at the least cost; nobody: their number.
std::size_t winner_at(const std::vector<Contender>& contenders,
                      double tolerance,
                      std::size_t metric);

}  // namespace plumbline::study
