// Balls that roll: A30, A31, A32, A33.
#include "engine/study/scenarios/families/rolling.h"

#include "engine/study/scenarios/families/sliding.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace plumbline::study {

using physics::BodyId;
using physics::BodyKind;

double SlideToRoll::speed_at_mps(double t_s) const {
    return speed_mps - slowing_mps2() * std::min(t_s, rolls_at_s());
}

double SlideToRoll::path_m(double t_s) const {
    const double slid_s = std::min(t_s, rolls_at_s());
    return speed_mps * slid_s - slowing_mps2() * slid_s * slid_s / 2 +
           rolling_mps() * (t_s - slid_s);
}

SlidingBall::SlidingBall(const Setting& setting, const SlideToRoll& law, double heading_rad)
    : world(setting) {
    world.floor(law.mu);
    const Vec3d ahead{std::cos(heading_rad), 0, std::sin(heading_rad)};
    ball =
        world.sphere({0, 0.5, 0}, 0.5, {.friction = law.mu, .velocity_mps = ahead * law.speed_mps});
}

DownSlopeErrors down_slope(double angle_rad, double share, Stepper& stepper) {
    const double mu = share * 2.0 / 7 * std::tan(angle_rad);
    const Slope slope(angle_rad);
    ScenarioWorld world(stepper.setting());
    slope.add_to(world, mu);
    const BodyId ball = world.sphere(slope.out * 0.5, 0.5, {.friction = mu});
    const Vec3d start = world.at(ball);
    stepper.run(world, 2);
    const bool rolls = share >= 1;
    const double gain = rolls ? 5.0 / 7 * kG_mps2 * std::sin(angle_rad)
                              : kG_mps2 * (std::sin(angle_rad) - mu * std::cos(angle_rad));
    const double turning = rolls ? gain / 0.5 : 5 * mu * kG_mps2 * std::cos(angle_rad) / (2 * 0.5);
    return {glm::dot(world.at(ball) - start, slope.down) / (2 * gain) - 1,
            -world.spin(ball).z / (2 * turning) - 1};
}

BallOnTurntable::BallOnTurntable(const Setting& setting) : world(setting) {
    const BodyId table = world.kinematic_box({0, -0.5, 0}, {16, 1, 16}, {.friction = 1});
    world.physics.set_velocity(table, {0, 0, 0}, vec(0, kTable_radps, 0));
    const Vec3d floor_mps = glm::cross(Vec3d{0, kTable_radps, 0}, Vec3d{kPath_m, 0, 0});
    const Vec3d velocity = floor_mps * (2.0 / 7);
    ball = world.sphere(
        {kPath_m, kRadius_m, 0},
        kRadius_m,
        {.friction = 1,
         .velocity_mps = velocity,
         .spin_radps = glm::cross(Vec3d{0, 1, 0}, (velocity - floor_mps) / kRadius_m)});
}

Vec3d BallOnTurntable::expected_m(double t_s) {
    const double angle = kAround_radps * t_s;
    return {kPath_m * std::cos(angle), kRadius_m, -kPath_m * std::sin(angle)};
}

void BallOnTurntable::follow() {
    const Vec3d now = world.at(ball);
    gone_round_rad += std::remainder(std::atan2(-now.z, now.x) - gone_round_rad, 2 * kPi_d);
}

namespace {

Scenario slide_to_roll() {
    static constexpr SlideToRoll kLaw{.speed_mps = 5, .mu = 0.2};
    static constexpr double kSeconds = 3;
    return {
        .id = "A30",
        .title = "A ball slides until it rolls",
        .set_up = "A ball of radius 0.5 m is sent off at 5 m/s without spin, friction 0.2.",
        .reference = "rolls after 2 v0 / (7 mu g) = 0.7281 s at 5/7 of its speed; 11.2344 m in 3 s",
        .metrics = {{"path at 3 s", "11.23 m"},
                    {"speed at 3 s", "3.571 m/s"},
                    {"slip at 3 s", "3.571 m/s"}},
        .run = [](Stepper& stepper) -> Errors {
            SlidingBall slides(stepper.setting(), kLaw);
            stepper.run(slides.world, kSeconds);
            const double speed = slides.world.velocity(slides.ball).x;
            const double spin = slides.world.spin(slides.ball).z;
            return {slides.world.at(slides.ball).x / kLaw.path_m(kSeconds) - 1,
                    speed / kLaw.rolling_mps() - 1,
                    (speed + 0.5 * spin) / kLaw.rolling_mps()};
        },
        // Slowed by mu g at the start of every step while it slides, 0.73 s of 3.
        .euler_floor =
            [](double step_s) {
                const double lost_mps = kLaw.slowing_mps2() * kLaw.rolls_at_s();
                return lost_mps * step_s / 2 / kLaw.path_m(kSeconds);
            }};
}

Scenario slope(double angle_deg) {
    static constexpr double kShares[] = {0.5, 0.95, 1.05, 2};
    std::vector<Metric> metrics;
    for (const double share : kShares)
        metrics.push_back(
            {fmt::format("path at mu = {} of what rolling needs", share), "a t^2 / 2"});
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
        .run = [=](Stepper& stepper) -> Errors {
            Errors errors;
            double spin = 0;
            for (const double share : kShares) {
                const auto [path, turning] = down_slope(angle_deg * kPi_d / 180, share, stepper);
                errors.push_back(path);
                spin = std::max(spin, std::abs(turning));
            }
            errors.push_back(spin);
            return errors;
        },
        .euler_floor = [](double step_s) { return step_s / 2; }};
}

