#include "engine/study/findings/order.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline::study {
namespace {

using physics::Solver;

struct Knob {
    std::string_view name;
    int Setting::*value;
};
constexpr Knob kOrderKnobs[]{{"step rate", &Setting::step_hz},
                             {"sub-steps", &Setting::substeps},
                             {"iterations", &Setting::iterations}};

/// The setting without the knob, as text: "x 4, float32" where the step rate is turned.
std::string held_text(const Setting& setting, const Knob& knob) {
    std::vector<std::string> words;
    if (knob.value != &Setting::step_hz) words.push_back(fmt::format("{} Hz", setting.step_hz));
    if (knob.value != &Setting::substeps) {
        words.push_back(setting.solver == Solver::SmallStep && setting.substeps <= 0
                            ? fmt::format("sub-steps on demand up to {}", setting.substeps_max)
                            : fmt::format("x {}", std::max(1, setting.substeps)));
    }
    if (knob.value != &Setting::iterations &&
        (setting.solver != Solver::SmallStep || setting.iterations != 1))
        words.push_back(fmt::format("{} it", setting.iterations));
    words.emplace_back(word_of(setting.precision));
    return fmt::format("{}", fmt::join(words, ", "));
}

bool same_but_for(Setting a, const Setting& b, const Knob& knob) {
    a.*knob.value = b.*knob.value;
    return a == b;
}

/// From the coarsest on, as long as each is twice the one before.
std::vector<ErrorAt> doublings(std::vector<ErrorAt> all) {
    std::ranges::sort(all, {}, &ErrorAt::fineness);
    std::vector<ErrorAt> series;
    for (const ErrorAt& each : all) {
        const bool follows =
            series.empty() || std::abs(each.fineness / series.back().fineness - 2) < 1e-9;
        if (follows) series.push_back(each);
    }
    return series;
}

}  // namespace

double rounding_level(const Setting& setting) {
    const double one = setting.precision == Precision::Float32 ? 5e-6 : 1e-11;
    return one * std::max(1.0, setting.step_hz * std::max(1, setting.substeps) / 120.0);
}

Observed observed_order(std::span<const ErrorAt> series) {
    const auto is_rounding = [](const ErrorAt& at) { return at.error <= at.rounding; };
    auto above =
        static_cast<std::size_t>(std::ranges::find_if(series, is_rounding) - series.begin());
    const bool reaches_rounding = above < series.size();
    // One at rounding level between others that are not has changed its sign there.
    const bool stays =
        std::all_of(series.begin() + static_cast<std::ptrdiff_t>(above), series.end(), is_rounding);
    if (!stays) above = series.size();

    std::vector<double> orders;
    for (std::size_t i = 1; i < above; ++i)
        orders.push_back(
            std::log2(series[i - 1].error / std::max(series[i].error, series[i].rounding)));
    Observed observed{.halvings = static_cast<int>(orders.size())};
    if (observed.halvings < kLeastHalvings) {
        const bool enough = static_cast<int>(series.size()) > kLeastHalvings;
        if (reaches_rounding && stays && enough) observed.trend = Trend::Exact;
        return observed;
    }
    std::ranges::sort(orders);
    const std::size_t middle = orders.size() / 2;
    observed.order =
        orders.size() % 2 == 1 ? orders[middle] : (orders[middle - 1] + orders[middle]) / 2;
    observed.trend = *observed.order >= kLeastOrder      ? Trend::Converges
                     : *observed.order < kDivergingOrder ? Trend::Diverges
                                                         : Trend::Stalls;
    return observed;
}

std::vector<Convergence> verdicts_of(std::span<const Point> points, const TheoryOf& theory) {
    std::vector<Convergence> verdicts;
    for (const Knob& knob : kOrderKnobs) {
        std::vector<const Point*> open;
        for (const Point& point : points) {
            // Sub-steps on demand are a rule, not a number.
            const bool counted = knob.value != &Setting::substeps || point.setting.substeps > 0;
            if (counted && point.status == RunStatus::Done && !point.errors.empty() &&
                std::isfinite(point.errors.front()))
                open.push_back(&point);
        }
        while (!open.empty()) {
            const Setting& like = open.front()->setting;
            std::vector<ErrorAt> all;
            for (const Point* point : open) {
                if (same_but_for(like, point->setting, knob))
                    all.push_back({.fineness = static_cast<double>(point->setting.*knob.value),
                                   .error = std::abs(point->errors.front()),
                                   .rounding = rounding_level(point->setting)});
            }
            const std::vector<ErrorAt> series = doublings(std::move(all));
            if (series.size() > 1) {
                const Observed observed = observed_order(series);
                verdicts.push_back({.knob = std::string(knob.name),
                                    .solver = like.solver,
                                    .held = held_text(like, knob),
                                    .trend = observed.trend,
                                    .order = observed.order,
                                    .theory = theory ? theory(like, knob.name) : std::nullopt,
                                    .halvings = observed.halvings});
            }
            const Setting done = like;
            std::erase_if(
                open, [&](const Point* point) { return same_but_for(done, point->setting, knob); });
        }
    }
    return verdicts;
}

}  // namespace plumbline::study
