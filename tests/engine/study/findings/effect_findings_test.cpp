#include "engine/study/findings/effect_findings.h"

#include <gtest/gtest.h>

namespace plumbline::study {
namespace {

TEST(EffectFindings, ACostBelowTheNoiseIsSaidToBeSo) {
    const EffectFindings findings{
        .scene = "yard.toml",
        .seconds = 2,
        .pairs = 6,
        .width_px = 640,
        .height_px = 360,
        .rows = {{.name = "wind",
                  .caller = "[wind] (a.toml:3)",
                  .domain = "step",
                  .step_ms = {.mean = 0.5, .standard_error = 0.1, .pairs = 6},
                  .frame_ms = {.mean = -0.001, .standard_error = 0.01, .pairs = 6},
                  .calls = 120},
                 {.name = "footsteps", .domain = "sound"}}};
    const std::string text = effects_text(findings);
    EXPECT_NE(text.find("2 s of the scene with and without it, 6 times"), std::string::npos);
    EXPECT_NE(text.find(" +0.5000 +- 0.1000 "), std::string::npos) << text;
    EXPECT_NE(text.find(" below the noise (+- 0.0100) "), std::string::npos) << text;
    EXPECT_NE(text.find("footsteps             sound                             -"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("Images are 640 x 360"), std::string::npos) << text;
    EXPECT_EQ(text.find("No effect was measured"), std::string::npos);
    EXPECT_TRUE(effects_text({}).ends_with("No effect was measured.\n"));
}

}  // namespace
}  // namespace plumbline::study
