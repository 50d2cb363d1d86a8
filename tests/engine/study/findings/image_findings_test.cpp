#include "engine/study/findings/image_findings.h"

#include <gtest/gtest.h>

namespace plumbline::study {
namespace {

ImageRow row(const std::string& name, double rms, double ms, double more_ms) {
    return {.name = name,
            .error = {.mean = 0.5 * rms, .rms = rms},
            .cpu_ms = ms,
            .more_ms = {.mean = more_ms, .standard_error = 0.1, .pairs = 4}};
}

ImageFindings judged() {
    ImageFindings findings{.scene = "yard.toml",
                           .width_px = 640,
                           .height_px = 360,
                           .samples_per_pixel = 16,
                           .mean_luminance = 0.25,
                           .rows = {row("level high", 0.10, 50, 0.0),
                                    row("cheap", 0.20, 20, -30.0),
                                    row("dear and worse", 0.15, 60, 10.0),
                                    row("nearer", 0.05, 90, 40.0),
                                    row("the same", 0.101, 50, 0.15)}};
    judge(findings);
    return findings;
}

TEST(ImageFindings, SayWhatIsGainedAndWhatItCosts) {
    const std::vector<ImageRow> rows = judged().rows;
    EXPECT_EQ(rows[0].verdict, "what the others are compared to");
    EXPECT_EQ(rows[1].verdict, "100 % more error, saves 30.0 ms");
    EXPECT_EQ(rows[2].verdict, "50 % more error, costs 10.0 ms more");
    EXPECT_EQ(rows[3].verdict, "50 % less error, costs 40.0 ms more");
    EXPECT_EQ(rows[4].verdict, "as near to the reference, no cost that could be told");
}

TEST(ImageFindings, AreUnbeatenWhereNothingIsCheaperAndNearer) {
    std::vector<bool> unbeaten;
    for (const ImageRow& each : judged().rows) unbeaten.push_back(each.unbeaten);
    EXPECT_EQ(unbeaten, (std::vector{true, true, false, true, false}));
}

TEST(ImageFindings, OfEqualsNoneIsBeaten) {
    ImageFindings findings{.rows = {row("a", 0.1, 5, 0), row("b", 0.1, 5, 0)}};
    judge(findings);
    EXPECT_TRUE(findings.rows[0].unbeaten && findings.rows[1].unbeaten);
}

TEST(ImageFindings, AreATableForPeople) {
    const std::string text = image_text(judged());
    EXPECT_NE(text.find("* cheap"), std::string::npos);
    EXPECT_NE(text.find("  dear and worse"), std::string::npos);
    EXPECT_NE(text.find("640 x 360 pixels against 16 samples"), std::string::npos);
    EXPECT_NE(text.find("20 %"), std::string::npos);
}

}  // namespace
}  // namespace plumbline::study
