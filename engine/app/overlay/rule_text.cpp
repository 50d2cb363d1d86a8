#include "engine/app/overlay/rule_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace plumbline::app {
namespace {

struct Unit {
    std::string_view suffix;  ///< of the measure's name
    std::string_view sign;
    double factor{1};
};
constexpr std::array kUnits{Unit{"_mps", " m/s"},
                            Unit{"_radps", " rad/s"},
                            Unit{"_deg", "\u00b0"},
                            Unit{"_Ns", " N s"},
                            Unit{"_N", " N"},
                            Unit{"_J", " J"},
                            Unit{"_m", " m"}};
// Shares of what there was at the start.
constexpr std::array<std::string_view, 6> kShares{"energy_gain",
                                                  "energy_loss",
                                                  "braked_share",
                                                  "speed_change",
                                                  "momentum_change",
                                                  "angular_momentum_change"};

/// The largest number that the rule speaks of, in the measure's own unit.
double scale_of(const study::Allowed& allowed) {
    return std::max(std::abs(allowed.limit), allowed.within);
}

Unit unit_of(const study::RuleState& rule) {
    if (std::ranges::find(kShares, rule.measure) != kShares.end()) return {"", " %", 100};
    for (const Unit& unit : kUnits) {
        if (!rule.measure.ends_with(unit.suffix)) continue;
        if (unit.sign == " m" && scale_of(rule.allowed) < 1) return {unit.suffix, " mm", 1000};
        return unit;
    }
    return {};
}

/// "energy gain" of "energy_gain", "drift" of "drift_m".
std::string name_of(const study::RuleState& rule, const Unit& unit) {
    std::string name = rule.measure.substr(0, rule.measure.size() - unit.suffix.size());
    std::ranges::replace(name, '_', ' ');
    return name;
}

/// As many digits as the limit has a use for; never a power of ten.
std::string number(double value, double scale) {
    constexpr double kFarOutside = 1000;
    if (!std::isfinite(value)) return "not finite";
    const double most = std::max(1.0, scale) * kFarOutside;
    if (std::abs(value) > most) return fmt::format("{}{:g}", value < 0 ? "under -" : "over ", most);
    if (scale == 0 && value == std::round(value)) return fmt::format("{:.0f}", value);
    const int digits = scale > 0 ? 3 - static_cast<int>(std::floor(std::log10(scale))) : 2;
    const std::string text = fmt::format("{:.{}f}", value, std::clamp(digits, 0, 4));
    return text.find_first_not_of("-0.") == std::string::npos ? text.substr(text[0] == '-') : text;
}

std::string allowed_text(const study::Allowed& allowed, const Unit& unit) {
    const double limit = allowed.limit * unit.factor;
    switch (allowed.kind) {
        case study::Allowed::Kind::Below:
            return fmt::format("at most {:g}{}", limit, unit.sign);
        case study::Allowed::Kind::Above:
            return fmt::format("at least {:g}{}", limit, unit.sign);
        case study::Allowed::Kind::Near:
            break;
    }
    return fmt::format("{:g} \u00b1 {:g}{}", limit, allowed.within * unit.factor, unit.sign);
}

}  // namespace

std::string rule_text(const study::RuleState& rule) {
    const Unit unit = unit_of(rule);
    const std::string name = name_of(rule, unit);
    const std::string allowed = allowed_text(rule.allowed, unit);
    if (!rule.seen) return fmt::format("{}: {}, from {:g} s", name, allowed, rule.from_s);
    const std::string value =
        number(rule.value * unit.factor, scale_of(rule.allowed) * unit.factor);
    if (rule.allowed.kind == study::Allowed::Kind::Below)
        return fmt::format(
            "{} {} of {:g}{}", name, value, rule.allowed.limit * unit.factor, unit.sign);
    return fmt::format("{} {}{}, {}", name, value, unit.sign, allowed);
}

}  // namespace plumbline::app
