// Rules of hard cases in units that suit their limits.
#include "engine/app/overlay/rule_text.h"

#include <gtest/gtest.h>

#include <limits>

namespace plumbline::app {
namespace {

using study::Allowed;

std::string text_of(const std::string& measure, Allowed allowed, double value) {
    return rule_text({.measure = measure, .allowed = allowed, .seen = true, .value = value});
}

TEST(RuleText, NumbersHaveTheUnitAndTheDigitsOfTheirLimit) {
    EXPECT_EQ(text_of("drift_m", {Allowed::Kind::Below, 0.01, 0}, 1.41e-8), "drift 0.00 of 10 mm");
    EXPECT_EQ(text_of("drift_m", {Allowed::Kind::Below, 0.01, 0}, 0.0123456),
              "drift 12.35 of 10 mm");
    EXPECT_EQ(text_of("sag_m", {Allowed::Kind::Below, 2.0, 0}, 0.5), "sag 0.500 of 2 m");
    EXPECT_EQ(text_of("speed_mps", {Allowed::Kind::Below, 0.005, 0}, -1e-9),
              "speed 0.0000 of 0.005 m/s");
    EXPECT_EQ(text_of("energy_gain", {Allowed::Kind::Below, 0.01, 0}, 0.0042),
              "energy gain 0.420 of 1 %");
    EXPECT_EQ(text_of("non_finite", {Allowed::Kind::Below, 0, 0}, 3), "non finite 3 of 0");
}

TEST(RuleText, TheKindOfLimitIsNamed) {
    EXPECT_EQ(text_of("x_m", {Allowed::Kind::Above, -70, 0}, -12.5), "x -12.50 m, at least -70 m");
    EXPECT_EQ(text_of("heading_deg", {Allowed::Kind::Near, 30, 0.5}, 29.75),
              "heading 29.75\u00b0, 30 \u00b1 0.5\u00b0");
}

TEST(RuleText, WhatIsFarOutsideHasNoPowers) {
    EXPECT_EQ(text_of("drift_m", {Allowed::Kind::Below, 0.01, 0}, 8.1e9),
              "drift over 10000 of 10 mm");
    EXPECT_EQ(
        text_of(
            "drift_m", {Allowed::Kind::Below, 0.01, 0}, std::numeric_limits<double>::quiet_NaN()),
        "drift not finite of 10 mm");
}

TEST(RuleText, BeforeItsTimeARuleSaysWhatIsAllowedAndFromWhen) {
    EXPECT_EQ(
        rule_text(
            {.measure = "speed_mps", .allowed = {Allowed::Kind::Below, 0.005, 0}, .from_s = 5}),
        "speed: at most 0.005 m/s, from 5 s");
}

}  // namespace
}  // namespace plumbline::app
