#include "engine/app/overlay/plaque_text.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace plumbline::app {
namespace {

constexpr double kGoodError = 0.01;

std::string_view unit_of(scene::PlaqueQuantity quantity) {
    constexpr std::array<std::string_view, 6> kUnits{"s", "m", "m/s", "m", "deg", "deg/s"};
    return kUnits[static_cast<std::size_t>(quantity)];
}

}  // namespace

std::vector<ui::HudLine> plaque_lines(const scene::PlaqueReading& reading, double cost_ms) {
    const scene::PlaqueDescription& says = reading.says;
    const std::string_view unit = unit_of(says.quantity);
    std::vector<ui::HudLine> lines{{.text = says.title, .tone = ui::Tone::Head}};
    if (!says.formula.empty()) lines.push_back({.text = says.formula});
    lines.push_back({.text = fmt::format("expected {:.4g} {}", says.expected, unit)});
    if (!reading.measured) {
        lines.push_back({.text = "not measured yet", .tone = ui::Tone::Faint});
    } else {
        const std::string of = reading.periods > 1
                                   ? fmt::format(", mean of {} periods", reading.periods)
                                   : std::string();
        lines.push_back({.text = fmt::format("measured {:.4g} {}{}", *reading.measured, unit, of)});
        const double error = *reading.measured - says.expected;
        const double share = says.expected != 0 ? error / std::abs(says.expected) : error;
        lines.push_back({.text = says.expected != 0 ? fmt::format("error {:+.3f} %", 100 * share)
                                                    : fmt::format("error {:+.3g} {}", error, unit),
                         .tone = std::abs(share) <= kGoodError ? ui::Tone::Good : ui::Tone::Bad});
    }
    lines.push_back({.text = fmt::format("cost of {}: {:.3f} ms a step",
                                         says.effect.empty() ? "all rigid bodies" : says.effect,
                                         cost_ms)});
    return lines;
}

}  // namespace plumbline::app
