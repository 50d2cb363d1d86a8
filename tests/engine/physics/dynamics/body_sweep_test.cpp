// Nothing fast is ever seen on the other side.
#include "engine/physics/dynamics/body_sweep.h"

#include "tests/engine/physics/test_world.h"

#include <cmath>
#include <deque>

namespace plumbline::physics {
namespace {

WorldDef at_rate(double hz, const Vec3& gravity_mps2 = {0, 0, 0}) {
    WorldDef def = in_small_steps(2);
    def.substeps_max = 16;
    def.step_s = 1 / hz;
    def.gravity_mps2 = gravity_mps2;
    return def;
}

TEST(BodySweep, PlatesAt300MpsStopAtAWallOfTwoCentimetres) {
    for (const double hz : {30.0, 60.0, 240.0}) {
        TestWorld test(at_rate(hz));
        test.add(BoxShape{{0.02_r, 20, 60}}, {0, 0, 0}, {.kind = BodyKind::Static});
        std::vector<BodyId> plates;
        for (int i = 0; i < 25; ++i) {
            const auto k = static_cast<Real>(i);
            plates.push_back(test.add(BoxShape{{0.02_r, 0.4_r, 0.4_r}},
                                      {-6 - k * 0.21_r, 0, -24 + 2 * k},
                                      {.kind = BodyKind::Dynamic,
                                       .velocity_mps = {300, 0, 0},
                                       .angular_velocity_radps = {0, 10 + k, 5}}));
        }
        test.run(0.3);
        for (const BodyId plate : plates) EXPECT_LT(test.at(plate).x, 0) << hz;
    }
}

TEST(BodySweep, ARodWhoseTipHasAHundredMpsIsHeldByAPost) {
    for (const double hz : {60.0, 240.0}) {
        for (int i = 0; i < 6; ++i) {
            TestWorld test(at_rate(hz));
            const double angle = 0.3 + 0.1 * i;
            const Vec3 place{static_cast<Real>(1.5 * std::cos(angle)),
                             0,
                             static_cast<Real>(-1.5 * std::sin(angle))};
            test.add(BoxShape{{0.1_r, 4, 0.1_r}}, place, {.kind = BodyKind::Static});
            const BodyId rod =
                test.add(BoxShape{{4, 0.04_r, 0.04_r}},
                         {0, 0, 0},
                         {.kind = BodyKind::Dynamic, .angular_velocity_radps = {0, 50, 0}});
            test.run(0.1);
            EXPECT_LT(test.spin(rod).y, 45) << hz << " Hz, post " << i;
        }
    }
}

TEST(BodySweep, ABallBetweenClosingPlatesStaysBetweenThem) {
    TestWorld test(at_rate(60));
    const BodyId ball = test.add(SphereShape{0.1_r}, {0, 0, 0});
    const BodyId low =
        test.add(BoxShape{{2, 0.05_r, 2}},
                 {0, -2, 0},
                 {.kind = BodyKind::Dynamic, .mass_kg = 5, .velocity_mps = {0, 40, 0}});
    const BodyId high =
        test.add(BoxShape{{2, 0.05_r, 2}},
                 {0, 2, 0},
                 {.kind = BodyKind::Dynamic, .mass_kg = 5, .velocity_mps = {0, -40, 0}});
    for (int i = 0; i < 60; ++i) {
        test.world.step();
        EXPECT_LT(test.at(low).y, test.at(ball).y);
        EXPECT_GT(test.at(high).y, test.at(ball).y);
    }
}

TEST(BodySweep, WhatSlidesFastOverAFloorKeepsItsSpeed) {
    TestWorld test(at_rate(60, {0, -9.81_r, 0}));
    test.add(BoxShape{{400, 1, 400}}, {0, -0.5_r, 0}, {.kind = BodyKind::Static, .friction = 0});
    const BodyId plate = test.add(
        BoxShape{{0.4_r, 0.02_r, 0.4_r}},
        {-100, 0.01_r, 0},
        {.kind = BodyKind::Dynamic, .velocity_mps = {50, 0, 0}, .friction = 0, .can_sleep = false});
    test.run(2);
    EXPECT_NEAR(test.at(plate).x, 0, 0.1);
    EXPECT_NEAR(test.velocity(plate).x, 50, 1e-3);
}

TEST(BodySweep, ABounceAfterASweepHasItsWholeSpeed) {
    TestWorld test(at_rate(60));
    test.add(BoxShape{{0.1_r, 10, 10}}, {0, 0, 0}, {.kind = BodyKind::Static, .restitution = 1});
    const BodyId box =
        test.add(BoxShape{{0.2_r, 0.2_r, 0.2_r}},
                 {-5, 0, 0},
                 {.kind = BodyKind::Dynamic, .velocity_mps = {100, 0, 0}, .restitution = 1});
    test.run(0.2);
    EXPECT_NEAR(test.velocity(box).x, -100, 1);
}

/// Balls on a line, 5 cm in radius: when they meet is their gap over their closing speed.
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
