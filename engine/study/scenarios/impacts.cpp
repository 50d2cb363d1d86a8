// Bodies that hit each other or the floor: A22, A23, A24.
#include "engine/study/scenarios/scenario.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace plumbline::study {
namespace {

using physics::BodyId;

constexpr double kMeetingSpeed_mps = 2;

/// Errors of the two velocities after a blow, and of the momentum. `aside` in radii.
std::array<double, 2> blow(double mass_ratio,
                           double aside,
                           const Setting& setting,
                           Course& course) {
    static constexpr double kRadius_m = 0.1;
    static constexpr double kE = 0.7;
    Rig rig(setting, {0, 0, 0});
    const Stuff stuff{.friction = 0, .restitution = kE};
    Stuff coming = stuff;
    coming.mass_kg = mass_ratio;
    coming.velocity_mps = {kMeetingSpeed_mps, 0, 0};
    const double aside_m = aside * kRadius_m;
    const BodyId a = rig.ball({-0.5, aside_m, 0}, kRadius_m, coming);
    const BodyId b = rig.ball({0, 0, 0}, kRadius_m, stuff);
    const Vec3d momentum = rig.world.momentum_kgmps();
    course.run(rig, 0.5);

    const double up = aside_m / (2 * kRadius_m);
    const Vec3d normal{std::sqrt(1 - up * up), -up, 0};  // from a to b
    const double reduced = mass_ratio / (1 + mass_ratio);
    const Vec3d impulse = normal * ((1 + kE) * kMeetingSpeed_mps * normal.x * reduced);
    const Vec3d expected_a = Vec3d{kMeetingSpeed_mps, 0, 0} - impulse / mass_ratio;
    const double off = std::max(glm::distance(rig.velocity(a), expected_a),
                                glm::distance(rig.velocity(b), impulse));
    return {off / kMeetingSpeed_mps,
            glm::distance(rig.world.momentum_kgmps(), momentum) / glm::length(momentum)};
}

Scenario two_balls(double ratio) {
    return {
        .id = fmt::format("A22 {}:1", ratio),
        .title = "Two balls meet",
        .set_up = fmt::format("A ball of {} kg at 2 m/s meets one of 1 kg at rest, head on and one "
                              "radius aside; restitution 0.7, no friction, weightless.",
                              ratio),
        .reference = "impulse (1 + e) v_n m1 m2 / (m1 + m2) along the line of centres at contact",
        .metrics = {{"velocities, oblique", "2 m/s"},
                    {"velocities, head on", "2 m/s"},
                    {"momentum", "that at the start"}},
        .run = [=](const Setting& setting, Course& course) -> Errors {
            const auto head_on = blow(ratio, 0, setting, course);
            const auto oblique = blow(ratio, 1, setting, course);
            return {oblique[0], head_on[0], std::max(head_on[1], oblique[1])};
        }};
}

struct Spun {
    Vec3d velocity;
    Vec3d spin;
};
/// A solid ball off the floor, by rigid Coulomb friction.
Spun after_floor(const Spun& before, double radius_m, double mu, double e) {
    const Vec3d arm{0, -radius_m, 0};
    Vec3d slip = before.velocity + glm::cross(before.spin, arm);
    slip.y = 0;
    const double length = glm::length(slip);
    const double limit = mu * (1 + e) * -before.velocity.y;
    Vec3d change{0, 0, 0};  // of velocity, across
    if (length > 0) change = -slip / length * std::min(limit, length * 2 / 7);
    const double inertia = 0.4 * radius_m * radius_m;
    Spun after{before.velocity + change, before.spin + glm::cross(arm, change) / inertia};
    after.velocity.y = -e * before.velocity.y;
    return after;
}

struct Incidence {
    double along_mps;
    double topspin_radps;
    double sidespin_radps;
};
constexpr Incidence kIncidences[] = {
    {0, 8, 0}, {1, 0, 0}, {3, 0, 0}, {5, -10, 5}, {10, 20, 10}, {20, 0, 0}};
constexpr int kAzimuths = 24;

/// Errors of speed and spin, and the spread over directions, of one incidence.
std::array<double, 2> spun_off(const Incidence& incidence,
                               double mu,
                               const Setting& setting,
                               Course& course) {
    static constexpr double kRadius_m = 0.5;
    static constexpr double kE = 0.7;
    double off = 0;
    double least = 1e9;
    double most = 0;
    for (int i = 0; i < kAzimuths; ++i) {
        const double azimuth = i * 2 * kPi_d / kAzimuths;
        const Vec3d forward{std::cos(azimuth), 0, std::sin(azimuth)};
        const Vec3d axis = glm::cross(Vec3d{0, 1, 0}, forward);
        const Spun before{forward * incidence.along_mps - Vec3d{0, 5, 0},
                          axis * incidence.topspin_radps + forward * incidence.sidespin_radps};
        Rig rig(setting, {0, 0, 0});
        rig.floor(mu, kE);
        const BodyId ball = rig.ball({0, 0.9, 0},
                                     kRadius_m,
                                     {.friction = mu,
                                      .restitution = kE,
                                      .velocity_mps = before.velocity,
                                      .spin_radps = before.spin});
        course.run(rig, 0.3);
        const Spun expected = after_floor(before, kRadius_m, mu, kE);
        const double speed = glm::length(expected.velocity);
        off = std::max(off, glm::distance(rig.velocity(ball), expected.velocity) / speed);
        off = std::max(off, kRadius_m * glm::distance(rig.spin(ball), expected.spin) / speed);
        const double found = glm::length(rig.velocity(ball)) / speed;
        least = std::min(least, found);
        most = std::max(most, found);
    }
    return {off, most - least};
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
            .run = [=](const Setting& setting, Course& course) -> Errors {
                Errors worst{0, 0};
                for (const Incidence& incidence : kIncidences) {
                    const auto [off, spread] = spun_off(incidence, mu, setting, course);
                    worst[0] = std::max(worst[0], off);
                    worst[1] = std::max(worst[1], spread);
                }
                return worst;
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
                             : "one in, one out: what blows passed on from pair to pair give, "
                               "and real steel balls nearly do; rigid bodies alone do not say",
            .metrics = {{"speed of the last ball", "2 m/s"}, {"speed of the others", "2 m/s"}},
            .run = [=](const Setting& setting, Course& course) -> Errors {
                constexpr double kRadius_m = 0.1;
                Rig rig(setting, {0, 0, 0});
                for (int i = 0; i < 5; ++i) {
                    const double start_m = i == 0 ? -0.3 : 0;
                    rig.ball({start_m + i * (2 * kRadius_m + gap_m), 0, 0},
                             kRadius_m,
                             {.friction = 0,
                              .restitution = 1,
                              .velocity_mps = {i == 0 ? kMeetingSpeed_mps : 0.0, 0, 0}});
                }
                course.run(rig, 1);
                double rest = 0;
                for (std::size_t i = 0; i < 4; ++i)
                    rest = std::max(rest, glm::length(rig.velocity(rig.movers[i])));
                return {rig.velocity(rig.movers[4]).x / kMeetingSpeed_mps - 1,
                        rest / kMeetingSpeed_mps};
            }};
}

}  // namespace

void add_impacts(std::vector<Scenario>& all) {
    for (const double ratio : {1.0, 10.0, 100.0, 1000.0}) all.push_back(two_balls(ratio));
    for (const double mu : {0.1, 0.5}) all.push_back(spinning_ball(mu));
    for (const double gap_m : {0.0, 0.001}) all.push_back(cradle(gap_m));
}

}  // namespace plumbline::study
