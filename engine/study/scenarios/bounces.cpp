// Bodies that fall on the floor and leave it again: A20, A21, A25, A26.
#include "engine/core/random.h"
#include "engine/study/scenarios/scenario.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline::study {
namespace {

using physics::BodyId;

constexpr double kCoarsest_s = 1.0 / 30;

/// Height that a body would reach from where it is, by its energy.
double reach_m(const Rig& rig, BodyId body, double to_middle_m) {
    const double speed = rig.velocity(body).y;
    return rig.at(body).y - to_middle_m + speed * speed / (2 * kG_mps2);
}

/// The instant of the n-th contact of a body dropped from `height_m`; n from 1.
double contact_s(double height_m, double e, int n) {
    const double first = std::sqrt(2 * height_m / kG_mps2);
    double total = first;
    for (int i = 1; i < n; ++i) total += 2 * first * std::pow(e, i);
    return total;
}

/// A moment of the n-th flight that every step of the study divides, nearest to its middle; none
/// where the flight is shorter than the coarsest step.
std::optional<double> moment_of_flight_s(double height_m, double e, int n) {
    const double from_s = contact_s(height_m, e, n);
    const double to_s = contact_s(height_m, e, n + 1);
    const double moment = std::round((from_s + to_s) / 2 / kCoarsest_s) * kCoarsest_s;
    const bool inside = moment > from_s + 1e-3 && moment < to_s - 1e-3;
    return inside ? std::optional<double>(moment) : std::nullopt;
}

struct Drop {
    double height_m;
    double e;
    bool box;
};

Scenario dropped(const Drop& drop) {
    std::vector<double> moments_s;
    std::vector<Metric> metrics;
    for (int n = 1; n <= (drop.box ? 1 : 4); ++n) {
        const std::optional<double> moment = moment_of_flight_s(drop.height_m, drop.e, n);
        if (!moment) break;
        moments_s.push_back(*moment);
        metrics.push_back(
            {fmt::format("height of apex {}", n),
             fmt::format("e^{} H, {:.4g} m", 2 * n, std::pow(drop.e, 2 * n) * drop.height_m)});
    }
    return {.id = drop.box ? fmt::format("A20 box e={}", drop.e)
                           : fmt::format("A20 H={} e={}", drop.height_m, drop.e),
            .title = drop.box ? "A box falls flat and bounces" : "A ball falls and bounces",
            .set_up = fmt::format("A {} falls {} m on a floor; restitution {}.",
                                  drop.box ? "cube of 1 m" : "ball of radius 0.1 m",
                                  drop.height_m,
                                  drop.e),
            .reference =
                "apex n = e^(2n) H; read off place and speed at a moment of the flight that "
                "every step divides",
            .metrics = metrics,
            .run = [=](const Setting& setting, Course& course) -> Errors {
                Rig rig(setting);
                rig.floor(0, drop.e);
                const Stuff stuff{.friction = 0, .restitution = drop.e};
                const double middle_m = drop.box ? 0.5 : 0.1;
                const Vec3d at{0, middle_m + drop.height_m, 0};
                const BodyId body =
                    drop.box ? rig.box(at, {1, 1, 1}, stuff) : rig.ball(at, middle_m, stuff);
                Errors errors;
                double now_s = 0;
                for (const double moment_s : moments_s) {
                    course.run(rig, moment_s - now_s);
                    now_s = moment_s;
                    const double apex_m =
                        std::pow(drop.e, 2.0 * static_cast<double>(errors.size() + 1)) *
                        drop.height_m;
                    errors.push_back(reach_m(rig, body, middle_m) / apex_m - 1);
                }
                return errors;
            }};
}

Scenario end_of_bouncing(double e) {
    static constexpr double kSmall_m = 1e-3;
    int flights = 0;  // that reach 1 mm
    while (std::pow(e, 2 * (flights + 1)) > kSmall_m) ++flights;
    const double expected_s = contact_s(1, e, flights + 1);
    const double longest_s = std::ceil(expected_s * 1.5);
    return {
        .id = fmt::format("A21 e={}", e),
        .title = "Bouncing ends",
        .set_up = fmt::format("A ball falls 1 m; restitution {}. When does its height no longer "
                              "reach 1 mm?",
                              e),
        .reference = fmt::format("the {}th contact, by the geometric series: {:.4f} s. A step "
                                 "tells it no better than to its own length",
                                 flights + 1,
                                 expected_s),
        .metrics = {{"last moment with 1 mm to go", "the time itself"}},
        .run = [=](const Setting& setting, Course& course) -> Errors {
            Rig rig(setting);
            rig.floor(0, e);
            const BodyId ball = rig.ball({0, 1.1, 0}, 0.1, {.friction = 0, .restitution = e});
            double last_s = 0;
            course.run(rig, longest_s, {.after = [&](int i) {
                           if (reach_m(rig, ball, 0.1) > kSmall_m) last_s = (i + 1) * rig.step_s();
                       }});
            return {last_s / expected_s - 1};
        }};
}

/// Root mean square over the steps of the energy's error, as a share of `range_J`.
double energy_rms(Rig& rig, Course& course, double seconds, double range_J) {
    const double start_J = rig.energy_J();
    double sum = 0;
    int count = 0;
    course.run(rig, seconds, {.after = [&](int) {
                   const double off = (rig.energy_J() - start_J) / range_J;
                   sum += off * off;
                   ++count;
               }});
    return std::sqrt(sum / std::max(1, count));
}

Scenario elastic_balls() {
    static constexpr double kHeight_m = 5;
    return {.id = "A25",
            .title = "49 balls bounce for 20 s",
            .set_up =
                "7 x 7 balls of radius 0.1 m and 10 kg fall 5 m on a floor; restitution 1 "
                "(SimBenchmark's bouncing).",
            .reference = "energy is kept",
            .tier = Tier::Conserved,
            .metrics = {{"energy, rms over the steps", "m g H of all balls"}},
            .run = [](const Setting& setting, Course& course) -> Errors {
                Rig rig(setting);
                rig.floor(0.5, 1);
                for (int i = 0; i < 49; ++i)
                    rig.ball({0.5 * (i % 7), 0.1 + kHeight_m, 0.5 * static_cast<double>(i / 7)},
                             0.1,
                             {.mass_kg = 10, .restitution = 1});
                return {energy_rms(rig, course, 20, 49 * 10 * kG_mps2 * kHeight_m)};
            },
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
            .run = [](const Setting& setting, Course& course) -> Errors {
                Rig rig(setting);
                rig.floor(0, 1);
                Random random(666);
                const auto off = [&] { return static_cast<double>(random.uniform(0, 1e-3F)); };
                for (int i = 0; i < 216; ++i) {
                    const Vec3d place{i % 6, (i / 6) % 6, static_cast<double>(i / 36)};
                    rig.ball(place * 0.21 + Vec3d{off() - 0.525, off() + 1.1, off() - 0.525},
                             0.1,
                             {.mass_kg = 10, .friction = 0, .restitution = 1});
                }
                return {energy_rms(rig, course, 4, 216 * 10 * kG_mps2)};
            },
            .knobs = {.substeps = false, .iterations = false, .most_hz = 240}};
}

}  // namespace

void add_bounces(std::vector<Scenario>& all) {
    for (const double e : {0.3, 0.5, 0.8, 1.0})
        all.push_back(dropped({.height_m = 1, .e = e, .box = false}));
    all.push_back(dropped({.height_m = 5, .e = 0.8, .box = false}));
    for (const double e : {0.5, 1.0}) all.push_back(dropped({.height_m = 2, .e = e, .box = true}));
    for (const double e : {0.5, 0.8}) all.push_back(end_of_bouncing(e));
    all.push_back(elastic_balls());
    all.push_back(elastic_grid());
}

}  // namespace plumbline::study
