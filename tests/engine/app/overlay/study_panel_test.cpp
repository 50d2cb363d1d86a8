// The study in the accuracy panel: what a click in it asks for.
#include "tests/engine/app/overlay/accuracy_panel_fixture.h"

namespace plumbline::app {
namespace {

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

}  // namespace
}  // namespace plumbline::app
