#include "engine/study/findings/fidelity_price.h"

#include "engine/study/findings/pareto.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace plumbline::study {
namespace {

/// The same in all but effects, which run at the scene's own.
const Point* plain_of(std::span<const Point> points, Setting setting) {
    setting.fidelity.clear();
    const auto found = std::ranges::find(points, setting, &Point::setting);
    return found == points.end() ? nullptr : &*found;
}

}  // namespace

std::vector<FidelityPrice> prices_of(std::span<const Point> points, std::string_view effect) {
    std::array<std::optional<FidelityPrice>, 3> best;
    for (const Point& point : points) {
        if (point.setting.fidelity.size() != 1 || point.setting.fidelity.front().effect != effect)
            continue;
        const Point* plain = plain_of(points, point.setting);
        if (plain == nullptr) continue;
        const FidelityPrice price{.fidelity = point.setting.fidelity.front().fidelity,
                                  .more_ms = ms_per_frame(point) - ms_per_frame(*plain),
                                  .error = error_of(point),
                                  .error_before = error_of(*plain)};
        if (!std::isfinite(price.more_ms) || !std::isfinite(price.error + price.error_before))
            continue;
        std::optional<FidelityPrice>& place = best[static_cast<std::size_t>(price.fidelity)];
        if (!place || price.error_before < place->error_before) place = price;
    }
    std::vector<FidelityPrice> prices;
    for (const auto& price : best) {
        if (price) prices.push_back(*price);
    }
    return prices;
}

std::string price_text(std::span<const FidelityPrice> prices) {
    constexpr double kNotTold = 1e-5;
    std::string text;
    for (const FidelityPrice& price : prices) {
        const std::string errors =
            std::max(price.error_before, price.error) < kNotTold
                ? "error below 0.001 % with either"
                : fmt::format(
                      "error {:.2g} % to {:.2g} %", price.error_before * 100, price.error * 100);
        text += fmt::format("{}{}: {:+.3f} ms a frame, {}",
                            text.empty() ? "" : "\n",
                            word_of(price.fidelity),
                            price.more_ms,
                            errors);
    }
    return text;
}

}  // namespace plumbline::study
