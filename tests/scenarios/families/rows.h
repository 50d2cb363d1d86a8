// Rows of the accuracy families and hard cases: what was asked for, and what was measured.
//
// Where the solver is known not to reach what is asked, known_red.cpp says how far it gets, and a
// test holds it to that: it cannot get worse unseen. With PLUMBLINE_ROWS=FILE every check appends a
// line "row | asked | measured | green or red" to FILE, which is how tables of them are made.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace plumbline::physics {

/// A row that is not reached. `row` is a prefix: it stands for all rows that begin with it; the
/// longest that fits counts.
struct KnownRed {
    std::string_view row;
    double reached_f32;
    double reached_f64;
    std::string_view why;
};
std::span<const KnownRed> known_red();

/// Fails where `measured` is above what is asked, or above what a known red row reaches; NaN fails.
void expect_at_most(const std::string& row, double measured, double asked);

/// Notes a number that nothing is asked of.
void note(const std::string& row, double measured);

}  // namespace plumbline::physics
