#include "game/command_line/option_ranges.h"

#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <string_view>

namespace plumbline::game {
namespace {

/// With a point, whatever the locale.
std::optional<double> number_in(std::string_view text) {
    if (text.starts_with('+')) text.remove_prefix(1);
    double number = 0.0;
    const char* end = text.data() + text.size();
    const auto [stop, fault] = std::from_chars(text.data(), end, number);
    if (fault != std::errc{} || stop != end) return {};
    return number;
}

}  // namespace

RangeCheck between(double least, double most) {
    return [=](const std::string& text) -> std::string {
        const std::optional<double> number = number_in(text);
        if (number && *number >= least && *number <= most) return {};
        return fmt::format("{}: expected a number from {} to {}", text, least, most);
    };
}

RangeCheck positive_up_to(double most) {
    return [=](const std::string& text) -> std::string {
        const std::optional<double> number = number_in(text);
        if (number && *number > 0.0 && *number <= most) return {};
        return fmt::format("{}: expected a number above 0, up to {}", text, most);
    };
}

}  // namespace plumbline::game
