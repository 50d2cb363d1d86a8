// Pendulums, a spring and a motor: A09 to A13, A18.
#include "engine/physics/totals.h"
#include "engine/study/scenarios/scenario.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline::study {
namespace {

using physics::BodyId;
using physics::JointKind;

/// Jacobi's cd(u | k), by the arithmetic-geometric mean (Abramowitz and Stegun 16.4).
double jacobi_cd(double u, double k) {
    double a[16]{1};
    double c[16]{k};
    double b = std::sqrt(1 - k * k);
    int n = 0;
    while (n < 15 && std::abs(c[n]) > 1e-16) {
        a[n + 1] = (a[n] + b) / 2;
        c[n + 1] = (a[n] - b) / 2;
        b = std::sqrt(a[n] * b);
        ++n;
    }
    double phase = std::ldexp(a[n] * u, n);
    for (int i = n; i > 0; --i) phase = (phase + std::asin(c[i] / a[i] * std::sin(phase))) / 2;
    const double sn = std::sin(phase);
    return std::cos(phase) / std::sqrt(1 - k * k * sn * sn);
}

/// Angle of a pendulum let go at `from_rad`.
double pendulum_rad(double from_rad, double length_m, double t) {
    const double k = std::sin(from_rad / 2);
    return 2 * std::asin(k * jacobi_cd(std::sqrt(kG_mps2 / length_m) * t, k));
}

/// What swings, and how it hangs.
struct Pendulum {
    double from_rad;
    double length_m;     ///< of the point pendulum that keeps its time
    double to_middle_m;  ///< from the pivot to its centre of mass
};

/// Errors: angle at the end, energy, gap, and how far off the plane it is.
Errors swing(const Pendulum& pendulum,
             JointKind kind,
             const std::function<BodyId(ScenarioWorld&, const Vec3d&, const Quatd&)>& hang,
             double seconds,
             Stepper& stepper) {
    ScenarioWorld world(stepper.setting());
    const Quatd turn = glm::angleAxis(pendulum.from_rad, Vec3d{0, 0, 1});
    const BodyId body = hang(world, turn * Vec3d{0, -pendulum.to_middle_m, 0}, turn);
    const physics::JointId pivot = world.join({.kind = kind, .a = body, .axis_world = {0, 0, 1}});
    const double start_J = world.energy_J();
    const double range_J = kG_mps2 * pendulum.to_middle_m * (1 - std::cos(pendulum.from_rad));
    double energy_off = 0;
    double gap_m = 0;
    double aside = 0;
    stepper.run(world, seconds, {.after = [&](int) {
                    energy_off = std::max(energy_off, std::abs(world.energy_J() - start_J));
                    gap_m = std::max(gap_m, world.joint(pivot).error_m);
                    aside = std::max(aside, std::abs(world.at(body).z));
                }});
    const Vec3d at = world.at(body);
    const double off =
        std::atan2(at.x, -at.y) - pendulum_rad(pendulum.from_rad, pendulum.length_m, seconds);
    return {std::remainder(off, 2 * kPi_d) / pendulum.from_rad,
            energy_off / range_J,
            gap_m / pendulum.to_middle_m,
            aside / pendulum.to_middle_m};
}

std::vector<Metric> swing_metrics(double seconds, double from_deg, std::string_view length) {
    return {{fmt::format("angle at {} s", seconds), fmt::format("{} degrees", from_deg)},
            {"largest error of energy", "the swing's"},
            {"largest gap at the pivot", std::string(length)},
            {"furthest off its plane", std::string(length)}};
}

Scenario ball_pendulum(double from_deg) {
    static constexpr double kSeconds = 10;
    static constexpr double kRadius_m = 0.05;
    const Pendulum pendulum{from_deg * kPi_d / 180, 1 + 0.4 * kRadius_m * kRadius_m, 1};
    return {.id = fmt::format("A09 {} degrees", from_deg),
            .title = "A ball on an arm swings",
            .set_up = fmt::format(
                "A ball of radius 5 cm hangs 1 m from a ball-and-socket joint and is let go at "
                "{} degrees.",
                from_deg),
            .reference = "sin(a/2) = k cd(sqrt(g/l) t, k), k = sin(a0/2), l = 1.001 m",
            .metrics = swing_metrics(kSeconds, from_deg, "the arm, 1 m"),
            .run =
                [=](Stepper& stepper) {
                    const auto hang = [](ScenarioWorld& world, const Vec3d& at, const Quatd& turn) {
                        return world.sphere(at, kRadius_m, {.turn = turn, .touches = false});
                    };
                    return swing(pendulum, JointKind::BallAndSocket, hang, kSeconds, stepper);
                },
            .theory = orders_in_step(2, std::nullopt)};
}

Scenario rod_pendulum() {
    static constexpr double kSeconds = 10;
    static constexpr double kThick_m = 0.05;
    // About one end: m (l^2 + d^2)/12 + m l^2/4, over m l/2.
    const Pendulum pendulum{kPi_d / 2, ((1 + kThick_m * kThick_m) / 12 + 0.25) / 0.5, 0.5};
    return {
        .id = "A10",
        .title = "A rod on a hinge swings",
        .set_up = "A rod of 1 m, 5 cm thick, is let go level on a hinge at its end.",
        .reference = "as A09, with l = (I + m d^2)/(m d)",
        .metrics = swing_metrics(kSeconds, 90, "half the rod"),
        .run =
            [=](Stepper& stepper) {
                const auto hang = [](ScenarioWorld& world, const Vec3d& at, const Quatd& turn) {
                    return world.box(at, {kThick_m, 1, kThick_m}, {.turn = turn, .touches = false});
                };
                return swing(pendulum, JointKind::Hinge, hang, kSeconds, stepper);
            },
        .theory = orders_in_step(2, std::nullopt)};
}

Scenario conical_pendulum() {
    static constexpr double kSeconds = 20;
    static constexpr double kCone_rad = 30 * kPi_d / 180;
    static const double around_radps = std::sqrt(kG_mps2 / std::cos(kCone_rad));
    return {
        .id = "A11",
        .title = "A ball goes round on an arm",
        .set_up =
            "A ball hangs 1 m from a ball-and-socket joint, 30 degrees out, and goes round the "
            "vertical at the rate that keeps it there.",
        .reference =
            "W^2 = g / (l cos a); turning as one with its arm, a ball's own moment of "
            "inertia changes nothing",
        .metrics = {{"place at 20 s", "the radius, 0.5 m"},
                    {"largest change of the cone's angle", "1 rad"},
                    {"angular momentum about the vertical", "that at the start"}},
        .run = [](Stepper& stepper) -> Errors {
            ScenarioWorld world(stepper.setting());
            const Vec3d spin{0, around_radps, 0};
            const Vec3d start{std::sin(kCone_rad), -std::cos(kCone_rad), 0};
            const BodyId ball = world.sphere(start,
                                             0.05,
                                             {.velocity_mps = glm::cross(spin, start),
                                              .spin_radps = spin,
                                              .turn = glm::angleAxis(kCone_rad, Vec3d{0, 0, 1}),
                                              .touches = false});
            world.join_at({0, 0, 0}, ball);
            const double start_L = angular_momentum_kgm2ps(world.physics).y;
            double cone_off = 0;
            stepper.run(world, kSeconds, {.after = [&](int) {
                            const Vec3d at = world.at(ball);
                            const double cone = std::atan2(std::hypot(at.x, at.z), -at.y);
                            cone_off = std::max(cone_off, std::abs(cone - kCone_rad));
                        }});
            const Vec3d expected = glm::angleAxis(around_radps * kSeconds, Vec3d{0, 1, 0}) * start;
            return {glm::distance(world.at(ball), expected) / 0.5,
                    cone_off,
                    angular_momentum_kgm2ps(world.physics).y / start_L - 1};
        },
        .theory = orders_in_step(2, std::nullopt)};
}

Scenario damped_spring() {
    static constexpr double kSeconds = 5;
    static constexpr double kOut_m = 0.5;
    static constexpr double kRest_m = 2;
    static constexpr double kDecay = 0.5;  // c / 2m
    static const double rate = std::sqrt(100 - kDecay * kDecay);
    return {.id = "A13",
            .title = "A damped spring",
            .set_up = "1 kg on a spring of 100 N/m with 1 N s/m, let go 0.5 m out, weightless.",
            .reference = "x = x0 exp(-t/2) (cos w t + sin w t / 2w), w = sqrt(k/m - 1/4)",
            .metrics = {{"amplitude at 5 s", "that of the formula"},
                        {"phase at 5 s", "1 rad"},
                        {"place at 5 s", "0.5 m"}},
            .run = [](Stepper& stepper) -> Errors {
                ScenarioWorld world(stepper.setting(), {0, 0, 0});
                const BodyId ball = world.sphere({kRest_m + kOut_m, 0, 0}, 0.1, {.touches = false});
                world.join({.kind = JointKind::Spring,
                            .a = ball,
                            .anchor_a_world = vec({kRest_m + kOut_m, 0, 0}),
                            .stiffness_Npm = 100,
                            .damping_Nspm = 1,
                            .rest_length_m = real(kRest_m)});
                stepper.run(world, kSeconds);
                // x = A exp(-t/2) cos(w t - p): A and p from place and speed.
                const auto parts = [](double x, double v) {
                    return glm::dvec2{x, -(v + kDecay * x) / rate};
                };
                const double place = world.at(ball).x - kRest_m;
                const glm::dvec2 found = parts(place, world.velocity(ball).x);
                const double shrunk = kOut_m * std::exp(-kDecay * kSeconds);
                const double angle = rate * kSeconds;
                const double x = shrunk * (std::cos(angle) + kDecay / rate * std::sin(angle));
                const double v = -shrunk * (rate + kDecay * kDecay / rate) * std::sin(angle);
                const glm::dvec2 expected = parts(x, v);
                const double phase =
                    std::atan2(found.y, found.x) - std::atan2(expected.y, expected.x);
                return {glm::length(found) / glm::length(expected) - 1,
                        std::remainder(phase, 2 * kPi_d),
                        (place - x) / kOut_m};
            }};
}

Scenario motor() {
    return {.id = "A18",
            .title = "A motor on a wheel",
            .set_up =
                "A hinge motor of at most 2 N m drives a wheel of 0.5 kg m^2 to 4 rad/s, which "
                "takes 1 s, and holds it.",
            .reference = "w = t M / I until the target, then the target",
            .metrics = {{"speed at 0.5 s", "the target, 4 rad/s"},
                        {"speed at 2 s", "the target"},
                        {"most above the target", "the target"}},
            .run = [](Stepper& stepper) -> Errors {
                ScenarioWorld world(stepper.setting(), {0, 0, 0});
                // m r^2 / 2 = 0.5
                const BodyId wheel =
                    world.cylinder({0, 0, 0}, 0.5, 0.2, {.mass_kg = 4, .touches = false});
                world.join({.kind = JointKind::Hinge,
                            .a = wheel,
                            .motor = physics::JointMotor{.target = 4, .max = 2}});
                double most = 0;
                const auto look = [&](int) { most = std::max(most, world.spin(wheel).y); };
                stepper.run(world, 0.5, {.after = look});
                const double half_way = world.spin(wheel).y;
                stepper.run(world, 1.5, {.after = look});
                return {(half_way - 2) / 4, (world.spin(wheel).y - 4) / 4, (most - 4) / 4};
            }};
}

}  // namespace

std::vector<Scenario> pendulums_family() {
    return {ball_pendulum(30),
            ball_pendulum(90),
            ball_pendulum(170),
            rod_pendulum(),
            conical_pendulum(),
            damped_spring(),
            motor()};
}

}  // namespace plumbline::study
