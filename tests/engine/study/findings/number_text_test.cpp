#include "engine/study/findings/number_text.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::study {
namespace {

TEST(NumberText, NumbersHaveThreeDigits) {
    EXPECT_EQ(number_text(0), "0");
    EXPECT_EQ(number_text(0.35149), "0.351");
    EXPECT_EQ(number_text(12.449), "12.4");
    EXPECT_EQ(number_text(999.6), "1000");
    EXPECT_EQ(number_text(123456.7), "123457");
    EXPECT_EQ(number_text(-2.5e-7), "-2.5e-07");
    EXPECT_EQ(number_text(3e9), "3.0e+09");
    EXPECT_EQ(number_text(std::nan("")), "not a number");
    EXPECT_EQ(number_text(-HUGE_VAL), "infinite");
}

TEST(NumberText, ErrorsArePerCentUntilTheyAreTiny) {
    EXPECT_EQ(error_text(0.0123), "1.23 %");
    EXPECT_EQ(error_text(-0.5), "-50 %");
    EXPECT_EQ(error_text(3.1e-7), "3.1e-07");
    EXPECT_EQ(error_text(0), "0");
    EXPECT_EQ(error_text(std::nan("")), "not a number");
}

}  // namespace
}  // namespace plumbline::study
