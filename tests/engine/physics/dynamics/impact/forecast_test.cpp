// Balls on a line, 5 cm in radius: when they meet is their gap over their closing speed.
#include "engine/physics/dynamics/impact/forecast.h"

#include <gtest/gtest.h>

#include <deque>

namespace plumbline::physics {
namespace {

constexpr double kForecastStep_s = 1.0 / 60;
constexpr Real kBallRadius_m = 0.05_r;
/// Touching begins at a fiftieth of half a radius, and a grazing impact lies three hundredths beyond.
constexpr double kShareTolerance = 0.005;

class Line {
public:
    /// At `x_m`, moving by `moves_m` within the step. A pair with all before it.
    BodyRecord& add(Real x_m, Real moves_m) {
        BodyMotion& motion = motions_.emplace_back();
        motion.at.position_m = {x_m, 0, 0};
        motion.velocity_mps = {moves_m * 60, 0, 0};
        motion.inverse_mass = 1;
        BodyRecord& ball = balls_.emplace_back();
        ball.id = static_cast<BodyId>(static_cast<std::uint32_t>(all.size() + 1));
        ball.kind = BodyKind::Dynamic;
        ball.motion = &motion;
        ball.in_world = true;
        ball.small.awake = true;
        ball.traits.geometry = geometry_;
        ball.traits.radius_m = kBallRadius_m;
        ball.sweep.inner_radius_m = kBallRadius_m;
        for (BodyRecord& other : balls_) {
            if (&other == &ball) continue;
            Pair& pair = pairs_.emplace_back();
            pair.a = &other;
            pair.b = &ball;
            other.small.pairs.push_back({ball.id, &pair});
            ball.small.pairs.push_back({other.id, &pair});
        }
        all.push_back(&ball);
        return ball;
    }
    Forecast forecast_from(double now) const {
        Forecast forecast;
        forecast.begin({now, kForecastStep_s, true});
        return forecast;
    }

    std::vector<BodyRecord*> all;

private:
    static std::shared_ptr<BodyGeometry> ball_geometry() {
        auto geometry = std::make_shared<BodyGeometry>();
        GeometryPart& part = geometry->parts.emplace_back();
        part.shape.kind = ConvexShape::Kind::Sphere;
        part.shape.radius_m = kBallRadius_m;
        part.bounds = {Vec3d(-0.05), Vec3d(0.05)};
        return geometry;
    }

    std::shared_ptr<BodyGeometry> geometry_ = ball_geometry();
    std::deque<BodyMotion> motions_;
    std::deque<BodyRecord> balls_;
    std::deque<Pair> pairs_;
};

TEST(Forecast, WhatClosesFasterIsMetBeforeWhatIsNearer) {
    Line line;
    BodyRecord& thrown = line.add(0, 1);
    line.add(0.55_r, 0);
    BodyRecord& oncoming = line.add(0.8_r, -1);
    const PredictedImpact impact = line.forecast_from(0).first_impact(thrown);
    EXPECT_NEAR(impact.share, 0.35, kShareTolerance);
    EXPECT_EQ(impact.other, &oncoming);
    EXPECT_NEAR(line.forecast_from(0.2).first_impact(thrown).share, 0.55, kShareTolerance)
        << "where they are now is where they are after a fifth";
}

TEST(Forecast, TheNextImpactIsTheFirstOfAll) {
    Line line;
    line.add(0, 1);
    line.add(0.55_r, 0);
    line.add(0.8_r, -1);
    line.add(1.2_r, -2);
    Forecast forecast = line.forecast_from(0);
    double least = 1;
    for (const BodyRecord* ball : line.all)
        least = std::min(least, forecast.first_impact(*ball).share);
    EXPECT_NEAR(least, 0.15, kShareTolerance);
    EXPECT_EQ(line.forecast_from(0).next_impact(line.all), least);
}

TEST(Forecast, WhatHasPassedNobodyMeetsNothing) {
    Line line;
    line.add(0, -1);
    line.add(0.5_r, 1);
    EXPECT_EQ(line.forecast_from(0).next_impact(line.all), 1);
}

TEST(Forecast, OnceTheStepHasBegunOnlyTheOwnIslandIsMet) {
    Line line;
    BodyRecord& thrown = line.add(0, 1);
    BodyRecord& other = line.add(0.55_r, 0);
    other.small.island = thrown.small.island + 1;
    EXPECT_EQ(line.forecast_from(0).first_impact(thrown).other, &other);
    EXPECT_EQ(line.forecast_from(0.1).first_impact(thrown).other, nullptr);
    other.small.island = thrown.small.island;
    EXPECT_EQ(line.forecast_from(0.1).first_impact(thrown).other, &other);
}

}  // namespace
}  // namespace plumbline::physics
