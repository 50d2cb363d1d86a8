// Coulomb friction of boxes: A28, A29, A34.
#include "engine/study/scenarios/families/sliding.h"

#include <algorithm>
#include <cmath>

namespace plumbline::study {

using physics::BodyId;

namespace {

constexpr double kMu = 0.3;
constexpr double kSpeed_mps = 5;

}  // namespace

double sliding_way_m() {
    return kSpeed_mps * kSpeed_mps / (2 * kMu * kG_mps2);
}

Vec3d sliding_stop_m(const SlidingBox& box, Stepper& stepper) {
    ScenarioWorld world(stepper.setting());
    world.floor(kMu);
    const Vec3d forward{std::cos(box.heading_rad), 0, -std::sin(box.heading_rad)};
    const BodyId body = world.box({0, box.height_m / 2, 0},
                                  {1, box.height_m, 1},
                                  {.friction = kMu,
                                   .velocity_mps = forward * kSpeed_mps,
                                   .turn = glm::angleAxis(box.turned_rad, Vec3d{0, 1, 0})});
    stepper.run(world, 2.5);
    return world.at(body);
}

Slope::Slope(double angle_rad)
    : turn(glm::angleAxis(-angle_rad, Vec3d{0, 0, 1})),
      down(turn * Vec3d{1, 0, 0}),
      out(turn * Vec3d{0, 1, 0}) {}

void Slope::add_to(ScenarioWorld& world, double friction) const {
    world.fixed_box(out * -1.0, {200, 2, 200}, {.friction = friction, .turn = turn});
}

BoxOnSlope::BoxOnSlope(const Setting& setting, double at_rad, double friction)
    : angle_rad(at_rad), mu(friction), slope(at_rad), world(setting) {
    slope.add_to(world, mu);
    box = world.box(slope.out * 0.5, {1, 1, 1}, {.friction = mu, .turn = slope.turn});
    start_m = world.at(box);
}

double BoxOnSlope::gain_mps2() const {
    return kG_mps2 * (std::sin(angle_rad) - mu * std::cos(angle_rad));
}
double BoxOnSlope::down_m() const {
    return glm::dot(world.at(box) - start_m, slope.down);
}
double BoxOnSlope::down_mps() const {
    return glm::dot(world.velocity(box), slope.down);
}
double BoxOnSlope::moved_m() const {
    const Vec3d moved = world.at(box) - start_m;
    return glm::length(moved - slope.out * glm::dot(moved, slope.out));
}

SpinningBox::SpinningBox(const Setting& setting, double turned_rad) : world(setting) {
    world.floor(kMu);
    box = world.box({0, 0.5, 0},
                    {1, 1, 1},
                    {.friction = kMu,
                     .spin_radps = {0, 10, 0},
                     .turn = glm::angleAxis(turned_rad, Vec3d{0, 1, 0})});
}

double four_corners_radps2() {
    // I = m a^2 / 6; the torque of friction is mu m g a / sqrt 2.
    return 6 * kMu * kG_mps2 / std::sqrt(2.0);
}

double even_pressure_radps2() {
    // Mean distance from the middle of a unit square: (sqrt 2 + asinh 1) / 6.
    return 6 * kMu * kG_mps2 * (std::sqrt(2.0) + std::asinh(1.0)) / 6;
}

namespace {

Scenario sliding_stop() {
    static const double path_m = sliding_way_m();
    return {
        .id = "A28",
        .title = "A box slides to a stop",
        .set_up = "A box of 1 x 0.25 x 1 m at 5 m/s on a floor, friction 0.3; in 24 directions.",
        .reference = "v0^2 / (2 mu g) = 4.2474 m, in every direction",
        .metrics = {{"path", "4.247 m"},
                    {"furthest aside", "4.247 m"},
                    {"most less least path, of 24 directions", "4.247 m"}},
        .run = [](Stepper& stepper) -> Errors {
            const Vec3d first = sliding_stop_m({}, stepper);
            double least = 1e9;
            double most = 0;
            double aside_m = std::abs(first.z);
            for (int i = 0; i < 24; ++i) {
                const double heading = i * kPi_d / 12;
                const Vec3d at = sliding_stop_m({.heading_rad = heading}, stepper);
                const double along = at.x * std::cos(heading) - at.z * std::sin(heading);
                const double across = at.x * std::sin(heading) + at.z * std::cos(heading);
                aside_m = std::max(aside_m, std::abs(across));
                least = std::min(least, along);
                most = std::max(most, along);
            }
            return {first.x / path_m - 1, aside_m / path_m, (most - least) / path_m};
        },
        // Slowed by mu g at the start of every step: it falls short by v0 h / 2.
        .euler_floor = [](double step_s) { return 2.5 * step_s / path_m; },
        .knobs = {.most_hz = 240}};
}

Scenario held_on_slope() {
    return {.id = "A29 holds",
            .title = "A box on a slope that friction holds",
            .set_up = "A cube of 1 m on a slope of tan a = 0.99 mu, mu = 0.5, for 20 s.",
            .reference = "it stays",
            .metrics = {{"path in 20 s", "its edge, 1 m"}, {"speed at 20 s", "1 m/s"}},
            .run = [](Stepper& stepper) -> Errors {
                BoxOnSlope held(stepper.setting(), std::atan(0.99 * 0.5), 0.5);
                stepper.run(held.world, 20);
                return {glm::distance(held.world.at(held.box), held.start_m),
                        glm::length(held.world.velocity(held.box))};
            },
            .knobs = {.most_hz = 240}};
}

Scenario slides_on_slope() {
    static constexpr double kSlope = 0.6;
    return {.id = "A29 slides",
            .title = "A box on a slope that friction does not hold",
            .set_up = "A cube of 1 m on a slope of tan a = 0.6, mu = 0.5, let go; 4 s.",
            .reference = "a = g (sin a - mu cos a)",
            .metrics = {{"path at 4 s", "a t^2 / 2"}, {"speed at 4 s", "a t"}},
            .run = [](Stepper& stepper) -> Errors {
                BoxOnSlope slides(stepper.setting(), std::atan(kSlope), 0.5);
                stepper.run(slides.world, 4);
                const double gain = slides.gain_mps2();
                return {slides.down_m() / (8 * gain) - 1, slides.down_mps() / (4 * gain) - 1};
            },
            .euler_floor = [](double step_s) { return step_s / 4; },
            .knobs = {.most_hz = 240},
            .theory = orders_in_step(std::nullopt, std::nullopt)};
}

/// Spin lost between 0.1 s and 0.5 s.
double spin_lost_radps(double turned_rad, Stepper& stepper) {
    SpinningBox spins(stepper.setting(), turned_rad);
    stepper.run(spins.world, 0.1);
    const double first = spins.spin_radps();
    stepper.run(spins.world, 0.4);
    return first - spins.spin_radps();
}

Scenario spinning_box() {
    static const double corners = 0.4 * four_corners_radps2();
    static const double even = 0.4 * even_pressure_radps2();
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
            .run = [](Stepper& stepper) -> Errors {
                double least = 1e9;
                double most = -1e9;
                double sum = 0;
                for (int i = 0; i < 12; ++i) {
                    const double lost = spin_lost_radps(i * kPi_d / 24, stepper);
                    least = std::min(least, lost);
                    most = std::max(most, lost);
                    sum += lost / 12;
                }
                return {(most - least) / corners, sum / corners - 1, sum / even - 1};
            },
            .knobs = {.most_hz = 240}};
}

}  // namespace

std::vector<Scenario> sliding_family() {
    return {sliding_stop(), held_on_slope(), slides_on_slope(), spinning_box()};
}

}  // namespace plumbline::study
