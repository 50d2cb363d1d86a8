#include "tests/scenarios/families/rows.h"

#include "engine/core/math.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

namespace plumbline::physics {
namespace {

constexpr bool kFloat32 = sizeof(Real) == sizeof(float);

const KnownRed* find_red(std::string_view row) {
    const KnownRed* best = nullptr;
    for (const KnownRed& red : known_red()) {
        if (!row.starts_with(red.row)) continue;
        if (best == nullptr || red.row.size() > best->row.size()) best = &red;
    }
    return best;
}

void append(const std::string& line) {
    const char* file = std::getenv("PLUMBLINE_ROWS");
    if (file == nullptr) return;
    std::ofstream(file, std::ios::app) << line << '\n';
}

}  // namespace

void expect_at_most(const std::string& row, double measured, double asked) {
    const bool green = measured <= asked;
    append(fmt::format("{} | {} | {:.3g} | {:.3g} | {}",
                       kPrecisionName,
                       row,
                       asked,
                       measured,
                       green ? "green" : "red"));
    if (green) return;
    const KnownRed* red = find_red(row);
    if (red == nullptr) {
        ADD_FAILURE() << row << ": " << measured << ", asked at most " << asked;
        return;
    }
    const double reached = kFloat32 ? red->reached_f32 : red->reached_f64;
    EXPECT_LE(measured, reached) << row << " is known red and got worse; asked at most " << asked
                                 << "; " << red->why;
}

void note(const std::string& row, double measured) {
    append(fmt::format("{} | {} | - | {:.3g} | -", kPrecisionName, row, measured));
}

}  // namespace plumbline::physics
