#include "engine/study/report/diagrams/diagrams.h"

#include "engine/study/findings/pareto.h"
#include "engine/study/report/html_text.h"
#include "engine/study/report/knob_lines.h"
#include "engine/study/report/setting_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace plumbline::study {

namespace {

/// Errors above are drawn at the top: what is ten thousand per cent off is just wrong.
constexpr double kMostError = 100;

constexpr std::string_view kPeerColor = "#9a9a9a";
constexpr std::string_view kInk = "#000000";
constexpr std::string_view kWrong = "#d03030";

std::string_view color_of(physics::Solver solver) {
    switch (solver) {
        case physics::Solver::SmallStep:
            return "#2f7fd6";
        case physics::Solver::BulletSi:
            return "#d9762b";
        case physics::Solver::BulletNncg:
            return "#2f9e6e";
        case physics::Solver::BulletDantzig:
            return "#a364cf";
        case physics::Solver::BulletPgs:
            return "#b08a2a";
    }
    return kInk;
}

/// gnuplot's filled symbols, the open one of each one less: square, disc, triangles, diamond, pentagon.
constexpr std::array<int, 6> kFilled{7, 5, 9, 13, 11, 15};

std::optional<double> first_error(const Point& point) {
    if (point.status != RunStatus::Done || point.errors.empty()) return std::nullopt;
    return drawn_error(point.errors.front(), point.setting.precision);
}

bool has_cost(const Point& point) {
    return std::isfinite(point.cost.ms_per_s_min) && point.cost.ms_per_s_min > 0;
}

struct Extent {
    double least{HUGE_VAL};
    double most{0};
    void add(double value) {
        least = std::min(least, value);
        most = std::max(most, value);
    }
    bool empty() const { return most <= 0; }
};

std::string plain_tick(double value) {
    return number_text(value);
}

std::string error_tick(double value) {
    if (value < 0.9e-5) return fmt::format("{:.0e}", value);
    return error_text(value);
}

Axis error_axis(const Subject& subject, Extent errors) {
    errors.least = std::min(errors.least, 0.001);
    errors.most = std::clamp(errors.most, 0.1, kMostError);
    const std::string name =
        subject.metrics.empty() ? "error" : fmt::format("error: {}", subject.metrics.front().name);
    Axis axis = log_axis(name, errors.least, errors.most, 100, error_tick);
    axis.guides = {{0.05, "5 %"}, {0.01, "1 %"}, {0.001, "0.1 %"}};
    return axis;
}

double clamped(double error) {
    return std::min(error, kMostError);
}

void add_peers(Plot& plot, std::span<const PeerPoint> peers) {
    std::map<std::string, Curve> engines;
    for (const PeerPoint& peer : peers) {
        const auto error = drawn_error(peer.error, Precision::Float32);
        if (!error || !(peer.cpu_ms_per_s > 0)) continue;
        Curve& curve = engines[peer.engine];
        curve.color = kPeerColor;
        curve.symbol = static_cast<int>(Symbol::Dot);
        curve.symbol_size = 0.45;
        curve.width = 0.7;
        curve.points.push_back({peer.cpu_ms_per_s,
                                clamped(*error),
                                curve.points.empty() ? peer.engine : std::string()});
    }
    bool is_first = true;
    for (auto& [engine, curve] : engines) {
        if (is_first) curve.name = "other engines (peers)";
        is_first = false;
        plot.curves.push_back(std::move(curve));
    }
}

/// Symbols without a line.
Curve marks(std::string name, std::string_view color, Symbol symbol, double size, double width) {
    Curve curve;
    curve.name = std::move(name);
    curve.color = color;
    curve.dash = Dash::None;
    curve.symbol = static_cast<int>(symbol);
    curve.symbol_size = size;
    curve.width = width;
    return curve;
}

void add_rings(Plot& plot, const Subject& subject) {
    Curve rings = marks("cheapest for its error", kInk, Symbol::Ring, 1.3, 1);
    for (const std::size_t i : pareto_front(subject.points, 0)) {
        const Point& point = subject.points[i];
        const auto error = first_error(point);
        if (error && has_cost(point)) {
            rings.points.push_back(
                {point.cost.ms_per_s_min, clamped(*error), short_setting(point.setting)});
        }
    }
    if (!rings.points.empty()) plot.curves.push_back(std::move(rings));
}

/// Runs that cost something and failed, along the top.
void add_failures(Plot& plot, const Subject& subject) {
    Curve crosses = marks("failed", kWrong, Symbol::Cross, 0.9, 1.8);
    for (const Point& point : subject.points) {
        if (!first_error(point) && has_cost(point)) {
            crosses.points.push_back({point.cost.ms_per_s_min, plot.y.most * 0.999, {}});
        }
    }
    if (!crosses.points.empty()) plot.curves.push_back(std::move(crosses));
}

void add_lines(Plot& plot,
               const Subject& subject,
               double (*x_of)(const Point&),
               bool (*is_drawn)(const Point&)) {
    std::map<physics::Solver, std::size_t> symbols;
    for (const KnobLine& line : knob_lines(subject.points)) {
        const Setting& first = line.points.front()->setting;
        const bool is_double = first.precision == Precision::Float64;
        const std::size_t rank = symbols[first.solver]++;
        Curve curve;
        curve.name = line.name;
        curve.color = color_of(first.solver);
        curve.dash = !line.is_of_rate ? Dash::Dotted : is_double ? Dash::Dashed : Dash::Solid;
        curve.symbol = kFilled[rank % kFilled.size()] - (is_double ? 1 : 0);
        for (const Point* point : line.points) {
            const auto error = first_error(*point);
            if (error && is_drawn(*point)) {
                curve.points.push_back({x_of(*point), clamped(*error), {}});
            }
        }
        if (!curve.points.empty()) plot.curves.push_back(std::move(curve));
    }
}

double cost_of(const Point& point) {
    return point.cost.ms_per_s_min;
}

/// The step that the solver takes, in ms; of sub-steps on demand the longest.
double step_ms_of(const Point& point) {
    return 1000.0 / point.setting.step_hz / world_def(point.setting).substeps;
}

bool has_step(const Point& point) {
    return point.setting.step_hz > 0;
}

/// Straight lines of the first and second order through the largest error at the largest step.
void add_slopes(Plot& plot, double step_ms, double error) {
    for (const int order : {1, 2}) {
        Curve slope;
        slope.name = fmt::format("slope of order {}", order);
        slope.color = kPeerColor;
        slope.dash = order == 1 ? Dash::Dashed : Dash::Dotted;
        slope.width = 1;
        for (int i = 0; i <= 60; ++i) {
            const double at = plot.x.least * std::pow(plot.x.most / plot.x.least, i / 60.0);
            slope.points.push_back({at, error * std::pow(at / step_ms, order), {}});
        }
        plot.curves.push_back(std::move(slope));
    }
}

}  // namespace

