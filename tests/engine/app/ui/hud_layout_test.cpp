#include "engine/app/ui/hud_layout.h"

#include "engine/app/ui/ui_scale.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

namespace plumbline::app::ui {
namespace {

TextSize plain_text(float font_px) {
    return {.width_px =
                [=](const std::string& words) {
                    return 0.55F * font_px * static_cast<float>(words.size());
                },
            .height_px =
                [=](const std::string& words, float wrap_px) {
                    const float width = 0.55F * font_px * static_cast<float>(words.size());
                    return 1.2F * font_px * std::ceil(width / std::max(1.0F, wrap_px));
                }};
}

TEST(FontSize, FollowsTheWindowTheMonitorAndTheSetting) {
    EXPECT_EQ(font_size_px(1280, 720, 1, 0), 17);
    EXPECT_EQ(font_size_px(640, 360, 1, 0), 10);
    EXPECT_EQ(font_size_px(3840, 2160, 1, 0), 38);
    EXPECT_EQ(font_size_px(1280, 720, 1.25F, 0), 21);  // EXPERIENCE A14
    EXPECT_EQ(font_size_px(1280, 720, 1, 0.75F), 12);
    EXPECT_EQ(font_size_px(1920, 1080, 1, 2), 33);  // as large as a page of 58 letters allows
    EXPECT_EQ(font_size_px(3840, 2160, 1, 3), 51);
    EXPECT_EQ(font_size_px(640, 360, 1, 3), 11);  // never so large that a page does not fit
    EXPECT_EQ(font_size_px(100, 100, 1, 1), 8);
    EXPECT_EQ(font_size_px(0, 0, 1, 0), 8);
}

TEST(HudLayoutOf, CaptionsAreNeverSmallerThanCanBeRead) {
    for (const auto& [width, height] : {std::pair{640.0F, 360.0F}, std::pair{1280.0F, 720.0F}}) {
        const float font_px = font_size_px(width, height, 1, 0);
        const HudLayout layout =
            layout_of({.captions = {{.text = "wood"}}, .hint = {{.text = "walk"}}},
                      width,
                      height,
                      font_px,
                      0.0F,
                      plain_text(font_px));
        EXPECT_FLOAT_EQ(layout.captions.scale * font_px, std::max(font_px, 14.0F));
        EXPECT_FLOAT_EQ(layout.captions.texts.front().box.height, 1.2F * std::max(font_px, 14.0F));
        EXPECT_EQ(layout.hint.scale, 1.0F);
    }
}

class HudAtSize : public testing::TestWithParam<std::pair<int, int>> {};

TEST_P(HudAtSize, NothingLeavesTheWindowAndNothingOverlaps) {
    const auto width = static_cast<float>(GetParam().first);
    const auto height = static_cast<float>(GetParam().second);
    const float font_px = font_size_px(width, height, 1, 0);
    const TextSize text = plain_text(font_px);
    HudTexts texts;
    texts.status = {{.text = "Q: crate   paused   speed 0.5x   12.3 s dropped: slower than real "
                             "time   9 debug lines not shown"}};
    texts.verdict = {{.text = "H05  passing so far  3.2 of 10 s"},
                     {.text = "the tower stands: 0.0012  within 0.5 of 1 mm"}};
    texts.target = {{.text = "oak crate, 30 kg"}};
    texts.hint = {{.text = "Left mouse: throw one (hold to throw harder)"}};
    texts.captions = {{.text = "< wood hits stone"}, {.text = "garden gate: creaking >"}};
    for (int i = 0; i < 6; ++i)
        texts.messages.push_back(
            {.text = std::string(150 + 20 * static_cast<std::size_t>(i), 'm')});
    for (const float right_taken : {0.0F, font_px * 25.0F}) {
        if (right_taken == 0.0F) {
            texts.side.assign(28, {.text = "translucent: cpu 0.12  gpu 0.34 ms"});
        } else {
            texts.side.clear();
        }
        // Who asks for the statistics of a hard case has a window that holds both.
        if (width < 1000.0F && right_taken == 0.0F) texts.verdict.clear();
        const HudLayout layout = layout_of(texts, width, height, font_px, right_taken, text);
        const std::array<const HudPanel*, 7> panels{&layout.status,
                                                    &layout.verdict,
                                                    &layout.side,
                                                    &layout.target,
                                                    &layout.messages,
                                                    &layout.hint,
                                                    &layout.captions};
        for (std::size_t i = 0; i < panels.size(); ++i) {
            const Box& box = panels[i]->box;
            if (panels[i]->texts.empty()) continue;
            EXPECT_GE(box.x, 0.0F) << i;
            EXPECT_GE(box.y, 0.0F) << i;
            EXPECT_LE(box.right(), width - right_taken + (i == 3 ? right_taken : 0.0F)) << i;
            EXPECT_LE(box.bottom(), height) << i;
            for (const PlacedText& line : panels[i]->texts) {
                EXPECT_LE(line.box.right(), box.right()) << line.line.text;
                EXPECT_LE(line.box.bottom(), box.bottom()) << line.line.text;
            }
            for (std::size_t j = i + 1; j < panels.size(); ++j) {
                if (panels[j]->texts.empty() || i == 2 || j == 2) continue;
                EXPECT_FALSE(overlap(box, panels[j]->box)) << i << " over " << j;
            }
            if (i != 2 && i != 3 && !layout.side.texts.empty()) {
                EXPECT_FALSE(overlap(box, layout.side.box)) << i << " over the side";
            }
        }
        EXPECT_EQ(layout.messages.texts.back().line.text, texts.messages.back().text);
    }
}

INSTANTIATE_TEST_SUITE_P(Windows,
                         HudAtSize,
                         testing::Values(std::pair{640, 360},
                                         std::pair{1280, 720},
                                         std::pair{3840, 2160},
                                         std::pair{1920, 1080}));

}  // namespace
}  // namespace plumbline::app::ui
