// The laws that scenarios and rows are held against, by numbers found elsewhere: published, or
// worked out another way.
#include "engine/study/scenarios/families/bounces.h"
#include "engine/study/scenarios/families/flight.h"
#include "engine/study/scenarios/families/impacts.h"
#include "engine/study/scenarios/families/rolling.h"
#include "engine/study/scenarios/families/sliding.h"
#include "engine/study/scenarios/families/supports.h"
#include "engine/study/scenarios/families/tops.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::study {
namespace {

TEST(Laws, A01AThrownBodyIsOnItsParabola) {
    // By the sums of its own speed: 2 s in a million mid-point steps.
    constexpr int kSteps = 1'000'000;
    constexpr double kStep_s = 2.0 / kSteps;
    double y_m = 0;
    for (int i = 0; i < kSteps; ++i) y_m += (10 - kG_mps2 * (i + 0.5) * kStep_s) * kStep_s;
    const Vec3d at = thrown_m({1, 0, 2}, {3, 10, 0}, 2);
    EXPECT_DOUBLE_EQ(at.x, 7);
    EXPECT_NEAR(at.y, y_m, 1e-8);
    EXPECT_DOUBLE_EQ(at.z, 2);
}

TEST(Laws, A05ABoxOfThreeLengthsTurnsAsFourthOrderStepsSay) {
    const Vec3d inertia = Vec3d{13, 10, 5} / 12.0;
    const Vec3d start = box_of_three_lengths().spin_radps;
    // Classic Runge-Kutta, which neither of the two integrators is.
    const auto change = [&](const Vec3d& w) { return glm::cross(inertia * w, w) / inertia; };
    constexpr double kStep_s = 1e-4;
    Vec3d w = start;
    for (int i = 0; i < 100'000; ++i) {
        const Vec3d a = change(w);
        const Vec3d b = change(w + a * (kStep_s / 2));
        const Vec3d c = change(w + b * (kStep_s / 2));
        const Vec3d d = change(w + c * kStep_s);
        w += (a + 2.0 * b + 2.0 * c + d) * (kStep_s / 6);
    }
    const TurningBody found = turned_for({.own_spin_radps = start}, inertia, 10);
    EXPECT_LT(glm::distance(found.own_spin_radps, w), 1e-9);
    EXPECT_NEAR(found.own_spin_radps.x, 1.035165, 1e-6);
    EXPECT_NEAR(found.own_spin_radps.y, 4.771933, 1e-6);
    // The momentum stays where it is in the world.
    const Vec3d momentum = found.turn * (inertia * found.own_spin_radps);
    EXPECT_LT(glm::distance(momentum, inertia * start), 1e-9);
}

TEST(Laws, A06ADiscPrecessesAsEulersEquationsSay) {
    const Precession law = disc_precession();
    const TurningBody after = turned_for(
        {.own_spin_radps = wobbling_disc().spin_radps}, {0.76 / 12, 0.125, 0.76 / 12}, 3);
    EXPECT_LT(glm::distance(law.axis_at(3), after.turn * Vec3d{0, 1, 0}), 1e-9);
    EXPECT_NEAR(law.cone_rad(), std::acos(glm::dot(law.axis_at(3), law.about())), 1e-12);
}

TEST(Laws, A20ApexesAreHalfWayBetweenContacts) {
    const Drop drop{.height_m = 5, .e = 0.8};
    for (int n = 1; n <= 4; ++n) {
        const double flight_s = drop.contact_s(n + 1) - drop.contact_s(n);
        EXPECT_NEAR(drop.apex_m(n), kG_mps2 * flight_s * flight_s / 8, 1e-12) << n;
    }
    EXPECT_NEAR(drop.contact_s(1), std::sqrt(10 / 9.81), 1e-12);
}

TEST(Laws, A21TheLastFlightsAddUpToTheSeries) {
    for (const double e : {0.5, 0.8}) {
        const BouncingEnd end = bouncing_end(e);
        const Drop drop{.height_m = 1, .e = e};
        EXPECT_GT(drop.apex_m(end.flights), 1e-3);
        EXPECT_LT(drop.apex_m(end.flights + 1), 1e-3);
        const double series_s = e == 0.5 ? 1.3545709 : 4.0637128;
        const double left_s = 2 * std::sqrt(2 / kG_mps2) * std::pow(e, end.flights + 1) / (1 - e);
        EXPECT_NEAR(end.expected_s + left_s, series_s, 1e-6);
    }
}

TEST(Laws, A23ABallOffTheFloorSlipsOrSticks) {
    // mu = 0.1 is not enough to stop a slip of 3 m/s: 3 - 0.1 x 1.7 x 5 = 2.15 m/s.
    const SpinningBall slips = after_floor({{3, -5, 0}, {0, 0, 0}}, 0.5, 0.1, 0.7);
    EXPECT_NEAR(slips.velocity_mps.x, 2.15, 1e-12);
    EXPECT_NEAR(slips.velocity_mps.y, 3.5, 1e-12);
    // mu = 0.5 is: it leaves rolling, and its momentum about the point of contact is what it was.
    const SpinningBall sticks = after_floor({{3, -5, 0}, {0, 0, 2}}, 0.5, 0.5, 0.7);
    EXPECT_NEAR(sticks.velocity_mps.x, -0.5 * sticks.spin_radps.z, 1e-12);
    const double before = 0.4 * 0.25 * 2 - 0.5 * 3;
    EXPECT_NEAR(0.4 * 0.25 * sticks.spin_radps.z - 0.5 * sticks.velocity_mps.x, before, 1e-12);
}

TEST(Laws, A28AndA29FrictionStopsAndHolds) {
    EXPECT_NEAR(sliding_way_m(), 4.2473667, 1e-7);
    EXPECT_NEAR(BoxOnSlope({}, std::atan(0.5), 0.5).gain_mps2(), 0, 1e-12);
    EXPECT_NEAR(BoxOnSlope({}, std::atan(0.75), 0).gain_mps2(), 0.6 * 9.81, 1e-12);
}

TEST(Laws, A30ABallRollsAfterTheTimeOfTheCatalogue) {
    const SlideToRoll law{.speed_mps = 5, .mu = 0.2};
    EXPECT_NEAR(law.rolls_at_s(), 0.7281200, 1e-7);
    EXPECT_NEAR(law.rolling_mps(), 3.5714286, 1e-7);
    EXPECT_NEAR(law.path_m(law.rolls_at_s()), 3.1205143, 1e-7);
    EXPECT_NEAR(law.path_m(3), 3.1205143 + 3.5714286 * (3 - 0.7281200), 1e-6);
    EXPECT_NEAR(law.speed_at_mps(law.rolls_at_s()), law.rolling_mps(), 1e-12);
}

TEST(Laws, A32ABallOnATurntableComesBackAfterItsPeriod) {
    const Vec3d start = BallOnTurntable::expected_m(0);
    EXPECT_LT(glm::distance(BallOnTurntable::expected_m(7.3303829), start), 1e-6);
    EXPECT_GT(glm::distance(BallOnTurntable::expected_m(7.3303829 / 2), start), 3.99);
}

TEST(Laws, A34FourCornersHoldMoreThanAFace) {
    // Mean distance from the middle of a unit square, by its points.
    double sum = 0;
    constexpr int kSide = 1000;
    for (int i = 0; i < kSide; ++i) {
        for (int k = 0; k < kSide; ++k)
            sum += std::hypot((i + 0.5) / kSide - 0.5, (k + 0.5) / kSide - 0.5);
    }
    const double mean_m = sum / kSide / kSide;
    EXPECT_NEAR(even_pressure_radps2(), 0.3 * 9.81 * mean_m * 6, 1e-5);
    EXPECT_NEAR(four_corners_radps2(), 0.3 * 9.81 * std::hypot(0.5, 0.5) * 6, 1e-12);
}

TEST(Laws, A35FourBallsNeedTheFrictionOfTheCatalogue) {
    EXPECT_NEAR(four_balls_mu(), 0.3178372, 1e-7);
    EXPECT_NEAR(four_balls_floor_mu(), 0.0794593, 1e-7);
    EXPECT_NEAR(threshold_of(0, 8, 40, [](double x) { return x * x > 2; }), std::sqrt(2.0), 1e-9);
}

}  // namespace
}  // namespace plumbline::study
