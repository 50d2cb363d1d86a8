// The statistics: what is read at a glance, and the full table.
#include "tests/engine/app/overlay/overlay_fixture.h"

#include <algorithm>

namespace plumbline::app {
namespace {

class StatsPageTest : public OverlayPanels {
protected:
    StatsPageTest() {
        report_.add_frame(20.0,
                          {.passes = {{.name = "opaque", .cpu_ms = 1.25},
                                      {"sky", 0.5, 0.25},
                                      {"image", 0.1, 3.0},
                                      {"ui", 0.75, 0.5}},
                           .draw_calls = 7,
                           .triangles = 12,
                           .instances = 3,
                           .shadowed_lights = 4,
                           .unshadowed_lights = 2,
                           .scene_width_px = 640,
                           .scene_height_px = 360});
        report_.add_step({.total_ms = 0.5});
        report_.add_step({.total_ms = 1.5});
        ledger_ = {{.name = "fog", .calls = 9, .cpu_ms = 0.5, .exists = true},
                   {.name = "wind", .calls = 9, .cpu_ms = 2.0, .exists = true},
                   {.name = "lamps", .calls = 9, .cpu_ms = 1.0, .exists = true},
                   {.name = "clouds", .calls = 9, .cpu_ms = 0.25, .exists = true},
                   {.name = "grass", .cpu_ms = 9.0, .exists = false}};
    }

    /// "text|value" of each line.
    std::vector<std::string> lines(StatsPage page) {
        parts_.stats = page;
        std::vector<std::string> all;
        for (const ui::HudLine& line : panels::stats_lines(input()))
            all.push_back(line.text + "|" + line.value);
        return all;
    }
    static bool has(const std::vector<std::string>& all, std::string_view line) {
        return std::ranges::find(all, line) != all.end();
    }
};

TEST_F(StatsPageTest, TheSummaryNamesTheThreeMostExpensivePassesAndEffects) {
    const std::vector<std::string> page = lines(StatsPage::Summary);
    EXPECT_EQ(page[0], "50 fps   20.0 ms|p99 20.0 ms");
    const auto below = [&](std::string_view heading) {
        const auto at = std::ranges::find(page, heading);
        return at + 4 < page.end() ? std::vector<std::string>(at + 1, at + 4)
                                   : std::vector<std::string>{};
    };
    // The image takes longer on the GPU than any other on either.
    EXPECT_EQ(below("Most expensive passes|"),
              (std::vector<std::string>{"image|3.00 ms", "opaque|1.25 ms", "ui|0.75 ms"}));
    EXPECT_EQ(below("Most expensive effects|"),
              (std::vector<std::string>{"wind|2.00 ms", "lamps|1.00 ms", "fog|0.50 ms"}));
    EXPECT_EQ(page.back(), "F3: full table|");
    EXPECT_LE(page.size(), 16U) << "at a glance";
}

TEST_F(StatsPageTest, TheGraphsHoldTheLatestFramesAndStepsBelowTheirBudgets) {
    parts_.stats = StatsPage::Summary;
    std::vector<ui::HudLine> graphs;
    for (const ui::HudLine& line : panels::stats_lines(input()))
        if (!line.graph.empty()) graphs.push_back(line);
    ASSERT_EQ(graphs.size(), 2U);
    EXPECT_EQ(graphs[0].graph, std::vector<float>{20.0F});
    EXPECT_FLOAT_EQ(graphs[0].graph_budget, 1000.0F / 60.0F);
    EXPECT_FLOAT_EQ(graphs[0].graph_top, 22.0F);
    EXPECT_EQ(graphs[1].graph, (std::vector<float>{0.5F, 1.5F}));
    EXPECT_FLOAT_EQ(graphs[1].graph_budget, 1000.0F / 60.0F) << "a step of the scene's 60 Hz";
    EXPECT_FLOAT_EQ(graphs[1].graph_top, 1.65F);
    for (int i = 0; i < 200; ++i) report_.add_step({.total_ms = static_cast<double>(i)});
    EXPECT_EQ(report_.recent_steps().size(), 120U);
    EXPECT_EQ(report_.recent_steps().back(), 199.0F);
}

TEST_F(StatsPageTest, TheFullTableHasEveryPassAndEveryEffectThatExists) {
    const std::vector<std::string> page = lines(StatsPage::FullTable);
    for (const char* line : {"opaque|1.25  -",
                             "sky|0.50  0.25",
                             "image|0.10  3.00",
                             "ui|0.75  0.50",
                             "fog|0.500",
                             "clouds|0.250",
                             "Image quality full|640 x 360",
                             "Draw calls|7",
                             "Triangles|12",
                             "Lamps|4 with shadows, 2 without",
                             "2 bodies, 2 awake|0 contacts"})
        EXPECT_TRUE(has(page, line)) << line;
    EXPECT_TRUE(std::ranges::none_of(
        page, [](const std::string& line) { return line.starts_with("grass"); }));
    EXPECT_EQ(page.back(), "F3: close|");
    EXPECT_TRUE(lines(StatsPage::Off).empty());
}

TEST_F(StatsPageTest, PhasesAndThreadsOfAStepAreBarsOfIt) {
    report_ = FrameReport();
    report_.add_step(
        {.broad_ms = 0.1, .narrow_ms = 0.3, .solve_ms = 0.5, .integrate_ms = 0.1, .total_ms = 1});
    EXPECT_TRUE(has(lines(StatsPage::FullTable), "  narrow phase|0.30 ms"));
    EXPECT_FALSE(has(lines(StatsPage::FullTable), "  helper threads|0.00 ms"));
    for (int i = 0; i < 1000; ++i)
        report_.add_step({.broad_ms = 0.1,
                          .narrow_ms = 0.4,
                          .solve_ms = 1.4,
                          .integrate_ms = 0.1,
                          .total_ms = 3,
                          .helpers_ms = 1});
    const std::pair<const char*, float> bars[] = {{"  narrow phase", 0.2F},
                                                  {"  solver", 0.7F},
                                                  {"  calling thread", 2.0F / 3.0F},
                                                  {"  helper threads", 1.0F / 3.0F}};
    const std::vector<ui::HudLine> page = panels::stats_lines(input());
    for (const auto& [name, share] : bars) {
        const auto line = std::ranges::find(page, std::string(name), &ui::HudLine::text);
        ASSERT_NE(line, page.end()) << name;
        EXPECT_NEAR(line->share, share, 1e-4F) << name;
    }
}

TEST_F(StatsPageTest, TheKeyGoesThroughSummaryAndFullTable) {
    EXPECT_EQ(next(StatsPage::Off), StatsPage::Summary);
    EXPECT_EQ(next(StatsPage::Summary), StatsPage::FullTable);
    EXPECT_EQ(next(StatsPage::FullTable), StatsPage::Off);
}

}  // namespace
}  // namespace plumbline::app
