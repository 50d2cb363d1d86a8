// The list of known red rows: exact, no longer than it must be, and with limits that can be broken.
#include "tests/scenarios/families/rows.h"

#include "engine/core/math.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

namespace plumbline::study {
namespace {

constexpr KnownRed kOne[]{{"Some.Test", "A99 path S=1", 0.3, 0.3, "a reason"}};

double reached(const KnownRed& red) {
    const std::optional<double> at =
        sizeof(Real) == sizeof(float) ? red.reached_f32 : red.reached_f64;
    return at.value_or(std::nan(""));
}

TEST(KnownRedRows, AreNamedExactly) {
    EXPECT_EQ(row_fault("A99 path S=1", 0.25, 0.1, kOne), "");
    EXPECT_EQ(row_fault("A99 path S=16", 0.25, 0.1, kOne),
              "A99 path S=16: 0.25, asked at most 0.1");
    EXPECT_EQ(row_fault("A99 path", 0.25, 0.1, kOne), "A99 path: 0.25, asked at most 0.1");
}

TEST(KnownRedRows, FailWhenGreenWorseOrLoose) {
    EXPECT_EQ(row_fault("A99 path S=1", 0.05, 0.1, kOne),
              "A99 path S=1: 0.05, asked at most 0.1: no longer red, strike it off");
    EXPECT_EQ(row_fault("A99 path S=1", 0.31, 0.1, kOne),
              "A99 path S=1: 0.31, known to reach 0.3: it got worse; a reason");
    EXPECT_NE(row_fault("A99 path S=1", std::nan(""), 0.1, kOne), "");
    EXPECT_NE(row_fault("A99 other", std::nan(""), 0.1, kOne), "");
    EXPECT_EQ(row_fault("A99 path S=1", 0.19, 0.1, kOne),
              "A99 path S=1: 0.19, known to reach 0.3: write down what it reaches now");
}

TEST(KnownRedRows, AreOfOnePrecisionWhereTheOtherIsGreen) {
    const bool is_float = sizeof(Real) == sizeof(float);
    const KnownRed other{"Some.Test",
                         "A99 path S=1",
                         is_float ? std::nullopt : std::optional(0.3),
                         is_float ? std::optional(0.3) : std::nullopt,
                         "a reason"};
    EXPECT_EQ(row_fault("A99 path S=1", 0.05, 0.1, {&other, 1}), "");
    EXPECT_NE(row_fault("A99 path S=1", 0.25, 0.1, {&other, 1}), "");
}

/// Each row of the list, struck off by hand: its test would fail.
TEST(KnownRedRows, AreMissedWhenStruckOff) {
    const std::vector<KnownRed> all(known_red().begin(), known_red().end());
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (std::isnan(reached(all[i]))) continue;
        const double measured = reached(all[i]);
        const double asked = measured / 2;
        EXPECT_EQ(row_fault(all[i].row, measured, asked, all), "");
        std::vector<KnownRed> struck = all;
        struck.erase(struck.begin() + static_cast<std::ptrdiff_t>(i));
        EXPECT_EQ(row_fault(all[i].row, measured, asked, struck),
                  fmt::format("{}: {:.4g}, asked at most {:.4g}", all[i].row, measured, asked));
    }
}

TEST(KnownRedRows, HaveATestAReasonAndOneLineEach) {
    std::set<std::string> tests;
    const testing::UnitTest& program = *testing::UnitTest::GetInstance();
    for (int s = 0; s < program.total_test_suite_count(); ++s) {
        const testing::TestSuite& suite = *program.GetTestSuite(s);
        for (int t = 0; t < suite.total_test_count(); ++t)
            tests.insert(fmt::format("{}.{}", suite.name(), suite.GetTestInfo(t)->name()));
    }
    std::set<std::string_view> rows;
    for (const KnownRed& red : known_red()) {
        // The program of the other precision may have tests that this one lacks.
        const bool is_here = !std::isnan(reached(red));
        EXPECT_TRUE(!is_here || tests.contains(std::string(red.test))) << red.test;
        EXPECT_TRUE(rows.insert(red.row).second) << red.row << " stands twice";
        EXPECT_TRUE(red.reached_f32 || red.reached_f64) << red.row;
        EXPECT_FALSE(red.why.empty()) << red.row;
    }
}

}  // namespace
}  // namespace plumbline::study
