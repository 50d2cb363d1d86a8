// What a run of frames cost, as the report tells it.
#include "engine/app/frame_report.h"

#include "engine/core/time/stopwatch.h"
#include "tests/engine/app/session_fixture.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace plumbline::app {
namespace {

using Json = nlohmann::json;

class FrameReportTest : public SessionTest {
protected:
    FrameReportTest() : session_(open()) {}
    Json json(const std::string& before = {}) {
        ReportContext context{.simulation = *session_->simulation,
                              .ledger = ledger_,
                              .gl = gl_,
                              .lost_s = 1.5,
                              .before = before};
        context.presses_seen[index_of(Action::Drop)] = 3;
        return Json::parse(report_.json(context));
    }

    std::unique_ptr<Session> session_;
    std::vector<effects::LedgerLine> ledger_;
    render::GlInfo gl_{};
    FrameReport report_;
};

TEST_F(FrameReportTest, TellsMemoryAndCostOfTheLatestSeconds) {
    for (int i = 0; i < 3; ++i) report_.add_frame(10.0, {});
    const std::vector<char> more(64U << 20U, 'x');
    const Json told = json()["intervals"];
    ASSERT_EQ(told.size(), 1U);
    EXPECT_EQ(told[0]["frames"], 3);
    EXPECT_GE(told[0]["process_cpu_ms_per_frame"], 0.0);
    EXPECT_GT(told[0]["resident_bytes"], more.size());
    // The system adds up what threads have taken a few pages at a time.
    EXPECT_LE(told[0]["resident_bytes"].get<double>(),
              1.01 * json()["peak_rss_bytes"].get<double>());
}

TEST_F(FrameReportTest, AveragesPassesAndTellsWhatWasNotMeasured) {
    report_.add_frame(10.0, {.passes = {{"opaque", 2.0, -1.0}, {"sky", 1.0, 4.0}}});
    report_.add_frame(30.0,
                      {.passes = {{"opaque", 4.0, -1.0}, {"sky", 3.0, -1.0}},
                       .draw_calls = 5,
                       .shadow_passes_rendered = 2});
    const Json told = json();
    EXPECT_EQ(told["scene"], "scene.toml");
    EXPECT_EQ(told["frames"], 2);
    EXPECT_EQ(told["cpu_ms"]["opaque"], 3.0);
    EXPECT_EQ(told["cpu_ms"]["sky"], 2.0);
    EXPECT_EQ(told["gpu_ms"]["opaque"], -1.0) << "not measured is not free";
    EXPECT_EQ(told["gpu_ms"]["sky"], 4.0) << "the mean of those that were measured";
    EXPECT_EQ(told["frame_ms"]["max"], 30.0);
    EXPECT_EQ(told["draw_calls"], 5) << "of the last frame";
    EXPECT_EQ(told["shadow_passes_rendered"], 2) << "of all frames";
    EXPECT_EQ(told["lost_time_s"], 1.5);
    EXPECT_EQ(told["bodies"], 2);
    EXPECT_EQ(told["actions_seen"], (Json{{"drop", 3}}));
    EXPECT_EQ(told["image"]["level"], "full");
    EXPECT_FALSE(told.contains("before"));
    EXPECT_EQ(json(R"({"frames": 7})")["before"]["frames"], 7);
}

TEST_F(FrameReportTest, KeepsTheFiveLongestFramesWithoutTheFirst) {
    for (const double ms : {900.0, 10.0, 50.0, 20.0, 40.0, 30.0, 60.0, 5.0})
        report_.add_frame(ms, {.passes = {{"opaque", ms / 2, -1.0}}, .new_programs = 1});
    const Json longest = json()["longest_frames"];
    ASSERT_EQ(longest.size(), 5U);
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_EQ(longest[i]["frame_ms"], 60.0 - 10.0 * static_cast<double>(i));
        EXPECT_EQ(longest[i]["cpu_ms"]["opaque"], 30.0 - 5.0 * static_cast<double>(i));
        EXPECT_EQ(longest[i]["new_programs"], 1);
    }
}

TEST_F(FrameReportTest, TellsOfTheFrameInWhichTheMenuOpened) {
    report_.note_menu_opened();
    report_.add_frame(80.0, {});  // the first: there is none before it to compare with
    report_.add_frame(10.0, {});
    report_.add_frame(10.0, {});
    report_.note_menu_opened();
    report_.add_frame(25.0, {});
    report_.add_frame(10.0, {});
    const Json menus = json()["menu_opened"];
    ASSERT_EQ(menus.size(), 1U);
    EXPECT_EQ(menus[0]["frame_ms"], 25.0);
    EXPECT_EQ(menus[0]["median_before_ms"], 10.0);
}

TEST_F(FrameReportTest, RecentFramesAreTheLast120) {
    for (int i = 0; i < 200; ++i) report_.add_frame(i < 80 ? 100.0 : 10.0, {});
    EXPECT_EQ(report_.recent_frame_ms().max, 10.0);
    EXPECT_EQ(json()["frame_ms"]["max"], 100.0);
    EXPECT_EQ(FrameReport().recent_frame_ms().median, 0.0) << "none so far";
}

TEST_F(FrameReportTest, StartupCountsFromTheChoiceOfTheScene) {
    FrameReport chosen(wall_s() - 2.0);
    chosen.add_frame(1.0, {});
    EXPECT_NEAR(chosen.startup_ms(), 2000.0, 500.0);
}

}  // namespace
}  // namespace plumbline::app