std::optional<double> drawn_error(double error, Precision precision) {
    if (!std::isfinite(error)) return std::nullopt;
    return std::max(std::abs(error), precision == Precision::Float64 ? 2.2e-16 : 1.2e-7);
}

std::optional<Plot> work_precision_plot(const Subject& subject, std::span<const PeerPoint> peers) {
    Extent costs;
    Extent errors;
    for (const Point& point : subject.points) {
        const auto error = first_error(point);
        if (has_cost(point)) costs.add(point.cost.ms_per_s_min);
        if (error && has_cost(point)) errors.add(*error);
    }
    if (costs.empty() || errors.empty()) return std::nullopt;
    for (const PeerPoint& peer : peers) {
        const auto error = drawn_error(peer.error, Precision::Float32);
        if (error && peer.cpu_ms_per_s > 0) {
            costs.add(peer.cpu_ms_per_s);
            errors.add(*error);
        }
    }
    Plot plot;
    plot.name = fmt::format("Error against cost: {}", subject.title);
    plot.x =
        log_axis("CPU milliseconds per simulated second", costs.least, costs.most, 10, plain_tick);
    for (const double ms_per_frame : {0.1, 0.5, 2.0}) {
        plot.x.guides.push_back(
            {ms_per_frame * kFrames_per_s, fmt::format("{:g} ms a frame", ms_per_frame)});
    }
    plot.y = error_axis(subject, errors);
    add_peers(plot, peers);
    add_lines(plot, subject, cost_of, has_cost);
    add_rings(plot, subject);
    add_failures(plot, subject);
    return plot;
}

std::optional<Plot> step_plot(const Subject& subject) {
    Extent steps;
    Extent errors;
    double error_at_largest = 0;
    for (const Point& point : subject.points) {
        const auto error = first_error(point);
        if (!error || !has_step(point)) continue;
        const double step_ms = step_ms_of(point);
        if (step_ms > steps.most) error_at_largest = 0;
        if (step_ms >= steps.most) error_at_largest = std::max(error_at_largest, clamped(*error));
        steps.add(step_ms);
        errors.add(*error);
    }
    if (steps.empty() || steps.most < 1.01 * steps.least) return std::nullopt;
    const double largest_step_ms = steps.most;
    Curve floor;
    floor.name = "Euler floor";
    floor.color = kInk;
    floor.dash = Dash::Dashed;
    floor.width = 1.6;
    for (const FloorPoint& point : subject.euler_floor) {
        const auto error = drawn_error(point.error, Precision::Float64);
        if (!error || !(point.step_s > 0)) continue;
        floor.points.push_back({point.step_s * 1000, clamped(*error), {}});
        errors.add(*error);
    }
    std::ranges::sort(floor.points, {}, &PlotPoint::x);
    Plot plot;
    plot.name = fmt::format("Error against step: {}", subject.title);
    plot.x = log_axis(
        "step that the solver takes, in milliseconds", steps.least, steps.most, 4, plain_tick);
    plot.y = error_axis(subject, errors);
    add_slopes(plot, largest_step_ms, std::min(error_at_largest, 1.0));
    add_lines(plot, subject, step_ms_of, has_step);
    if (!floor.points.empty()) plot.curves.push_back(std::move(floor));
    return plot;
}

}  // namespace plumbline::study
