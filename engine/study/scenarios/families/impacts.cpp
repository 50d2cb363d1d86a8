// Bodies that hit each other or the floor: A22, A23, A24.
#include "engine/study/scenarios/families/impacts.h"

#include "engine/physics/totals.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace plumbline::study {

using physics::BodyId;

namespace {

constexpr double kMeetingSpeed_mps = 2;

struct Incidence {
    double along_mps;
    double topspin_radps;
    double sidespin_radps;
};
constexpr Incidence kIncidences[] = {
    {0, 8, 0}, {1, 0, 0}, {3, 0, 0}, {5, -10, 5}, {10, 20, 10}, {20, 0, 0}};
constexpr int kAzimuths = 24;

/// One incidence, from every direction.
SpinningBallErrors spun_off(const Incidence& incidence, double mu, Stepper& stepper) {
    static constexpr double kRadius_m = 0.5;
    static constexpr double kE = 0.7;
    double off = 0;
    double least = 1e9;
    double most = 0;
    for (int i = 0; i < kAzimuths; ++i) {
        const double azimuth = i * 2 * kPi_d / kAzimuths;
        const Vec3d forward{std::cos(azimuth), 0, std::sin(azimuth)};
        const Vec3d axis = glm::cross(Vec3d{0, 1, 0}, forward);
        const SpinningBall before{
            forward * incidence.along_mps - Vec3d{0, 5, 0},
            axis * incidence.topspin_radps + forward * incidence.sidespin_radps};
        ScenarioWorld world(stepper.setting(), {0, 0, 0});
        world.floor(mu, kE);
        const BodyId ball = world.sphere({0, 0.9, 0},
                                         kRadius_m,
                                         {.friction = mu,
                                          .restitution = kE,
                                          .velocity_mps = before.velocity_mps,
                                          .spin_radps = before.spin_radps});
        stepper.run(world, 0.3);
        const SpinningBall expected = after_floor(before, kRadius_m, mu, kE);
        const double speed = glm::length(expected.velocity_mps);
        off = std::max(off, glm::distance(world.velocity(ball), expected.velocity_mps) / speed);
        off =
            std::max(off, kRadius_m * glm::distance(world.spin(ball), expected.spin_radps) / speed);
        const double found = glm::length(world.velocity(ball)) / speed;
        least = std::min(least, found);
        most = std::max(most, found);
    }
    return {off, most - least};
}

}  // namespace

BallsMeetErrors balls_meet(const BallsMeet& how, Stepper& stepper) {
    static constexpr double kRadius_m = 0.1;
    static constexpr double kE = 0.7;
    ScenarioWorld world(stepper.setting(), {0, 0, 0});
    const BodyProperties properties{.friction = 0, .restitution = kE};
    BodyProperties coming = properties;
    coming.mass_kg = how.mass_ratio;
    coming.velocity_mps = {kMeetingSpeed_mps, 0, 0};
    const double aside_m = how.aside * kRadius_m;
    const BodyId a = world.sphere({-0.5, aside_m, 0}, kRadius_m, coming);
    const BodyId b = world.sphere({0, 0, 0}, kRadius_m, properties);
    const Vec3d momentum = momentum_kgmps(world.physics);
    stepper.run(world, 0.5);

    const double up = aside_m / (2 * kRadius_m);
    const Vec3d normal{std::sqrt(1 - up * up), -up, 0};  // from a to b
    const double reduced = how.mass_ratio / (1 + how.mass_ratio);
    const Vec3d impulse = normal * ((1 + kE) * kMeetingSpeed_mps * normal.x * reduced);
    const Vec3d expected_a = Vec3d{kMeetingSpeed_mps, 0, 0} - impulse / how.mass_ratio;
    const double off = std::max(glm::distance(world.velocity(a), expected_a),
                                glm::distance(world.velocity(b), impulse));
    return {off / kMeetingSpeed_mps,
            glm::distance(momentum_kgmps(world.physics), momentum) / glm::length(momentum)};
}

SpinningBall after_floor(const SpinningBall& before, double radius_m, double mu, double e) {
    const Vec3d arm{0, -radius_m, 0};
    Vec3d slip = before.velocity_mps + glm::cross(before.spin_radps, arm);
    slip.y = 0;
    const double length = glm::length(slip);
    const double limit = mu * (1 + e) * -before.velocity_mps.y;
    Vec3d change{0, 0, 0};  // of velocity, across
    if (length > 0) change = -slip / length * std::min(limit, length * 2 / 7);
    const double inertia = 0.4 * radius_m * radius_m;
    SpinningBall after{before.velocity_mps + change,
                       before.spin_radps + glm::cross(arm, change) / inertia};
    after.velocity_mps.y = -e * before.velocity_mps.y;
    return after;
}

