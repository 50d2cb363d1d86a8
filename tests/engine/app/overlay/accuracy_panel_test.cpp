// The accuracy panel: what it offers, and what a click in it asks for.
#include "tests/engine/app/overlay/accuracy_panel_fixture.h"

namespace plumbline::app {
namespace {

TEST_F(AccuracyPanel, TakesTheRightEdgeAndAsksForNothingByItself) {
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(frame(1, 1, false).empty());
    EXPECT_NEAR(taken_px_, canvas_.font_px() * 24.8F, 0.01F);
    canvas_.resize(200, 300, 1.0F, 0.0F);
    frame(1, 1, false);
    EXPECT_NEAR(taken_px_, 200.0F - canvas_.font_px() * 0.8F, 0.01F) << "never out of the window";
}

TEST_F(AccuracyPanel, ClicksAskForASettingAGhostAndACopy) {
    frame(1, 1, false);
    const Requests asked = click_everywhere();
    const study::Setting now = control_.setting();
    EXPECT_FALSE(all_of<AdoptAccuracy>(asked).empty());
    EXPECT_TRUE(std::ranges::any_of(settings_in(asked),
                                    [&](const study::Setting& each) { return each != now; }));
    bool from_start = false;
    bool from_here = false;
    for (const StartGhost& ghost : all_of<StartGhost>(asked)) {
        // Four times the rate and at least eight sub-steps, in double precision.
        EXPECT_EQ(ghost.setting.step_hz, std::min(4 * now.step_hz, 480));
        EXPECT_EQ(ghost.setting.substeps, std::max(8, 2 * now.substeps));
        EXPECT_EQ(ghost.setting.precision, study::Precision::Float64);
        from_start = from_start || ghost.from == GhostFrom::Start;
        from_here = from_here || ghost.from == GhostFrom::Here;
    }
    EXPECT_TRUE(from_start && from_here);
}

TEST_F(AccuracyPanel, AReplayKeepsItsSettingAndItsStart) {
    replaying_ = true;
    frame(1, 1, false);
    const Requests asked = click_everywhere();
    EXPECT_TRUE(settings_in(asked).empty());
    EXPECT_TRUE(all_of<StartGhost>(asked).empty());
}

// FAULTS N30: a click that comes with the pointer's way onto the panel is the panel's.
TEST_F(AccuracyPanel, CoversWhatLiesBelowItFromTheFrameThatShowsIt) {
    EXPECT_FALSE(canvas_.covers(1200, 40));
    frame(1, 1, false);
    frame(1, 1, false);
    EXPECT_FALSE(ImGui::GetIO().WantCaptureMouse) << "the pointer is elsewhere";
    EXPECT_TRUE(canvas_.covers(1200, 40));
    EXPECT_FALSE(canvas_.covers(600, 40));
}

// FAULTS N30: the solver is chosen with arrows once its list is open, and arrows walk otherwise.
TEST_F(AccuracyPanel, ArrowsChooseInAnOpenList) {
    constexpr int kDown = 264;
    constexpr int kEnter = 257;
    frame(1, 1, false);
    frame(1, 1, false, {kDown, kEnter});
    EXPECT_FALSE(canvas_.takes_keys());
    double y = 14.0;
    const double x = 1280.0 - static_cast<double>(taken_px_) * 0.9;
    for (; y < 300.0 && !canvas_.takes_keys(); y += 6.0) {
        frame(x, y, false);
        frame(x, y, true);
        frame(x, y, false);
    }
    ASSERT_TRUE(canvas_.takes_keys()) << "no list opened";
    Requests asked;
    for (int i = 0; i < 4; ++i) frame(x, y, false);
    for (const int key : {kDown, kEnter}) {
        std::ranges::move(frame(x, y, false, {key}), std::back_inserter(asked));
        for (int i = 0; i < 3; ++i)
            std::ranges::move(frame(x, y, false), std::back_inserter(asked));
    }
    const std::vector<study::Setting> settings = settings_in(asked);
    ASSERT_EQ(settings.size(), 1U);
    EXPECT_EQ(settings[0].solver, physics::Solver::BulletSi) << "the one below small_step";
    EXPECT_FALSE(canvas_.takes_keys());
}

}  // namespace
}  // namespace plumbline::app
