// Ranges of numbers on the command line. CLI11's own let "nan" pass and print bounds of 300 digits.
#pragma once

#include <functional>
#include <string>

namespace plumbline::game {

/// For CLI::Option::check(): an empty text when the option's text is a number in the range, else
/// what was expected. Infinite and not-a-number are in none.
using RangeCheck = std::function<std::string(const std::string&)>;

/// The longest simulated time that any command takes.
inline constexpr double kLongestRun_s = 1e6;

RangeCheck between(double least, double most);
/// Beyond 0, up to `most`.
RangeCheck positive_up_to(double most);

}  // namespace plumbline::game
