// The accuracy panel: what it offers, and what a click in it asks for.
#include "engine/app/overlay/overlay_panels_impl.h"
#include "engine/app/ui/canvas_impl.h"
#include "tests/engine/app/session_fixture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <vector>

namespace plumbline::app {
namespace {

class AccuracyPanel : public SessionTest {
protected:
    AccuracyPanel() : session_(open()), control_(*session_) {
        canvas_.resize(1280, 720, 1.0F, 0.0F);
    }

    Requests frame(double x, double y, bool down, const std::vector<int>& keys = {}) {
        InputSnapshot input;
        input.now_s = now_s_ += 0.02;
        input.cursor_px = {x, y};
        input.buttons[0] = down;
        for (const int key : keys) {
            input.events.push_back({DeviceEventKind::Key, key, true});
            input.events.push_back({DeviceEventKind::Key, key, false});
        }
        canvas_.begin(input);
        Requests asked;
        taken_px_ =
            panels::draw_accuracy({.control = control_, .clock = clock_, .replaying = replaying_},
                                  canvas_.font_px(),
                                  asked);
        canvas_.end();
        return asked;
    }
    /// Presses and lets go at every place of a grid over the panel; all that was asked.
    Requests click_everywhere() {
        Requests asked;
        for (double y = 14.0; y < 718.0; y += 9.0) {
            for (const double share : {0.05, 0.25, 0.45}) {
                const double x = 1280.0 - static_cast<double>(taken_px_) * (1.0 - share);
                frame(x, y, false);
                std::ranges::move(frame(x, y, true), std::back_inserter(asked));
                std::ranges::move(frame(x, y, false), std::back_inserter(asked));
            }
        }
        return asked;
    }
    template <class T>
    static std::vector<T> all_of(const Requests& requests) {
        std::vector<T> found;
        for (const Request& each : requests)
            if (const T* one = std::get_if<T>(&each)) found.push_back(*one);
        return found;
    }
    static std::vector<study::Setting> settings_in(const Requests& requests) {
        std::vector<study::Setting> found;
        for (const WorldRequest& each : all_of<WorldRequest>(requests))
            found.push_back(std::get<SetAccuracy>(each).setting);
        return found;
    }

    std::unique_ptr<Session> session_;
    AccuracyControl control_;
    bool replaying_{false};
    ui::Canvas canvas_;
    FrameClock clock_{1.0 / 60.0};
    float taken_px_{0};
    double now_s_{0};
};

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

/// Three settings of a study that was made before.
class StudyPanel : public AccuracyPanel {
protected:
    StudyPanel() {
        study::CachedStudy kept{.made_on = "2026-11-28"};
        study::Subject& subject = kept.study.subject;
        subject.set_up = "1 bodies, compared at 1 s";
        subject.metrics = {{.name = "position"}};
        for (const int step_hz : {30, 60, 240}) {
            const study::Setting setting{.step_hz = step_hz, .substeps = 2};
            subject.points.push_back(
                {.setting = setting,
                 .errors = {1.0 / step_hz / step_hz},
                 .cost = {.ms_per_s_min = static_cast<double>(step_hz), .repeats = 1}});
        }
        EXPECT_TRUE(study::keep_study(
            study::study_cache_folder(), study::study_key(session_->opened()), kept));
        control_.watch(true);
    }
};

TEST_F(StudyPanel, AClickOnAPointAdoptsItWithAGhostBesideIt) {
    frame(1, 1, false);
    const Requests asked = click_everywhere();
    EXPECT_FALSE(all_of<StartStudy>(asked).empty());
    bool adopted = false;
    for (std::size_t i = 0; i + 1 < asked.size(); ++i) {
        const auto* world = std::get_if<WorldRequest>(&asked[i]);
        const auto* accuracy = world == nullptr ? nullptr : std::get_if<SetAccuracy>(world);
        if (accuracy == nullptr || accuracy->setting.substeps != 2) continue;
        const auto* ghost = std::get_if<StartGhost>(&asked[i + 1]);
        ASSERT_NE(ghost, nullptr) << "a ghost shows the difference";
        EXPECT_EQ(ghost->setting, panels::finer(accuracy->setting));
        EXPECT_EQ(ghost->from, GhostFrom::Here);
        adopted = true;
    }
    EXPECT_TRUE(adopted);
}

TEST_F(StudyPanel, AReplayShowsItAndOffersNothing) {
    replaying_ = true;
    frame(1, 1, false);
    const Requests asked = click_everywhere();
    EXPECT_TRUE(all_of<StartStudy>(asked).empty());
    EXPECT_TRUE(settings_in(asked).empty());
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
