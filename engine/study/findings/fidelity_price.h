// What another fidelity of one effect costs and buys, by points of a study that differ in nothing else.
#pragma once

#include "engine/study/findings/findings.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::study {

struct FidelityPrice {
    scene::Fidelity fidelity{scene::Fidelity::Balanced};
    double more_ms{0};  ///< CPU for 1/60 s of simulated time; negative: it gives some back
    double error{0};    ///< relative, of the metric that is furthest off
    double error_before{0};
};

/// At most one for each fidelity other than the scene's own; of several pairs of points the one whose setting errs least.
std::vector<FidelityPrice> prices_of(std::span<const Point> points, std::string_view effect);

/// "precise: +0.12 ms a frame, error 0.8 % to 0.5 %"; lines in the order given.
std::string price_text(std::span<const FidelityPrice> prices);

}  // namespace plumbline::study
