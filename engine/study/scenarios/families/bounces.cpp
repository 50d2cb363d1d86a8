// Bodies that fall on the floor and leave it again: A20, A21, A25, A26.
#include "engine/study/scenarios/families/bounces.h"

#include "engine/core/random.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline::study {

using physics::BodyId;

double Drop::contact_s(int n) const {
    const double first = std::sqrt(2 * height_m / kG_mps2);
    double total = first;
    for (int i = 1; i < n; ++i) total += 2 * first * std::pow(e, i);
    return total;
}

double Drop::apex_m(int n) const {
    return std::pow(e, 2 * n) * height_m;
}

DroppedBody::DroppedBody(const Setting& setting, const Drop& from) : drop(from), world(setting) {
    world.floor(0, drop.e);
    const BodyProperties properties{.friction = 0, .restitution = drop.e};
    const Vec3d at{0, drop.to_middle_m() + drop.height_m, 0};
    body = drop.shape == Drop::Shape::Cube ? world.box(at, {1, 1, 1}, properties)
                                           : world.sphere(at, drop.radius_m, properties);
}

double DroppedBody::reach_m() const {
    const double speed = world.velocity(body).y;
    return height_m() + speed * speed / (2 * kG_mps2);
}

namespace {

constexpr double kLeastSeen_m = 1e-3;

/// Root mean square over the steps of the energy's error, as a share of `range_J`.
double energy_rms(ScenarioWorld& world, Stepper& stepper, double seconds, double range_J) {
    const double start_J = world.energy_J();
    double sum = 0;
    int count = 0;
    stepper.run(world, seconds, {.after = [&](int) {
                    const double off = (world.energy_J() - start_J) / range_J;
                    sum += off * off;
                    ++count;
                }});
    return std::sqrt(sum / std::max(1, count));
}

}  // namespace

BouncingEnd bouncing_end(double e) {
    int flights = 0;
    while (std::pow(e, 2 * (flights + 1)) > kLeastSeen_m) ++flights;
    return {flights, Drop{.height_m = 1, .e = e}.contact_s(flights + 1)};
}

double bouncing_end_found_s(double e, Stepper& stepper) {
    DroppedBody dropped(stepper.setting(), {.height_m = 1, .e = e});
    const double longest_s = std::ceil(bouncing_end(e).expected_s * 1.5);
    double last_s = 0;
    stepper.run(dropped.world, longest_s, {.after = [&](int i) {
                    if (dropped.reach_m() > kLeastSeen_m) last_s = (i + 1) * dropped.world.step_s();
                }});
    return last_s;
}

double elastic_balls_energy_rms(Stepper& stepper) {
    constexpr double kHeight_m = 5;
    ScenarioWorld world(stepper.setting());
    world.floor(0.5, 1);
    for (int i = 0; i < 49; ++i)
        world.sphere({0.5 * (i % 7), 0.1 + kHeight_m, 0.5 * static_cast<double>(i / 7)},
                     0.1,
                     {.mass_kg = 10, .restitution = 1});
    return energy_rms(world, stepper, 20, 49 * 10 * kG_mps2 * kHeight_m);
}

