#include "engine/study/scenes/scene_text.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>

namespace plumbline::study {
namespace {

Point told_point(const Setting& setting, double ms_a_frame, double error) {
    Point point;
    point.setting = setting;
    point.errors = {error};
    point.cost.ms_per_s_min = 60.0 * ms_a_frame;
    point.cost.repeats = 1;
    return point;
}

SceneStudy told_study() {
    SceneStudy study;
    study.subject.id = "x.toml";
    study.subject.title = "X";
    study.subject.metrics = {{"place", "1 m"}};
    study.subject.points = {
        told_point({.step_hz = 60, .substeps = 1}, 0.01, 0.02),
        told_point({.step_hz = 60, .substeps = 4}, 0.1, 0.006),
        told_point({.step_hz = 240, .substeps = 4}, 1.0, 0.001),
        told_point({.step_hz = 30, .substeps = 4, .precision = Precision::Float64}, 0.001, 1e-6)};
    return study;
}

TEST(SceneText, ThreadsAreComparedWithTheFirstNumber) {
    SceneStudy study = told_study();
    EXPECT_EQ(scene_study_text(study).find("speed-up"), std::string::npos);
    study.subject.threads = {
        {.threads = 1, .same = true, .cost = {.ms_per_s_min = 60, .clock_ms_per_s = 60}},
        {.threads = 2, .same = true, .cost = {.ms_per_s_min = 72, .clock_ms_per_s = 40}},
        {.threads = 3, .status = RunStatus::TimedOut, .why = "too long"}};
    const std::string text = scene_study_text(study);
    EXPECT_NE(text.find("      2        1.2000          0.6667      1.50  same\n"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("      3  timed out: too long\n"), std::string::npos) << text;
}

TEST(SceneText, ATolerancesUncertaintyTightensItToHalfAtMost) {
    SceneStudy study = told_study();
    EXPECT_EQ(choose(study, {})->point, 1U) << "1 %, and float64 cannot be asked for";
    study.subject.uncertainty = 0.003;
    EXPECT_EQ(choose(study, {.tolerance = 0.01})->point, 1U) << "0.6 % is within 0.7 %";
    study.subject.uncertainty = 0.005;
    EXPECT_EQ(choose(study, {.tolerance = 0.01})->point, 2U);
    study.subject.uncertainty = 0.5;
    const std::optional<Choice> half = choose(study, {.tolerance = 0.002});
    EXPECT_EQ(half->point, 2U);
    EXPECT_TRUE(half->met);
    study.subject.uncertainty = 0.0008;
    EXPECT_TRUE(choose(study, {.tolerance = 0.001})->met) << "within what was asked for";
    EXPECT_FALSE(choose(study, {.tolerance = 1e-5})->met);
    study.subject.points.resize(0);
    EXPECT_FALSE(choose(study, {}));
}

TEST(SceneText, ATenthOfABudgetIsKeptForWhatCostsVaryBy) {
    const SceneStudy study = told_study();
    EXPECT_EQ(choose(study, {.budget_ms = 0.2})->point, 1U);
    const double cost_ms = ms_per_frame(study.subject.points[2]);
    EXPECT_EQ(choose(study, {.budget_ms = 1.05 * cost_ms})->point, 1U);
    EXPECT_EQ(choose(study, {.budget_ms = 1.15 * cost_ms})->point, 2U);
    const double least_ms = ms_per_frame(study.subject.points[0]);
    EXPECT_TRUE(choose(study, {.budget_ms = 1.05 * least_ms})->met) << "nothing is cheaper";
    EXPECT_FALSE(choose(study, {.budget_ms = 0.005})->met);
}

TEST(SceneText, WishesAreLinesToPasteWithWhatTheyReach) {
    const SceneStudy study = told_study();
    EXPECT_EQ(wish_text(study, {}),
              "# small_step 60 Hz x 4, float32: 0.6 % off, 0.1000 ms a frame\n" +
                  accuracy_lines({.step_hz = 60, .substeps = 4}));
    EXPECT_TRUE(wish_text(study, {.tolerance = 1e-5})
                    .starts_with("# no setting stays under 0.001 %; this is the best seen\n"));
    EXPECT_TRUE(
        wish_text(study, {.budget_ms = 0.005})
            .starts_with("# no setting stays under 0.005 ms a frame; this is the cheapest\n"));
    EXPECT_EQ(wish_text({}, {}), "# no setting completed this scene, so none is recommended\n");
}

TEST(SceneText, TheTableMarksWhatNothingBeatsAndSaysWhoFailed) {
    SceneStudy study = told_study();
    Point failed;
    failed.setting = {.solver = physics::Solver::BulletSi, .substeps = 1};
    failed.status = RunStatus::Exploded;
    failed.why = "too much energy";
    study.subject.points.push_back(failed);
    const std::string text = scene_study_text(study);
    EXPECT_NE(text.find("0.6 %       0.6 %\n"), std::string::npos) << "beaten by float64\n" << text;
    EXPECT_NE(text.find("0.0001 %  *\n"), std::string::npos) << text;
    EXPECT_NE(text.find("exploded: too much energy\n"), std::string::npos) << text;
    EXPECT_EQ(text.find("nothing to compare"), std::string::npos);
    study.subject.points = {failed};
    EXPECT_NE(scene_study_text(study).find("there is nothing to compare:\n  bullet_si"),
              std::string::npos);
    study.subject.points.clear();
    EXPECT_TRUE(scene_study_text(study).ends_with("No setting was measured.\n"));
}

}  // namespace
}  // namespace plumbline::study
