#include "engine/study/scenes/scene_errors.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::study {
namespace {

Moment moment(double time_s, std::vector<BodyPose> bodies, double energy_J = 0) {
    Moment moment{.time_s = time_s, .bodies = std::move(bodies), .energy_J = energy_J};
    return moment;
}

BodyPose at(double x, double y, double z) {
    return {.position_m = {x, y, z}};
}

/// Two bodies 3 m and 4 m apart on two axes: the box round them has a diagonal of 5 m.
SceneAnswer two_bodies() {
    SceneAnswer answer{.bodies = 2, .mass_kg = 2, .gravity_mps2 = 10, .body_size_m = 0.5};
    answer.traces.push_back(
        {.moments = {moment(0, {at(0, 0, 0), at(3, 4, 0)}), moment(1, {at(0, 0, 0), at(3, 4, 0)})},
         .energy_turnover_J = 20});
    return answer;
}

TEST(SceneErrors, ScalesComeFromTheReference) {
    const Scales scales = scales_of(two_bodies());
    EXPECT_DOUBLE_EQ(scales.length_m, 5.0);
    EXPECT_DOUBLE_EQ(scales.energy_J, 20.0);
    EXPECT_DOUBLE_EQ(scales.body_size_m, 0.5);
    EXPECT_EQ(trajectory_metrics(scales).size(), 4U);  // no joints, no joint error
}

TEST(SceneErrors, AStillSceneIsMeasuredByALiftOfAHundredthOfItsLength) {
    SceneAnswer still = two_bodies();
    still.traces[0].energy_turnover_J = 0;
    EXPECT_DOUBLE_EQ(scales_of(still).energy_J, 0.01 * 2 * 10 * 5);
}

TEST(SceneErrors, ARunAgainstItselfIsExact) {
    const SceneAnswer answer = two_bodies();
    for (const double error :
         trajectory_errors(answer.traces[0], answer.traces[0], scales_of(answer)))
        EXPECT_EQ(error, 0.0);
}

TEST(SceneErrors, PositionIsTheRootMeanSquareOverTheScenesSize) {
    const SceneAnswer reference = two_bodies();
    Trace run = reference.traces[0];
    run.moments[1].bodies[0].position_m.x += 0.1;  // one of two bodies: 0.1 / sqrt(2)
    const std::vector<double> errors =
        trajectory_errors(run, reference.traces[0], scales_of(reference));
    EXPECT_NEAR(errors[0], 0.1 / std::sqrt(2.0) / 5.0, 1e-15);
}

TEST(SceneErrors, AQuarterTurnOfAllBodiesIsAHalf) {
    const SceneAnswer reference = two_bodies();
    Trace run = reference.traces[0];
    const Quatd quarter = glm::angleAxis(std::acos(0.0), Vec3d{0, 1, 0});
    // q and -q are the same orientation.
    run.moments[1].bodies[0].orientation = quarter;
    run.moments[1].bodies[1].orientation = -quarter;
    const std::vector<double> errors =
        trajectory_errors(run, reference.traces[0], scales_of(reference));
    EXPECT_NEAR(errors[1], 0.5, 1e-7);
    EXPECT_EQ(errors[0], 0.0);
}

TEST(SceneErrors, LessPenetrationThanTheReferenceIsNoError) {
    SceneAnswer reference = two_bodies();
    reference.traces[0].penetration_m = 0.01;
    Trace run = reference.traces[0];
    run.penetration_m = 0.0;
    EXPECT_EQ(trajectory_errors(run, reference.traces[0], scales_of(reference))[3], 0.0);
    run.penetration_m = 0.06;
    EXPECT_NEAR(
        trajectory_errors(run, reference.traces[0], scales_of(reference))[3], 0.05 / 0.5, 1e-15);
}

TEST(SceneErrors, ARunThatStoppedEarlyHasNoNumbers) {
    const SceneAnswer reference = two_bodies();
    Trace run = reference.traces[0];
    run.moments.pop_back();
    for (const double error : trajectory_errors(run, reference.traces[0], scales_of(reference)))
        EXPECT_TRUE(std::isnan(error));
}

/// Copies whose centre is spread evenly from `low_m` to `high_m`.
std::vector<Trace> copies(double low_m, double high_m, int count) {
    std::vector<Trace> all;
    for (int i = 0; i < count; ++i) {
        Trace trace;
        trace.moments = {moment(0, {}), moment(1, {})};
        trace.moments[1].layout.center_m.x = low_m + (high_m - low_m) * i / (count - 1);
        all.push_back(trace);
    }
    return all;
}

TEST(SceneErrors, EnsemblesAreComparedByTheirMedians) {
    const Scales scales{.length_m = 10, .energy_J = 1, .body_size_m = 1};
    const std::vector<Trace> reference = copies(-1, 1, 9);
    const std::vector<double> errors = ensemble_errors(copies(-1, 2, 5), reference, scales);
    EXPECT_NEAR(errors[0], 0.5 / 10, 1e-15);
    for (std::size_t i = 1; i < errors.size(); ++i) EXPECT_EQ(errors[i], 0.0);
    // 5 % to 95 % of an even spread from -1 to 1 is 1.8; half of it 0.9.
    EXPECT_NEAR(ensemble_spread(reference, scales)[0], 0.9 / 10, 1e-12);
}

TEST(SceneErrors, TheChanceShrinksWithTheRootOfTheCopies) {
    const Scales scales{.length_m = 1, .energy_J = 1, .body_size_m = 1};
    // Both spread over the same quantiles, so only their number differs.
    std::vector<Trace> few = copies(0, 1, 21);
    std::vector<Trace> many;
    for (int i = 0; i < 4; ++i) many.insert(many.end(), few.begin(), few.end());
    EXPECT_NEAR(ensemble_chance(few, scales)[0] / ensemble_chance(many, scales)[0], 2.0, 0.05);
}

TEST(SceneErrors, AnEnsembleWithAFailedCopyHasNoNumbers) {
    const Scales scales{.length_m = 1, .energy_J = 1, .body_size_m = 1};
    std::vector<Trace> broken = copies(0, 1, 5);
    broken[2].status = RunStatus::NotFinite;
    for (const double error : ensemble_errors(broken, copies(0, 1, 5), scales))
        EXPECT_TRUE(std::isnan(error));
}

TEST(SceneErrors, AnExplosionIsFurtherOffThanAnInaccuracy) {
    const SceneAnswer reference = two_bodies();
    const Scales scales = scales_of(reference);
    Trace run = reference.traces[0];
    EXPECT_TRUE(explosion_in(run, reference.traces[0], scales).empty());
    run.moments[1].energy_J = 99 * scales.energy_J;
    EXPECT_TRUE(explosion_in(run, reference.traces[0], scales).empty());
    run.moments[1].energy_J = 101 * scales.energy_J;
    EXPECT_FALSE(explosion_in(run, reference.traces[0], scales).empty());
    run.moments[1].energy_J = 0;
    run.moments[1].bodies[0].position_m.y = 1e3;
    EXPECT_FALSE(explosion_in(run, reference.traces[0], scales).empty());
}

}  // namespace
}  // namespace plumbline::study