Scenario turntable() {
    static constexpr double kSeconds = 15;
    return {.id = "A32",
            .title = "A ball on a turntable",
            .set_up =
                "A ball of radius 0.25 m rolls round on a plate that turns at 3 rad/s, started on "
                "its circle of 2 m; 15 s.",
            .reference = "it goes round at 2/7 of the plate's rate, at any radius",
            .metrics = {{"place at 15 s", "the circle's radius, 2 m"},
                        {"radius at 15 s", "2 m"},
                        {"angle gone round", "12.86 rad"}},
            .run = [](Stepper& stepper) -> Errors {
                using Turntable = BallOnTurntable;
                Turntable rolls(stepper.setting());
                stepper.run(rolls.world, kSeconds, {.after = [&](int) { rolls.follow(); }});
                const Vec3d expected_m = Turntable::expected_m(kSeconds);
                const double angle_rad = Turntable::kAround_radps * kSeconds;
                return {glm::distance(rolls.world.at(rolls.ball), expected_m) / Turntable::kPath_m,
                        rolls.path_m() / Turntable::kPath_m - 1,
                        rolls.gone_round_rad / angle_rad - 1};
            }};
}

/// SimBenchmark's rolling test: a plate of 10 kg pulled over the floor with 25 balls on it.
std::array<double, 2> pull_plate(const Vec3d& pull, Stepper& stepper) {
    constexpr double kSeconds = 4;
    constexpr double kForce_N = 150;
    constexpr int kBalls = 25;
    // Pairs get sqrt(a b): 0.4 between plate and floor, 0.8 between plate and balls.
    ScenarioWorld world(stepper.setting());
    world.floor(0.2);
    const BodyId plate = world.box({0, 0.5, 0}, {20, 1, 20}, {.mass_kg = 10, .friction = 0.8});
    for (int i = 0; i < kBalls; ++i)
        world.sphere(
            {2.0 * (i % 5) - 4, 1.5, 2.0 * static_cast<double>(i / 5) - 4}, 0.5, {.friction = 0.8});
    const double friction_N = 0.4 * (10 + kBalls) * kG_mps2;
    const double on_ball_N = (kForce_N - friction_N) / (3.5 * 10 + kBalls);
    const double plate_mps2 = 3.5 * on_ball_N;
    double squares = 0;
    int count = 0;
    stepper.run(world,
                kSeconds,
                {.before = [&](int) { world.physics.apply_force(plate, vec(pull * kForce_N)); },
                 .after =
                     [&](int i) {
                         const double t = (i + 1) * world.step_s();
                         const Vec3d plate_off = world.velocity(plate) - pull * (plate_mps2 * t);
                         squares += glm::dot(plate_off, plate_off);
                         ++count;
                     }});
    double ball_off = 0;
    for (const BodyId id : world.movers) {
        const double gain = id == plate ? plate_mps2 : on_ball_N;
        ball_off = std::max(ball_off, glm::distance(world.velocity(id), pull * (gain * kSeconds)));
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
            .run = [](Stepper& stepper) -> Errors {
                const auto along = pull_plate({1, 0, 0}, stepper);
                const auto askew = pull_plate({0.5, 0, std::sqrt(0.75)}, stepper);
                return {askew[0], along[0], std::max(along[1], askew[1])};
            },
            .knobs = {.most_hz = 240}};
}

}  // namespace

std::vector<Scenario> rolling_family() {
    return {slide_to_roll(), slope(10), slope(30), turntable(), rolling_plate()};
}

}  // namespace plumbline::study
