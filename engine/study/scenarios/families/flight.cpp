// Bodies that nothing touches and that do not turn: A01 to A04.
#include "engine/study/scenarios/families/flight.h"

#include "engine/study/scenarios/scenario.h"

#include <cmath>

namespace plumbline::study {

using physics::BodyId;

namespace {

constexpr Vec3d kThrow_mps{3, 10, 0};

}  // namespace

Vec3d thrown_m(const Vec3d& from_m, const Vec3d& velocity_mps, double t_s) {
    return from_m + velocity_mps * t_s - Vec3d{0, 0.5 * kG_mps2 * t_s * t_s, 0};
}

ThrownBall::ThrownBall(const Setting& setting)
    : world(setting), ball(world.sphere({0, 0, 0}, 0.1, {.velocity_mps = kThrow_mps})) {}

Vec3d ThrownBall::off_m(double t_s) const {
    return world.at(ball) - thrown_m({0, 0, 0}, kThrow_mps, t_s);
}

namespace {

constexpr Knobs kFlightKnobs{.substeps = false, .iterations = false, .most_hz = 1920};

const char* const kFlownAlone =
    "under every solver a body that nothing pushes is moved on the closed form of constant "
    "acceleration and damping, not by the solver: no Euler floor here";

Scenario projectile() {
    static constexpr double kSeconds = 2;
    static constexpr double kFallen_m = 0.5 * kG_mps2 * kSeconds * kSeconds;
    return {.id = "A01",
            .title = "A thrown body",
            .set_up = "A ball of 1 kg leaves at 3 m/s along and 10 m/s up. Nothing is in its way.",
            .reference = "x = v0 t - g t^2 / 2",
            .metrics = {{"height at 2 s", "the distance fallen, 19.62 m"},
                        {"path along at 2 s", "6 m"}},
            .run = [](Stepper& stepper) -> Errors {
                ThrownBall thrown(stepper.setting());
                stepper.run(thrown.world, kSeconds);
                const Vec3d off_m = thrown.off_m(kSeconds);
                return {off_m.y / kFallen_m, off_m.x / 6};
            },
            // g T h / 2, of g T^2 / 2.
            .euler_floor = [](double step_s) { return step_s / kSeconds; },
            .knobs = kFlightKnobs,
            .notes = {kFlownAlone}};
}

/// The check line of the study: what the solver pushes at every step moves by the solver's own rule.
Scenario along_a_wall() {
    static constexpr double kSeconds = 2;
    static constexpr double kFallen_m = 0.5 * kG_mps2 * kSeconds * kSeconds;
    return {.id = "A01 along a wall",
            .title = "A body thrown up along a smooth wall",
            .set_up =
                "The same ball leaves at 10 m/s up while 10 N press it on a wall without "
                "friction: never alone, so the solver moves it at every step.",
            .reference = "y = v0 t - g t^2 / 2; a semi-implicit Euler body is off by g T h / 2",
            .metrics = {{"height at 2 s", "the distance fallen, 19.62 m"},
                        {"path into the wall at 2 s", "its radius, 0.1 m"}},
            .run = [](Stepper& stepper) -> Errors {
                ScenarioWorld world(stepper.setting());
                world.fixed_box({-1.1, 0, 0}, {2, 60, 20}, {.friction = 0});
                const BodyId ball =
                    world.sphere({0, 0, 0}, 0.1, {.friction = 0, .velocity_mps = {0, 10, 0}});
                const auto press = [&](int) { world.physics.apply_force(ball, {-10, 0, 0}); };
                stepper.run(world, kSeconds, {.before = press});
                const double expected_m = 10 * kSeconds - kFallen_m;
                return {(world.at(ball).y - expected_m) / kFallen_m, world.at(ball).x / 0.1};
            },
            .euler_floor = [](double step_s) { return step_s / kSeconds; },
            .knobs = {.iterations = false, .most_hz = 1920},
            .theory = orders_in_step(std::nullopt, 1)};
}

Scenario damped_fall() {
    static const double rate = -std::log(0.8);
    static constexpr double kSeconds = 5;
    static const double kept = std::exp(-rate * kSeconds);
    static const double speed_mps = kG_mps2 / rate * (1 - kept);
    static const double path_m = kG_mps2 / rate * (kSeconds - (1 - kept) / rate);
    return {.id = "A02",
            .title = "A fall with linear damping",
            .set_up = "A ball falls from rest for 5 s; damping takes 20 % of its speed a second.",
            .reference = "v = (g/k)(1 - exp(-k t)), k = -ln 0.8",
            .metrics = {{"speed at 5 s", "29.6 m/s"}, {"path at 5 s", "the distance fallen"}},
            .run = [](Stepper& stepper) -> Errors {
                ScenarioWorld world(stepper.setting());
                const BodyId ball = world.sphere({0, 0, 0}, 0.1, {.linear_damping_per_s = rate});
                stepper.run(world, kSeconds);
                return {-world.velocity(ball).y / speed_mps - 1, -world.at(ball).y / path_m - 1};
            },
            // v <- (v + g h) exp(-k h), summed.
            .euler_floor =
                [](double step_s) {
                    const double factor = std::exp(-rate * step_s);
                    const double euler = kG_mps2 * step_s * factor * (1 - kept) / (1 - factor);
                    return std::abs(euler / speed_mps - 1);
                },
            .knobs = kFlightKnobs,
            .notes = {kFlownAlone}};
}

/// On one body of a kilogram.
class ForceOn final : public physics::ForceField {
public:
    using ForceOf = Vec3d (*)(const physics::BodyInField& body, double h_s);
    ForceOn(BodyId body, ForceOf force_N) : body_(body), force_N_(force_N) {}
    bool acts_on(BodyId body) const override { return body == body_; }
    void act(std::span<physics::BodyInField* const> bodies,
             const physics::FieldTime& time) override {
        for (physics::BodyInField* body : bodies)
            body->impulse_Ns += force_N_(*body, time.h_s) * time.h_s;
    }

private:
    BodyId body_;
    ForceOf force_N_;
};

constexpr double kTerminal_mps = 10;

/// At the speed in the middle of the sub-step, which has half of the drag by then.
Vec3d drag_N(const physics::BodyInField& body, double h_s) {
    const auto at = [](const Vec3d& velocity_mps) {
        return velocity_mps *
               (-kG_mps2 * glm::length(velocity_mps) / (kTerminal_mps * kTerminal_mps));
    };
    return at(body.velocity_mps + at(body.velocity_mps) * (h_s / 2));
}

/// Speed and path of semi-implicit Euler under quadratic drag.
std::pair<double, double> euler_drag(double step_s, double seconds) {
    double speed = 0;
    double path_m = 0;
    const int steps = static_cast<int>(std::lround(seconds / step_s));
    for (int i = 0; i < steps; ++i) {
        const double share = speed / kTerminal_mps;
        speed += step_s * kG_mps2 * (1 - share * share);
        path_m += step_s * speed;
    }
    return {speed, path_m};
}

Scenario quadratic_drag() {
    static constexpr double kSeconds = 2;
    static const double speed_mps = kTerminal_mps * std::tanh(kG_mps2 * kSeconds / kTerminal_mps);
    static const double path_m = kTerminal_mps * kTerminal_mps / kG_mps2 *
                                 std::log(std::cosh(kG_mps2 * kSeconds / kTerminal_mps));
    return {.id = "A03",
            .title = "A fall with quadratic drag",
            .set_up = "A force field, m g (v/10 m/s)^2 against the motion.",
            .reference = "v = vt tanh(g t / vt), y = (vt^2/g) ln cosh(g t / vt)",
            .metrics = {{"path at 2 s", "13.13 m"}, {"speed at 2 s", "9.612 m/s"}},
            .run = [](Stepper& stepper) -> Errors {
                ScenarioWorld world(stepper.setting());
                const BodyId ball = world.sphere({0, 0, 0}, 0.1);
                ForceOn drag(ball, drag_N);
                stepper.run(world, kSeconds, {.field = &drag});
                return {-world.at(ball).y / path_m - 1, -world.velocity(ball).y / speed_mps - 1};
            },
            .euler_floor =
                [](double step_s) {
                    return std::abs(euler_drag(step_s, kSeconds).second / path_m - 1);
                },
            .knobs = kFlightKnobs,
            .theory = orders_in_step(2, 1)};
}

constexpr double kEccentricity = 0.5;
constexpr double kOrbit_s = 60;

/// On the ellipse of half axis 1 and mu = 1, `t` after pericentre: Kepler's equation by Newton.
Vec3d kepler_at(double t) {
    double anomaly = t;
    for (int i = 0; i < 50; ++i) {
        anomaly -= (anomaly - kEccentricity * std::sin(anomaly) - t) /
                   (1 - kEccentricity * std::cos(anomaly));
    }
    const double minor = std::sqrt(1 - kEccentricity * kEccentricity);
    return {std::cos(anomaly) - kEccentricity, minor * std::sin(anomaly), 0};
}
const Vec3d kPericentre{1 - kEccentricity, 0, 0};
const Vec3d kFastest_mps{0, std::sqrt((1 + kEccentricity) / (1 - kEccentricity)), 0};

double euler_orbit_error(double step_s) {
    Vec3d at = kPericentre;
    Vec3d velocity = kFastest_mps;
    const int steps = static_cast<int>(std::lround(kOrbit_s / step_s));
    for (int i = 0; i < steps; ++i) {
        velocity -= at * (step_s / std::pow(glm::length(at), 3));
        at += velocity * step_s;
    }
    return glm::distance(at, kepler_at(kOrbit_s));
}

Vec3d pull_N(const physics::BodyInField& body, double) {
    return -body.center_m / std::pow(glm::length(body.center_m), 3);
}

Scenario orbit() {
    return {.id = "A04",
            .title = "An orbit of eccentricity 0.5",
            .set_up =
                "A body goes round a centre that pulls with 1/r^2 (half axis 1 m, 2 pi s a "
                "round): a force field.",
            .reference = "Kepler's equation, by Newton's method",
            .metrics = {{"place at 60 s", "the half axis, 1 m"},
                        {"largest error of energy", "the energy, 0.5 J"},
                        {"angular momentum at 60 s", "that at the start"}},
            .run = [](Stepper& stepper) -> Errors {
                ScenarioWorld world(stepper.setting(), {0, 0, 0});
                const BodyId body = world.sphere(kPericentre, 0.05, {.velocity_mps = kFastest_mps});
                ForceOn pull(body, pull_N);
                double energy_off = 0;
                const auto look = [&](int) {
                    const double speed = glm::length(world.velocity(body));
                    const double energy = speed * speed / 2 - 1 / glm::length(world.at(body));
                    energy_off = std::max(energy_off, std::abs(energy + 0.5) / 0.5);
                };
                stepper.run(world, kOrbit_s, {.field = &pull, .after = look});
                const Vec3d turned = glm::cross(world.at(body), world.velocity(body));
                const Vec3d start = glm::cross(kPericentre, kFastest_mps);
                return {glm::distance(world.at(body), kepler_at(kOrbit_s)),
                        energy_off,
                        glm::distance(turned, start) / glm::length(start)};
            },
            .euler_floor = euler_orbit_error,
            .knobs = {.substeps = false, .iterations = false},
            .theory = orders_in_step(2, 2)};
}

}  // namespace

std::vector<Scenario> flight_family() {
    return {projectile(), along_a_wall(), damped_fall(), quadratic_drag(), orbit()};
}

}  // namespace plumbline::study
