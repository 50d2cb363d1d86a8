// Observed orders of convergence and the verdict on each knob.
#pragma once

#include "engine/study/findings/findings.h"

#include <functional>
#include <span>

namespace plumbline::study {

/// The relative error that counts as rounding: some tens of roundings of one number, and in proportion
/// more above 120 sub-steps a second, each of which adds one.
double rounding_level(const Setting& setting);

/// Least order at which an error falls rather than stalls.
inline constexpr double kLeastOrder = 0.8;
/// An error that grows by more than this power of two a halving diverges.
inline constexpr double kDivergingOrder = -0.2;
inline constexpr int kLeastHalvings = 3;

struct ErrorAt {
    double fineness{0};  ///< step rate, sub-steps or iterations
    double error{0};     ///< magnitude
    double rounding{0};  ///< what is no more than this is rounding
};

struct Observed {
    Trend trend{Trend::TooFew};
    std::optional<double> order{};  ///< median of log2(e(2h)/e(h)) over halvings above rounding
    int halvings{0};
};
/// `series` by rising fineness, each twice the one before. What lies at rounding level ends it.
Observed observed_order(std::span<const ErrorAt> series);

/// The order that theory gives the first metric's error as a knob is turned; none where it has none.
using TheoryOf =
    std::function<std::optional<double>(const Setting& setting, std::string_view knob)>;

/// For every knob that some points of a subject differ in alone: step rate, sub-steps, iterations.
std::vector<Convergence> verdicts_of(std::span<const Point> points, const TheoryOf& theory);

}  // namespace plumbline::study
