// Balls that roll: A30, A31, A32, A33.
#include "engine/study/scenarios/scenario.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline::study {
namespace {

using physics::BodyId;
using physics::BodyKind;

Scenario slide_to_roll() {
    static constexpr double kMu = 0.2;
    static constexpr double kSpeed_mps = 5;
    static constexpr double kSeconds = 3;
    static const double rolls_s = 2 * kSpeed_mps / (7 * kMu * kG_mps2);
    static const double way_m = kSpeed_mps * rolls_s - kMu * kG_mps2 * rolls_s * rolls_s / 2 +
                                5.0 / 7 * kSpeed_mps * (kSeconds - rolls_s);
    return {
        .id = "A30",
        .title = "A ball slides until it rolls",
        .set_up = "A ball of radius 0.5 m is sent off at 5 m/s without spin, friction 0.2.",
        .reference = "rolls after 2 v0 / (7 mu g) = 0.7281 s at 5/7 of its speed; 11.2344 m in 3 s",
        .metrics = {{"way at 3 s", "11.23 m"},
                    {"speed at 3 s", "3.571 m/s"},
                    {"slip at 3 s", "3.571 m/s"}},
        .run = [](const Setting& setting, Course& course) -> Errors {
            Rig rig(setting);
            rig.floor(kMu);
            const BodyId ball =
                rig.ball({0, 0.5, 0}, 0.5, {.friction = kMu, .velocity_mps = {kSpeed_mps, 0, 0}});
            course.run(rig, kSeconds);
            const double rolling = 5.0 / 7 * kSpeed_mps;
            const double speed = rig.velocity(ball).x;
            return {rig.at(ball).x / way_m - 1,
                    speed / rolling - 1,
                    (speed + 0.5 * rig.spin(ball).z) / rolling};
        },
        // Slowed by mu g at the start of every step while it slides, 0.73 s of 3.
        .euler_floor = [](double step_s) { return kMu * kG_mps2 * rolls_s * step_s / 2 / way_m; }};
}

/// Way in 2 s of a ball let go on a slope, against the formula, and its spin.
std::array<double, 2> down_slope(double angle,
                                 double share,
                                 const Setting& setting,
                                 Course& course) {
    const double mu = share * 2.0 / 7 * std::tan(angle);
    const Quatd turn = glm::angleAxis(-angle, Vec3d{0, 0, 1});
    const Vec3d down = turn * Vec3d{1, 0, 0};
    const Vec3d out = turn * Vec3d{0, 1, 0};
    Rig rig(setting);
    rig.fixed_box(out * -1.0, {200, 2, 200}, {.friction = mu, .turn = turn});
    const BodyId ball = rig.ball(out * 0.5, 0.5, {.friction = mu});
    const Vec3d start = rig.at(ball);
    course.run(rig, 2);
    const bool rolls = share >= 1;
    const double gain = rolls ? 5.0 / 7 * kG_mps2 * std::sin(angle)
                              : kG_mps2 * (std::sin(angle) - mu * std::cos(angle));
    const double turning = rolls ? gain / 0.5 : 5 * mu * kG_mps2 * std::cos(angle) / (2 * 0.5);
    return {glm::dot(rig.at(ball) - start, down) / (2 * gain) - 1,
            -rig.spin(ball).z / (2 * turning) - 1};
}

Scenario slope(double angle_deg) {
    static constexpr double kShares[] = {0.5, 0.95, 1.05, 2};
    std::vector<Metric> metrics;
    for (const double share : kShares)
        metrics.push_back(
            {fmt::format("way at mu = {} of what rolling needs", share), "a t^2 / 2"});
    metrics.push_back({"spin, worst of the four", "that of the formula"});
    return {
        .id = fmt::format("A31 {} degrees", angle_deg),
        .title = "A ball goes down a slope",
        .set_up = fmt::format("A ball is let go on {} degrees, with friction on both sides of what "
                              "rolling needs; 2 s.",
                              angle_deg),
        .reference =
            "rolls (a = 5/7 g sin a) if mu >= 2/7 tan a, else slips "
            "(a = g (sin a - mu cos a))",
        .metrics = metrics,
        .run = [=](const Setting& setting, Course& course) -> Errors {
            Errors errors;
            double spin = 0;
            for (const double share : kShares) {
                const auto [way, turning] =
                    down_slope(angle_deg * kPi_d / 180, share, setting, course);
                errors.push_back(way);
                spin = std::max(spin, std::abs(turning));
            }
            errors.push_back(spin);
            return errors;
        },
        .euler_floor = [](double step_s) { return step_s / 2; }};
}

Scenario turntable() {
    static constexpr double kRate_radps = 3;
    static constexpr double kRadius_m = 0.25;
    static constexpr double kPath_m = 2;
    static constexpr double kSeconds = 15;
    static constexpr double kAround_radps = 2.0 / 7 * kRate_radps;
    return {
        .id = "A32",
        .title = "A ball on a turntable",
        .set_up =
            "A ball of radius 0.25 m rolls round on a plate that turns at 3 rad/s, started on "
            "its circle of 2 m; 15 s.",
        .reference = "it goes round at 2/7 of the plate's rate, at any radius",
        .metrics = {{"place at 15 s", "the circle's radius, 2 m"},
                    {"radius at 15 s", "2 m"},
                    {"angle gone round", "12.86 rad"}},
        .run = [](const Setting& setting, Course& course) -> Errors {
            Rig rig(setting);
            const BodyId table = rig.add(BodyKind::Kinematic,
                                         physics::BoxShape{.size_m = vec({16, 1, 16})},
                                         {0, -0.5, 0},
                                         {.friction = 1});
            rig.world.set_velocity(table, {0, 0, 0}, vec({0, kRate_radps, 0}));
            const Vec3d floor_mps = glm::cross(Vec3d{0, kRate_radps, 0}, Vec3d{kPath_m, 0, 0});
            const Vec3d velocity = floor_mps * (2.0 / 7);
            const BodyId ball = rig.ball(
                {kPath_m, kRadius_m, 0},
                kRadius_m,
                {.friction = 1,
                 .velocity_mps = velocity,
                 .spin_radps = glm::cross(Vec3d{0, 1, 0}, (velocity - floor_mps) / kRadius_m)});
            double phase = 0;
            course.run(rig, kSeconds, {.after = [&](int) {
                           const Vec3d now = rig.at(ball);
                           const double angle = std::atan2(-now.z, now.x);
                           phase += std::remainder(angle - phase, 2 * kPi_d);
                       }});
            const double angle = kAround_radps * kSeconds;
            const Vec3d expected{kPath_m * std::cos(angle), kRadius_m, -kPath_m * std::sin(angle)};
            const Vec3d at = rig.at(ball);
            return {glm::distance(at, expected) / kPath_m,
                    std::hypot(at.x, at.z) / kPath_m - 1,
                    phase / angle - 1};
        }};
}

/// SimBenchmark's rolling test: a plate of 10 kg pulled over the floor with 25 balls on it.
std::array<double, 2> pull_plate(const Vec3d& pull, const Setting& setting, Course& course) {
    constexpr double kSeconds = 4;
    constexpr double kForce_N = 150;
    constexpr int kBalls = 25;
    // Pairs get sqrt(a b): 0.4 between plate and floor, 0.8 between plate and balls.
    Rig rig(setting);
    rig.floor(0.2);
    const BodyId plate = rig.box({0, 0.5, 0}, {20, 1, 20}, {.mass_kg = 10, .friction = 0.8});
    for (int i = 0; i < kBalls; ++i)
        rig.ball(
            {2.0 * (i % 5) - 4, 1.5, 2.0 * static_cast<double>(i / 5) - 4}, 0.5, {.friction = 0.8});
    const double friction_N = 0.4 * (10 + kBalls) * kG_mps2;
    const double on_ball_N = (kForce_N - friction_N) / (3.5 * 10 + kBalls);
    const double plate_mps2 = 3.5 * on_ball_N;
    double squares = 0;
    int count = 0;
    course.run(rig,
               kSeconds,
               {.before = [&](int) { rig.world.apply_force(plate, vec(pull * kForce_N)); },
                .after =
                    [&](int i) {
                        const double t = (i + 1) * rig.step_s();
                        const Vec3d plate_off = rig.velocity(plate) - pull * (plate_mps2 * t);
                        squares += glm::dot(plate_off, plate_off);
                        ++count;
                    }});
    double ball_off = 0;
    for (const BodyId id : rig.movers) {
        const double gain = id == plate ? plate_mps2 : on_ball_N;
        ball_off = std::max(ball_off, glm::distance(rig.velocity(id), pull * (gain * kSeconds)));
    }
    const double end_mps = plate_mps2 * kSeconds;
    return {std::sqrt(squares / std::max(1, count)) / end_mps, ball_off / end_mps};
}

Scenario rolling_plate() {
    return {.id = "A33",
            .title = "A plate is pulled away under 25 balls",
            .set_up =
                "A plate of 20 x 1 x 20 m and 10 kg with 25 balls of 1 kg is pulled with 150 N for "
                "4 s, along an axis and askew; friction 0.4 below, 0.8 above (SimBenchmark's "
                "rolling).",
            .reference =
                "f1 = mu (M + n m) g, f2 = (F - f1)/(3.5 M/m + n); the plate gains 3.5 f2/m, "
                "a ball f2/m",
            .metrics = {{"the plate's velocity, rms, pulled askew", "its end speed, 2.95 m/s"},
                        {"the same, pulled along", "its end speed"},
                        {"worst velocity of any body at 4 s", "its end speed"}},
            .run = [](const Setting& setting, Course& course) -> Errors {
                const auto along = pull_plate({1, 0, 0}, setting, course);
                const auto askew = pull_plate({0.5, 0, std::sqrt(0.75)}, setting, course);
                return {askew[0], along[0], std::max(along[1], askew[1])};
            },
            .knobs = {.most_hz = 240}};
}

}  // namespace

void add_rolling(std::vector<Scenario>& all) {
    all.push_back(slide_to_roll());
    for (const double angle_deg : {10.0, 30.0}) all.push_back(slope(angle_deg));
    all.push_back(turntable());
    all.push_back(rolling_plate());
}

}  // namespace plumbline::study
