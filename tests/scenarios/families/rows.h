// Rows of the accuracy families and hard cases: what was asked for, and what was measured.
//
// Where the solver is known not to reach what is asked, known_red_accuracy.cpp and
// known_red_hard_cases.cpp say how far it gets, and a test holds it to that: it cannot get worse
// unseen, nor better. With PLUMBLINE_ROWS=FILE every check appends a line
// "row | asked | measured | green or red" to FILE, which is how tables of them are made.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace plumbline::study {

/// A row that is not reached.
struct KnownRed {
    std::string_view test;  ///< "Sliding.A29ABoxBelowTheLimitStays": which asks for it
    std::string_view row;   ///< its whole name, setting included
    /// Most that may be measured, by precision; none: that precision reaches what is asked.
    std::optional<double> reached_f32;
    std::optional<double> reached_f64;
    std::string_view why;
};
/// Those of this test program.
std::span<const KnownRed> known_red();

/// How much more than is measured a known red row may accept, as a factor.
inline constexpr double kRedRoom = 1.5;

/// What is wrong with a measured row, or empty. Wrong are: red and not listed (NaN is red), listed
/// and green, worse than listed, listed with a limit that is more than kRedRoom times what is
/// measured.
std::string row_fault(std::string_view row,
                      double measured,
                      double asked,
                      std::span<const KnownRed> reds);

/// Fails where row_fault() finds one. At the end of each test those of its known red rows fail that
/// it did not ask for.
void expect_at_most(const std::string& row, double measured, double asked);

/// Notes a number that nothing is asked of.
void note(const std::string& row, double measured);

}  // namespace plumbline::study