namespace {

constexpr double kCoarsest_s = 1.0 / 30;

/// A moment of the n-th flight that every step of the study divides, nearest to its middle; none
/// where the flight is shorter than the coarsest step.
std::optional<double> moment_of_flight_s(const Drop& drop, int n) {
    const double from_s = drop.contact_s(n);
    const double to_s = drop.contact_s(n + 1);
    const double moment = std::round((from_s + to_s) / 2 / kCoarsest_s) * kCoarsest_s;
    const bool inside = moment > from_s + 1e-3 && moment < to_s - 1e-3;
    return inside ? std::optional<double>(moment) : std::nullopt;
}

Scenario dropped(const Drop& drop) {
    const bool cube = drop.shape == Drop::Shape::Cube;
    std::vector<double> moments_s;
    std::vector<Metric> metrics;
    for (int n = 1; n <= (cube ? 1 : 4); ++n) {
        const std::optional<double> moment = moment_of_flight_s(drop, n);
        if (!moment) break;
        moments_s.push_back(*moment);
        metrics.push_back({fmt::format("height of apex {}", n),
                           fmt::format("e^{} H, {:.4g} m", 2 * n, drop.apex_m(n))});
    }
    return {.id = cube ? fmt::format("A20 box e={}", drop.e)
                       : fmt::format("A20 H={} e={}", drop.height_m, drop.e),
            .title = cube ? "A box falls flat and bounces" : "A ball falls and bounces",
            .set_up = fmt::format("A {} falls {} m on a floor; restitution {}.",
                                  cube ? "cube of 1 m" : "ball of radius 0.1 m",
                                  drop.height_m,
                                  drop.e),
            .reference =
                "apex n = e^(2n) H; read off place and speed at a moment of the flight that "
                "every step divides",
            .metrics = metrics,
            .run = [=](Stepper& stepper) -> Errors {
                DroppedBody falls(stepper.setting(), drop);
                Errors errors;
                double now_s = 0;
                for (const double moment_s : moments_s) {
                    stepper.run(falls.world, moment_s - now_s);
                    now_s = moment_s;
                    const int n = static_cast<int>(errors.size()) + 1;
                    errors.push_back(falls.reach_m() / drop.apex_m(n) - 1);
                }
                return errors;
            }};
}

Scenario end_of_bouncing(double e) {
    const BouncingEnd end = bouncing_end(e);
    return {
        .id = fmt::format("A21 e={}", e),
        .title = "Bouncing ends",
        .set_up = fmt::format("A ball falls 1 m; restitution {}. When does its height no longer "
                              "reach 1 mm?",
                              e),
        .reference = fmt::format("the {}th contact, by the geometric series: {:.4f} s. A step "
                                 "tells it no better than to its own length",
                                 end.flights + 1,
                                 end.expected_s),
        .metrics = {{"last moment with 1 mm to go", "the time itself"}},
        .run = [=](Stepper& stepper) -> Errors {
            return {bouncing_end_found_s(e, stepper) / end.expected_s - 1};
        }};
}

Scenario elastic_balls() {
    return {.id = "A25",
            .title = "49 balls bounce for 20 s",
            .set_up =
                "7 x 7 balls of radius 0.1 m and 10 kg fall 5 m on a floor; restitution 1 "
                "(SimBenchmark's bouncing).",
            .reference = "energy is kept",
            .tier = Tier::Conserved,
            .metrics = {{"energy, rms over the steps", "m g H of all balls"}},
            .run = [](Stepper& stepper) -> Errors { return {elastic_balls_energy_rms(stepper)}; },
            .knobs = {.most_hz = 240}};
}

Scenario elastic_grid() {
    return {.id = "A26",
            .title = "216 elastic balls",
            .set_up =
                "6 x 6 x 6 balls of radius 0.1 m and 10 kg, 1 cm apart and each up to 1 mm off "
                "its place, fall 1 m and run apart without friction; restitution 1 (after "
                "SimBenchmark's 666). 4 s.",
            .reference = "energy is kept",
            .tier = Tier::Conserved,
            .metrics = {{"energy, rms over the steps", "m g H of all balls, 21.2 kJ"}},
            .run = [](Stepper& stepper) -> Errors {
                ScenarioWorld world(stepper.setting());
                world.floor(0, 1);
                Random random(666);
                const auto off = [&] { return static_cast<double>(random.uniform(0, 1e-3F)); };
                for (int i = 0; i < 216; ++i) {
                    const Vec3d place{i % 6, (i / 6) % 6, static_cast<double>(i / 36)};
                    world.sphere(place * 0.21 + Vec3d{off() - 0.525, off() + 1.1, off() - 0.525},
                                 0.1,
                                 {.mass_kg = 10, .friction = 0, .restitution = 1});
                }
                return {energy_rms(world, stepper, 4, 216 * 10 * kG_mps2)};
            },
            .knobs = {.substeps = false, .iterations = false, .most_hz = 240}};
}

}  // namespace

std::vector<Scenario> bounces_family() {
    return {dropped({.height_m = 1, .e = 0.3}),
            dropped({.height_m = 1, .e = 0.5}),
            dropped({.height_m = 1, .e = 0.8}),
            dropped({.height_m = 1, .e = 1}),
            dropped({.height_m = 5, .e = 0.8}),
            dropped({.height_m = 2, .e = 0.5, .shape = Drop::Shape::Cube}),
            dropped({.height_m = 2, .e = 1, .shape = Drop::Shape::Cube}),
            end_of_bouncing(0.5),
            end_of_bouncing(0.8),
            elastic_balls(),
            elastic_grid()};
}

}  // namespace plumbline::study
