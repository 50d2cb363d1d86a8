#include "engine/study/auto_preset/auto_accuracy.h"

#include <gtest/gtest.h>

namespace plumbline::study {
namespace {

Point point(Setting setting, double ms_a_frame, double error) {
    Point point;
    point.setting = setting;
    point.errors = {error};
    point.cost.ms_per_s_min = 60.0 * ms_a_frame;
    point.cost.repeats = 5;
    return point;
}

/// Ten times the cost buys a tenth of the error. The best is in float64, which a file cannot ask for.
SceneStudy study() {
    SceneStudy study;
    study.subject.points = {
        point({.step_hz = 30, .substeps = 1}, 0.01, 0.1),
        point({.step_hz = 60, .substeps = 4}, 0.1, 0.01),
        point({.step_hz = 240, .substeps = 0}, 1.0, 0.001),
        point({.solver = physics::Solver::BulletSi, .step_hz = 60, .substeps = 1, .iterations = 10},
              0.2,
              0.05),
        point({.step_hz = 60, .substeps = 4, .precision = Precision::Float64}, 0.001, 1e-6)};
    return study;
}

scene::Accuracy within(double tolerance) {
    scene::Accuracy asked{.preset = "auto"};
    asked.tolerance = tolerance;
    return asked;
}

TEST(AutoAccuracy, TakesTheCheapestWithinTheTolerance) {
    const auto chosen = auto_choice(study(), within(0.02));
    ASSERT_TRUE(chosen);
    EXPECT_TRUE(chosen->met);
    EXPECT_EQ(chosen->accuracy.step_hz, 60);
    EXPECT_EQ(chosen->accuracy.substeps, 4);
    EXPECT_EQ(chosen->accuracy.substeps_max, 4);  // exactly four
    EXPECT_EQ(chosen->accuracy.solver, physics::Solver::SmallStep);
}

TEST(AutoAccuracy, SubstepsOnDemandStayOnDemand) {
    const auto chosen = auto_choice(study(), within(0.002));
    ASSERT_TRUE(chosen);
    EXPECT_EQ(chosen->accuracy.step_hz, 240);
    EXPECT_LT(*chosen->accuracy.substeps, *chosen->accuracy.substeps_max);
}

TEST(AutoAccuracy, TakesTheMostAccurateWithinTheBudget) {
    scene::Accuracy asked{.preset = "auto"};
    asked.budget_ms = 0.5;
    const auto chosen = auto_choice(study(), asked);
    ASSERT_TRUE(chosen);
    EXPECT_TRUE(chosen->met);
    EXPECT_EQ(chosen->accuracy.step_hz, 60);
    asked.budget_ms = 0.001;
    const auto cheapest = auto_choice(study(), asked);
    ASSERT_TRUE(cheapest);
    EXPECT_FALSE(cheapest->met);
    EXPECT_EQ(cheapest->accuracy.step_hz, 30);
}

TEST(AutoAccuracy, NothingReachesItTheBestSeenIsTaken) {
    const auto chosen = auto_choice(study(), within(1e-5));
    ASSERT_TRUE(chosen);
    EXPECT_FALSE(chosen->met);
    EXPECT_EQ(chosen->accuracy.step_hz, 240);
}

// 0.01 is within 0.0105, but not if the errors may be off by as much as 0.001.
TEST(AutoAccuracy, AnUncertainReferenceTightensTheTolerance) {
    SceneStudy uncertain = study();
    EXPECT_EQ(auto_choice(uncertain, within(0.0105))->accuracy.step_hz, 60);
    uncertain.subject.uncertainty = 0.001;
    EXPECT_EQ(auto_choice(uncertain, within(0.0105))->accuracy.step_hz, 240);
    // It never asks for less than half of the tolerance.
    uncertain.subject.uncertainty = 10;
    EXPECT_EQ(auto_choice(uncertain, within(0.0202))->accuracy.step_hz, 60);
}

TEST(AutoAccuracy, WhatTheFileSaysLimitsTheChoice) {
    scene::Accuracy asked = within(0.2);
    EXPECT_EQ(auto_choice(study(), asked)->accuracy.step_hz, 30);
    asked.step_hz = 60;
    asked.step_hz_given = true;
    EXPECT_EQ(auto_choice(study(), asked)->accuracy.step_hz, 60);
    asked.solver = physics::Solver::BulletSi;
    asked.solver_given = true;
    EXPECT_EQ(auto_choice(study(), asked)->accuracy.solver, physics::Solver::BulletSi);
    asked.iterations = 33;
    EXPECT_FALSE(auto_choice(study(), asked));
}

TEST(AutoAccuracy, OtherPresetsAreLeftAlone) {
    scene::OpenedScene scene;
    scene.description.accuracy.preset = "precise";
    scene.description.accuracy.step_hz = 120;
    EXPECT_EQ(resolve_auto(scene).preset, "precise");
    EXPECT_EQ(resolve_auto(scene).step_hz, 120);
}

// A study would start worker processes, which this program does not answer as.
TEST(AutoAccuracy, WhereNothingIsLeftToChooseNothingIsStudied) {
    scene::OpenedScene scene;
    scene::Accuracy& asked = scene.description.accuracy;
    asked.preset = "auto";
    put_over({.solver = physics::Solver::BulletSi, .step_hz = 77, .substeps = 3, .iterations = 9},
             asked);
    const scene::Accuracy got = resolve_auto(scene);
    EXPECT_EQ(got.preset, "auto");
    EXPECT_EQ(got.step_hz, 77);
    EXPECT_EQ(got.iterations, 9);
}

TEST(AutoAccuracy, ARateThatNoStudyTriesIsTakenWithBalanced) {
    scene::OpenedScene scene;
    scene.description.accuracy.preset = "auto";
    put_over({.step_hz = 77}, scene.description.accuracy);
    const scene::Accuracy got = resolve_auto(scene);
    EXPECT_EQ(got.preset, "balanced");
    EXPECT_EQ(got.step_hz, 77);
}

}  // namespace
}  // namespace plumbline::study
