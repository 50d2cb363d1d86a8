#include "engine/study/findings/difference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace plumbline::study {
namespace {

TEST(PairedDifference, WhatDriftsSlowlyFallsOut) {
    // The clock gets slower all the time; the difference is 2 in every pair.
    const std::vector<double> without{10, 20, 40, 80};
    const std::vector<double> with{12, 22, 42, 82};
    const Difference found = paired_difference(with, without);
    EXPECT_DOUBLE_EQ(found.mean, 2);
    EXPECT_DOUBLE_EQ(found.standard_error, 0);
    EXPECT_EQ(found.pairs, 4);
    EXPECT_TRUE(found.is_significant());
}

TEST(PairedDifference, HasTheStandardErrorOfItsMean) {
    // Differences 1, 3 and 5: a standard deviation of 2, over the root of 3.
    const Difference found =
        paired_difference(std::vector<double>{1, 3, 5}, std::vector<double>{0, 0, 0, 99});
    EXPECT_EQ(found.pairs, 3) << "what has no partner does not count";
    EXPECT_DOUBLE_EQ(found.mean, 3);
    EXPECT_NEAR(found.standard_error, 2 / std::sqrt(3.0), 1e-15);
    EXPECT_TRUE(found.is_significant());
    const Difference less{.mean = -1, .standard_error = 0.51, .pairs = 9};
    EXPECT_FALSE(less.is_significant());
    EXPECT_TRUE((Difference{.mean = -1, .standard_error = 0.49, .pairs = 9}).is_significant());
}

TEST(PairedDifference, OnePairTellsNothing) {
    const Difference one = paired_difference(std::vector<double>{7}, std::vector<double>{3});
    EXPECT_DOUBLE_EQ(one.mean, 4);
    EXPECT_FALSE(one.is_significant());
    EXPECT_EQ(paired_difference({}, std::vector<double>{3}).pairs, 0);
}

}  // namespace
}  // namespace plumbline::study
