// Coulomb friction of boxes: A28, A29, A34.
#include "engine/study/scenarios/scenario.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline::study {
namespace {

using physics::BodyId;

constexpr double kMu = 0.3;

/// Where a flat box of 5 m/s is after 2.5 s that was sent off at `heading_rad`.
Vec3d stop_of(double heading_rad, const Setting& setting, Course& course) {
    Rig rig(setting);
    rig.floor(kMu);
    const Vec3d forward{std::cos(heading_rad), 0, -std::sin(heading_rad)};
    const BodyId box =
        rig.box({0, 0.125, 0}, {1, 0.25, 1}, {.friction = kMu, .velocity_mps = forward * 5.0});
    course.run(rig, 2.5);
    return rig.at(box);
}

Scenario sliding_stop() {
    static const double way_m = 25 / (2 * kMu * kG_mps2);
    return {
        .id = "A28",
        .title = "A box slides to a stop",
        .set_up = "A box of 1 x 0.25 x 1 m at 5 m/s on a floor, friction 0.3; in 24 directions.",
        .reference = "v0^2 / (2 mu g) = 4.2474 m, in every direction",
        .metrics = {{"way", "4.247 m"},
                    {"furthest aside", "4.247 m"},
                    {"most less least way, of 24 directions", "4.247 m"}},
        .run = [](const Setting& setting, Course& course) -> Errors {
            const Vec3d first = stop_of(0, setting, course);
            double least = 1e9;
            double most = 0;
            double aside_m = std::abs(first.z);
            for (int i = 0; i < 24; ++i) {
                const double heading = i * kPi_d / 12;
                const Vec3d at = stop_of(heading, setting, course);
                const double along = at.x * std::cos(heading) - at.z * std::sin(heading);
                const double across = at.x * std::sin(heading) + at.z * std::cos(heading);
                aside_m = std::max(aside_m, std::abs(across));
                least = std::min(least, along);
                most = std::max(most, along);
            }
            return {first.x / way_m - 1, aside_m / way_m, (most - least) / way_m};
        },
        // Slowed by mu g at the start of every step: it falls short by v0 h / 2.
        .euler_floor = [](double step_s) { return 2.5 * step_s / way_m; },
        .knobs = {.most_hz = 240}};
}

/// A slope through the origin that goes down along +x.
struct Slope {
    Quatd turn;
    Vec3d down;
    Vec3d out;

    explicit Slope(double angle_rad)
        : turn(glm::angleAxis(-angle_rad, Vec3d{0, 0, 1})),
          down(turn * Vec3d{1, 0, 0}),
          out(turn * Vec3d{0, 1, 0}) {}
    /// A cube of 1 m on it.
    BodyId with_box(Rig& rig, double friction) const {
        rig.fixed_box(out * -1.0, {200, 2, 200}, {.friction = friction, .turn = turn});
        return rig.box(out * 0.5, {1, 1, 1}, {.friction = friction, .turn = turn});
    }
};

Scenario held_on_slope() {
    return {.id = "A29 holds",
            .title = "A box on a slope that friction holds",
            .set_up = "A cube of 1 m on a slope of tan a = 0.99 mu, mu = 0.5, for 20 s.",
            .reference = "it stays",
            .metrics = {{"way in 20 s", "its edge, 1 m"}, {"speed at 20 s", "1 m/s"}},
            .run = [](const Setting& setting, Course& course) -> Errors {
                Rig rig(setting);
                const Slope slope(std::atan(0.99 * 0.5));
                const BodyId box = slope.with_box(rig, 0.5);
                const Vec3d start = rig.at(box);
                course.run(rig, 20);
                return {glm::distance(rig.at(box), start), glm::length(rig.velocity(box))};
            },
            .knobs = {.most_hz = 240}};
}

Scenario slides_on_slope() {
    static constexpr double kSlope = 0.6;
    static const double angle = std::atan(kSlope);
    static const double gain = kG_mps2 * (std::sin(angle) - 0.5 * std::cos(angle));
    return {
        .id = "A29 slides",
        .title = "A box on a slope that friction does not hold",
        .set_up = "A cube of 1 m on a slope of tan a = 0.6, mu = 0.5, let go; 4 s.",
        .reference = "a = g (sin a - mu cos a)",
        .metrics = {{"way at 4 s", "a t^2 / 2"}, {"speed at 4 s", "a t"}},
        .run = [](const Setting& setting, Course& course) -> Errors {
            Rig rig(setting);
            const Slope slope(angle);
            const BodyId box = slope.with_box(rig, 0.5);
            const Vec3d start = rig.at(box);
            course.run(rig, 4);
            const double way = glm::dot(rig.at(box) - start, slope.down);
            return {way / (8 * gain) - 1, glm::dot(rig.velocity(box), slope.down) / (4 * gain) - 1};
        },
        .euler_floor = [](double step_s) { return step_s / 4; },
        .knobs = {.most_hz = 240},
        .theory = orders_in_step(std::nullopt, std::nullopt)};
}

/// Spin lost between 0.1 s and 0.5 s of a cube that turns on its face.
double spin_lost_radps(double turned_rad, const Setting& setting, Course& course) {
    Rig rig(setting);
    rig.floor(kMu);
    const BodyId box = rig.box({0, 0.5, 0},
                               {1, 1, 1},
                               {.friction = kMu,
                                .spin_radps = {0, 10, 0},
                                .turn = glm::angleAxis(turned_rad, Vec3d{0, 1, 0})});
    course.run(rig, 0.1);
    const double first = rig.spin(box).y;
    course.run(rig, 0.4);
    return first - rig.spin(box).y;
}

Scenario spinning_box() {
    // I = m a^2 / 6; torques of friction mu m g a times 1/sqrt 2 or 0.3825978.
    static const double corners = 0.4 * 6 * kMu * kG_mps2 / std::sqrt(2.0);
    // Mean distance from the middle of a unit square: (sqrt 2 + asinh 1) / 6.
    static const double even = 0.4 * 6 * kMu * kG_mps2 * (std::sqrt(2.0) + std::asinh(1.0)) / 6;
    return {.id = "A34",
            .title = "A cube turns on its face",
            .set_up =
                "A cube of 1 m spins at 10 rad/s on a floor, friction 0.3; spin lost between 0.1 "
                "and 0.5 s, for 12 yaws.",
            .reference =
                "rigid bodies do not say how a face presses: four corners give a torque of "
                "mu m g a / sqrt 2, even pressure (sqrt 2 + asinh 1)/6 mu m g a; what must "
                "hold is that yaw makes no difference",
            .tier = Tier::Conserved,
            .metrics = {{"most less least, of 12 yaws", "the law of four corners"},
                        {"against the law of four corners", "that law"},
                        {"against the law of even pressure", "that law"}},
            .run = [](const Setting& setting, Course& course) -> Errors {
                double least = 1e9;
                double most = -1e9;
                double sum = 0;
                for (int i = 0; i < 12; ++i) {
                    const double lost = spin_lost_radps(i * kPi_d / 24, setting, course);
                    least = std::min(least, lost);
                    most = std::max(most, lost);
                    sum += lost / 12;
                }
                return {(most - least) / corners, sum / corners - 1, sum / even - 1};
            },
            .knobs = {.most_hz = 240}};
}

}  // namespace

void add_sliding(std::vector<Scenario>& all) {
    all.push_back(sliding_stop());
    all.push_back(held_on_slope());
    all.push_back(slides_on_slope());
    all.push_back(spinning_box());
}

}  // namespace plumbline::study
