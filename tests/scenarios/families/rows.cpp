#include "tests/scenarios/families/rows.h"

#include "engine/core/math.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <set>

namespace plumbline::study {
namespace {

constexpr bool kFloat32 = sizeof(Real) == sizeof(float);

std::optional<double> reached_by(const KnownRed& red) {
    return kFloat32 ? red.reached_f32 : red.reached_f64;
}

void append(const std::string& line) {
    const char* file = std::getenv("PLUMBLINE_ROWS");
    if (file == nullptr) return;
    std::ofstream(file, std::ios::app) << line << '\n';
}

/// Names that expect_at_most() got in the test that runs.
std::set<std::string, std::less<>>& asked_rows() {
    static std::set<std::string, std::less<>> rows;
    return rows;
}

/// A known red row that its test does not ask for is misspelt, or long gone.
class AsksForItsReds : public testing::EmptyTestEventListener {
    void OnTestStart(const testing::TestInfo&) override { asked_rows().clear(); }
    void OnTestEnd(const testing::TestInfo& test) override {
        const std::string name = fmt::format("{}.{}", test.test_suite_name(), test.name());
        for (const KnownRed& red : known_red()) {
            if (red.test == name && !asked_rows().contains(red.row))
                ADD_FAILURE() << "known red, and not asked for: " << red.row;
        }
    }
};

// GoogleTest owns it.
[[maybe_unused]] const bool kListens = [] {
    testing::UnitTest::GetInstance()->listeners().Append(new AsksForItsReds);
    return true;
}();

}  // namespace

std::string row_fault(std::string_view row,
                      double measured,
                      double asked,
                      std::span<const KnownRed> reds) {
    const auto red = std::ranges::find_if(
        reds, [&](const KnownRed& each) { return each.row == row && reached_by(each); });
    const bool green = measured <= asked;
    if (red == reds.end())
        return green ? "" : fmt::format("{}: {:.4g}, asked at most {:.4g}", row, measured, asked);
    const double reached = *reached_by(*red);
    if (green)
        return fmt::format(
            "{}: {:.4g}, asked at most {:.4g}: no longer red, strike it off", row, measured, asked);
    if (!(measured <= reached))
        return fmt::format("{}: {:.4g}, known to reach {:.4g}: it got worse; {}",
                           row,
                           measured,
                           reached,
                           red->why);
    if (reached > kRedRoom * measured)
        return fmt::format("{}: {:.4g}, known to reach {:.4g}: write down what it reaches now",
                           row,
                           measured,
                           reached);
    return "";
}

void expect_at_most(const std::string& row, double measured, double asked) {
    asked_rows().insert(row);
    append(fmt::format("{} | {} | {:.3g} | {:.3g} | {}",
                       kPrecisionName,
                       row,
                       asked,
                       measured,
                       measured <= asked ? "green" : "red"));
    const std::string fault = row_fault(row, measured, asked, known_red());
    if (!fault.empty()) ADD_FAILURE() << fault;
}

void note(const std::string& row, double measured) {
    append(fmt::format("{} | {} | - | {:.3g} | -", kPrecisionName, row, measured));
}

}  // namespace plumbline::study
