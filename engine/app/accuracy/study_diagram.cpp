#include "engine/app/accuracy/study_diagram.h"

#include "engine/study/findings/pareto.h"

#include <algorithm>
#include <cmath>

namespace plumbline::app {
namespace {

constexpr double kLeastError = 1e-6;
constexpr double kMostError = 10.0;

LogAxis axis_over(double least, double most) {
    const auto floor_of = [](double value) {
        return static_cast<int>(std::floor(std::log10(value)));
    };
    LogAxis axis{.least_decade = floor_of(least), .most_decade = floor_of(most) + 1};
    if (axis.most_decade - axis.least_decade < 2) axis.least_decade = axis.most_decade - 2;
    return axis;
}

}  // namespace

float LogAxis::place_of(double value) const {
    if (!(value > 0)) return 0;
    const double decades = most_decade - least_decade;
    return static_cast<float>(std::clamp((std::log10(value) - least_decade) / decades, 0.0, 1.0));
}

StudyDiagram diagram_of(std::span<const study::Point> points) {
    StudyDiagram diagram;
    double least_ms = INFINITY;
    double most_ms = 0;
    double least_error = 0.01;
    double most_error = 0.01;
    const auto drawn = [](const study::Point& point) {
        return std::isfinite(study::error_of(point)) && std::isfinite(study::ms_per_frame(point)) &&
               study::ms_per_frame(point) > 0;
    };
    for (const study::Point& point : points) {
        if (!drawn(point)) continue;
        const double ms = study::ms_per_frame(point);
        const double error = std::clamp(study::error_of(point), kLeastError, kMostError);
        least_ms = std::min(least_ms, ms);
        most_ms = std::max(most_ms, ms);
        least_error = std::min(least_error, error);
        most_error = std::max(most_error, error);
    }
    if (most_ms <= 0) return diagram;
    diagram.ms = axis_over(least_ms, most_ms);
    diagram.error = axis_over(least_error, most_error);
    const auto place_of = [&](const study::Point& point) {
        return Vec2f{diagram.ms.place_of(study::ms_per_frame(point)),
                     diagram.error.place_of(study::error_of(point))};
    };
    for (std::size_t i = 0; i < points.size(); ++i)
        if (drawn(points[i])) diagram.points.push_back({i, place_of(points[i])});
    for (const std::size_t i : study::pareto_front(points))
        if (drawn(points[i])) diagram.front.push_back(place_of(points[i]));
    return diagram;
}

std::optional<std::size_t> point_at(const StudyDiagram& diagram,
                                    const Vec2f& place,
                                    const Vec2f& size_px,
                                    float reach_px) {
    std::optional<std::size_t> nearest;
    for (const DiagramPoint& point : diagram.points) {
        const float away_px = glm::length((point.place - place) * size_px);
        if (away_px > reach_px) continue;
        reach_px = away_px;
        nearest = point.of;
    }
    return nearest;
}

}  // namespace plumbline::app