SpinningBallErrors spinning_ball_bounces(double mu, Stepper& stepper) {
    SpinningBallErrors worst{0, 0};
    for (const Incidence& incidence : kIncidences) {
        const SpinningBallErrors off = spun_off(incidence, mu, stepper);
        worst.worst = std::max(worst.worst, off.worst);
        worst.spread = std::max(worst.spread, off.spread);
    }
    return worst;
}

CradleErrors cradle_swings(const Cradle& cradle, Stepper& stepper) {
    constexpr double kRadius_m = 0.1;
    constexpr int kBalls = 5;
    ScenarioWorld world(stepper.setting(), {0, 0, 0});
    for (int i = 0; i < kBalls; ++i) {
        const bool comes = i < cradle.coming;
        const double start_m = comes ? -0.3 : 0;
        world.sphere({start_m + i * (2 * kRadius_m + cradle.gap_m), 0, 0},
                     kRadius_m,
                     {.friction = 0,
                      .restitution = 1,
                      .velocity_mps = {comes ? kMeetingSpeed_mps : 0.0, 0, 0}});
    }
    stepper.run(world, 1);
    CradleErrors errors{0, 0};
    for (int i = 0; i < kBalls; ++i) {
        const Vec3d velocity = world.velocity(world.movers[static_cast<std::size_t>(i)]);
        if (i < kBalls - cradle.coming) {
            errors.staying = std::max(errors.staying, glm::length(velocity) / kMeetingSpeed_mps);
        } else {
            const double off = velocity.x / kMeetingSpeed_mps - 1;
            if (std::abs(off) > std::abs(errors.leaving)) errors.leaving = off;
        }
    }
    return errors;
}

namespace {

Scenario two_balls(double ratio) {
    return {
        .id = fmt::format("A22 {}:1", ratio),
        .title = "Two balls collide",
        .set_up = fmt::format("A ball of {} kg at 2 m/s meets one of 1 kg at rest, head on and one "
                              "radius aside; restitution 0.7, no friction, weightless.",
                              ratio),
        .reference = "impulse (1 + e) v_n m1 m2 / (m1 + m2) along the line of centres at contact",
        .metrics = {{"velocities, oblique", "2 m/s"},
                    {"velocities, head on", "2 m/s"},
                    {"momentum", "that at the start"}},
        .run = [=](Stepper& stepper) -> Errors {
            const auto head_on = balls_meet({.mass_ratio = ratio}, stepper);
            const auto oblique = balls_meet({.mass_ratio = ratio, .aside = 1}, stepper);
            return {
                oblique.velocity, head_on.velocity, std::max(head_on.momentum, oblique.momentum)};
        }};
}

Scenario spinning_ball(double mu) {
    return {.id = fmt::format("A23 mu={}", mu),
            .title = "A spinning ball hits the floor",
            .set_up =
                fmt::format("A ball comes down at 5 m/s with six mixtures of speed and spin in 24 "
                            "directions; restitution 0.7, friction {}, weightless.",
                            mu),
            .reference = "rigid Coulomb impact: sticks if mu (1 + e) v_n >= 2/7 of the slip",
            .metrics = {{"velocity and spin, worst", "the speed after"},
                        {"spread over directions, worst", "the speed after"}},
            .run = [=](Stepper& stepper) -> Errors {
                const auto [worst, spread] = spinning_ball_bounces(mu, stepper);
                return {worst, spread};
            },
            .knobs = {.most_hz = 240}};
}

Scenario cradle(double gap_m) {
    return {.id = fmt::format("A24 gap={}", gap_m),
            .title = "Newton's cradle",
            .set_up =
                fmt::format("Four balls in a row, {} m apart; a fifth comes at 2 m/s. Restitution "
                            "1, weightless.",
                            gap_m),
            .reference = gap_m > 0
                             ? "pair after pair: one in, one out"
                             : "one in, one out: what impacts passed on from pair to pair give, "
                               "and real steel balls nearly do; rigid bodies alone do not say",
            .metrics = {{"speed of the last ball", "2 m/s"}, {"speed of the others", "2 m/s"}},
            .run = [=](Stepper& stepper) -> Errors {
                const auto [leaving, staying] = cradle_swings({.gap_m = gap_m}, stepper);
                return {leaving, staying};
            }};
}

}  // namespace

std::vector<Scenario> impacts_family() {
    return {two_balls(1),
            two_balls(10),
            two_balls(100),
            two_balls(1000),
            spinning_ball(0.1),
            spinning_ball(0.5),
            cradle(0),
            cradle(0.001)};
}

}  // namespace plumbline::study
