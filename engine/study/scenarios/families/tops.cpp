// Bodies that turn freely, and tops on a pivot: A05 to A08.
#include "engine/study/scenarios/families/tops.h"

#include "engine/physics/totals.h"
#include "engine/study/angle_between.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline::study {

using physics::BodyId;

State<7> EulersEquations::operator()(double /*t_s*/, const State<7>& state) const {
    const Quatd turn{state[0], state[1], state[2], state[3]};
    const Vec3d w{state[4], state[5], state[6]};
    const Quatd rate = turn * Quatd{0, w.x, w.y, w.z} * 0.5;
    return {rate.w,
            rate.x,
            rate.y,
            rate.z,
            (inertia_kgm2.y - inertia_kgm2.z) * w.y * w.z / inertia_kgm2.x,
            (inertia_kgm2.z - inertia_kgm2.x) * w.z * w.x / inertia_kgm2.y,
            (inertia_kgm2.x - inertia_kgm2.y) * w.x * w.y / inertia_kgm2.z};
}

TurningBody turned_for(const TurningBody& start, const Vec3d& inertia_kgm2, double seconds) {
    const Quatd& turn = start.turn;
    const Vec3d& w = start.own_spin_radps;
    const State<7> end = reference(EulersEquations{inertia_kgm2},
                                   State<7>{turn.w, turn.x, turn.y, turn.z, w.x, w.y, w.z},
                                   0,
                                   seconds);
    return {glm::normalize(Quatd{end[0], end[1], end[2], end[3]}), {end[4], end[5], end[6]}};
}

FreeBodyDef box_of_three_lengths() {
    return {.shape = physics::BoxShape{.size_m = {1, 2, 3}}, .spin_radps = {0.01, 5, 0.01}};
}
FreeBodyDef wobbling_disc() {
    constexpr double kTilt_rad = 20 * kPi_d / 180;
    return {.shape = physics::CylinderShape{.radius_m = 0.5_r, .height_m = 0.1_r},
            .spin_radps = {30 * std::sin(kTilt_rad), 30 * std::cos(kTilt_rad), 0}};
}
FreeBodyDef t_handle() {
    return {.shape = physics::BoxShape{.size_m = vec(1, 0.6, 0.2)},
            .spin_radps = {0.01, 5, 0.01},
            .mass_kg = 56,
            .inertia_kgm2 = Vec3d{1.5619047619047621, 3.573333333333334, 4.761904761904763}};
}

FreeBody::FreeBody(const Setting& setting, const FreeBodyDef& def, Company company)
    : world(setting, {0, 0, 0}) {
    physics::BodyDef body_def{.kind = physics::BodyKind::Dynamic,
                              .mass_kg = real(def.mass_kg),
                              .angular_velocity_radps = vec(def.spin_radps),
                              .can_sleep = false};
    if (def.inertia_kgm2) body_def.inertia_kgm2 = vec(*def.inertia_kgm2);
    body = world.add(def.shape, body_def);
    if (company == Company::None) return;
    const BodyId other = world.sphere({5, 0, 0}, 0.1);
    world.join({.kind = physics::JointKind::Spring,
                .a = body,
                .b = other,
                .anchor_a_world = {0, 0, 0},
                .anchor_b_world = {5, 0, 0}});
}

TurningBody turning_body(const ScenarioWorld& world, BodyId body) {
    const Quatd turn = world.turn(body);
    return {turn, glm::conjugate(turn) * world.spin(body)};
}

Vec3d Precession::axis_at(double t_s) const {
    return glm::angleAxis(rate_radps * t_s, about()) * start;
}

Precession disc_precession() {
    // The shape's own moments, in double: m (3 r^2 + h^2) / 12 and m r^2 / 2.
    const Vec3d inertia{0.76 / 12, 0.125, 0.76 / 12};
    const Vec3d momentum = inertia * wobbling_disc().spin_radps;
    return {.momentum_kgm2ps = momentum,
            .start = {0, 1, 0},
            .rate_radps = glm::length(momentum) / inertia.x};
}

ConservedErrors conserved_errors(ScenarioWorld& world, double seconds, Stepper& stepper) {
    const double start_J = physics::energy(world.physics).kinetic_J;
    const Vec3d start = angular_momentum_kgm2ps(world.physics);
    ConservedErrors most;
    stepper.run(world, seconds, {.after = [&](int) {
                    const double now_J = physics::energy(world.physics).kinetic_J;
                    const Vec3d now = angular_momentum_kgm2ps(world.physics);
                    most.energy = std::max(most.energy, std::abs(now_J / start_J - 1));
                    most.momentum =
                        std::max(most.momentum, glm::distance(now, start) / glm::length(start));
                }});
    return most;
}

namespace {

constexpr Knobs kFreeKnobs{.substeps = false, .iterations = false};

Scenario three_lengths() {
    static constexpr double kSeconds = 10;
    return {.id = "A05",
            .title = "A box that turns about its middle axis",
            .set_up =
                "A box of 1 x 2 x 3 m spins at 5 rad/s about its middle axis, with 0.01 rad/s "
                "about the others: it turns over again and again.",
            .reference = "Euler's equations by Dormand-Prince and by Gauss-Legendre",
            .tier = Tier::TwoIntegrators,
            .metrics = {{"spin at 10 s", "5 rad/s"},
                        {"orientation at 10 s", "1 rad"},
                        {"largest error of energy", "the energy"},
                        {"largest error of angular momentum", "the momentum"}},
            .run = [](Stepper& stepper) -> Errors {
                static const TurningBody expected =
                    turned_for({.own_spin_radps = box_of_three_lengths().spin_radps},
                               Vec3d{13, 10, 5} / 12.0,
                               kSeconds);
                FreeBody free(stepper.setting(), box_of_three_lengths());
                const ConservedErrors kept = conserved_errors(free.world, kSeconds, stepper);
                const TurningBody now = free.now();
                return {glm::distance(now.own_spin_radps, expected.own_spin_radps) / 5,
                        angle_between_rad(now.turn, expected.turn),
                        kept.energy,
                        kept.momentum};
            },
            .knobs = kFreeKnobs,
            .theory = orders_in_step(2, std::nullopt)};
}

Scenario free_disc() {
    static constexpr double kSeconds = 20;
    return {.id = "A06",
            .title = "A disc that wobbles",
            .set_up =
                "A disc of radius 0.5 m, 0.1 m thick, spins at 30 rad/s, 20 degrees off its "
                "axis.",
            .reference = "its axis goes round the angular momentum L on a cone at the rate L/I1",
            .metrics = {{"direction of its axis at 20 s", "1 rad"},
                        {"largest change of the cone's angle", "1 rad"},
                        {"largest error of angular momentum", "the momentum"}},
            .run = [](Stepper& stepper) -> Errors {
                const Precession expected = disc_precession();
                const Vec3d momentum = expected.momentum_kgm2ps;
                FreeBody disc(stepper.setting(), wobbling_disc());
                double cone_off = 0;
                double momentum_off = 0;
                stepper.run(
                    disc.world, kSeconds, {.after = [&](int) {
                        const double up = glm::dot(disc.axis(), expected.about());
                        const double cone_rad = std::acos(std::min(1.0, up));
                        cone_off = std::max(cone_off, std::abs(cone_rad - expected.cone_rad()));
                        const Vec3d now = angular_momentum_kgm2ps(disc.world.physics);
                        momentum_off = std::max(
                            momentum_off, glm::distance(now, momentum) / glm::length(momentum));
                    }});
                const double along = glm::dot(disc.axis(), expected.axis_at(kSeconds));
                return {std::acos(std::clamp(along, -1.0, 1.0)), cone_off, momentum_off};
            },
            .knobs = kFreeKnobs,
            .theory = orders_in_step(2, std::nullopt)};
}

// A disc of radius 0.5 m, 0.1 m thick, 1 kg, on an arm of 1 m without mass.
constexpr double kAcross = 0.76 / 12 + 1;  // about the pivot
constexpr double kAlong = 0.125;
constexpr double kTopTilt_rad = 30 * kPi_d / 180;

/// The top on its pivot at the origin, its axis tilted towards +x.
struct HeavyTop {
    ScenarioWorld world;
    BodyId body;
    physics::JointId pivot;

    /// `around_radps` is the rate at which the axis goes round the vertical.
    HeavyTop(const Setting& setting, double spin_radps, double around_radps) : world(setting) {
        const Quatd turn = glm::angleAxis(-kTopTilt_rad, Vec3d{0, 0, 1});
        const Vec3d axis = turn * Vec3d{0, 1, 0};
        // Its component along the axis is spin_radps.
        const Vec3d up{0, 1, 0};
        const Vec3d spin =
            axis * (spin_radps - around_radps * std::cos(kTopTilt_rad)) + up * around_radps;
        body = world.cylinder(axis,
                              0.5,
                              0.1,
                              {.velocity_mps = glm::cross(spin, axis),
                               .spin_radps = spin,
                               .turn = turn,
                               .touches = false});
        pivot = world.join_at({0, 0, 0}, body);
    }
    Vec3d axis() const { return world.turn(body) * Vec3d{0, 1, 0}; }
    double tilt_rad() const { return std::acos(std::clamp(axis().y, -1.0, 1.0)); }
};

Scenario steady_top(double spin_radps) {
    static constexpr double kSeconds = 10;
    const double turning = kAlong * spin_radps;
    const double fall = kG_mps2 * std::cos(kTopTilt_rad);
    const double around_radps = (turning - std::sqrt(turning * turning - 4 * kAcross * fall)) /
                                (2 * kAcross * std::cos(kTopTilt_rad));
    return {
        .id = fmt::format("A07 {} rad/s", spin_radps),
        .title = "A heavy top that goes round steadily",
        .set_up =
            "A disc on an arm of 1 m stands on a ball-and-socket joint, 30 degrees off the "
            "vertical, "
            "and has the spin at which it goes round without nodding.",
        .reference = "slow root of I1 cos(a) W^2 - I3 w3 W + m g l = 0",
        .metrics = {{"direction of its axis at 10 s", "1 rad"},
                    {"largest change of its tilt", "1 rad"},
                    {"largest gap at the pivot", "the arm, 1 m"}},
        .run = [=](Stepper& stepper) -> Errors {
            HeavyTop top(stepper.setting(), spin_radps, around_radps);
            double tilt_off = 0;
            double gap_m = 0;
            stepper.run(top.world, kSeconds, {.after = [&](int) {
                            tilt_off = std::max(tilt_off, std::abs(top.tilt_rad() - kTopTilt_rad));
                            gap_m = std::max(gap_m, top.world.joint(top.pivot).error_m);
                        }});
            const Vec3d start = glm::angleAxis(-kTopTilt_rad, Vec3d{0, 0, 1}) * Vec3d{0, 1, 0};
            const Vec3d expected = glm::angleAxis(around_radps * kSeconds, Vec3d{0, 1, 0}) * start;
            return {glm::distance(top.axis(), expected), tilt_off, gap_m};
        },
        .theory = orders_in_step(2, std::nullopt)};
}

/// Tilt and its rate, and the way round, of a top whose spin is kept (Goldstein, "Classical
/// Mechanics", 5.7): the momenta about the axis and the vertical are constant.
struct TopLaw {
    double along;     ///< I3 w3
    double vertical;  ///< momentum about the vertical

    double around(double tilt) const {
        const double sine = std::sin(tilt);
        return (vertical - along * std::cos(tilt)) / (kAcross * sine * sine);
    }
    State<3> operator()(double, const State<3>& s) const {
        const double rate = around(s[0]);
        const double sine = std::sin(s[0]);
        return {s[1],
                rate * rate * sine * std::cos(s[0]) - along * rate * sine / kAcross +
                    kG_mps2 * sine / kAcross,
                rate};
    }
};

Scenario nodding_top() {
    static constexpr double kSeconds = 5;
    static constexpr double kSpin_radps = 100;
    static const TopLaw law{kAlong * kSpin_radps, kAlong * kSpin_radps * std::cos(kTopTilt_rad)};
    static const State<3> start{kTopTilt_rad, 0, 0};
    return {.id = "A08",
            .title = "A heavy top that is let go",
            .set_up =
                "The same top spins at 100 rad/s and is let go at rest: it nods while it goes "
                "round.",
            .reference = "Lagrange's equation of the tilt by Dormand-Prince and by Gauss-Legendre",
            .tier = Tier::TwoIntegrators,
            .metrics = {{"direction of its axis at 5 s", "1 rad"},
                        {"largest tilt of the last second", "the depth of a nod, 0.067 rad"},
                        {"largest gap at the pivot", "the arm, 1 m"}},
            .run = [](Stepper& stepper) -> Errors {
                static const State<3> expected = reference(law, start, 0, kSeconds);
                // A nod starts and ends at rest and is deepest where its rate is zero again.
                static const double deepest = [] {
                    double most = kTopTilt_rad;
                    State<3> at = start;
                    for (int i = 0; i < 1000; ++i) {
                        at = gauss_legendre(law, at, i * 1e-3, (i + 1) * 1e-3, 1e-3);
                        most = std::max(most, at[0]);
                    }
                    return most;
                }();
                HeavyTop top(stepper.setting(), kSpin_radps, 0);
                double gap_m = 0;
                double last_tilt = 0;
                const double step_s = top.world.step_s();
                stepper.run(top.world, kSeconds, {.after = [&](int i) {
                                if ((i + 1) * step_s > kSeconds - 1)
                                    last_tilt = std::max(last_tilt, top.tilt_rad());
                                gap_m = std::max(gap_m, top.world.joint(top.pivot).error_m);
                            }});
                const Vec3d tilted = glm::angleAxis(-expected[0], Vec3d{0, 0, 1}) * Vec3d{0, 1, 0};
                const Vec3d axis = glm::angleAxis(expected[2], Vec3d{0, 1, 0}) * tilted;
                return {glm::distance(top.axis(), axis),
                        (last_tilt - deepest) / (deepest - kTopTilt_rad),
                        gap_m};
            },
            .theory = orders_in_step(2, std::nullopt)};
}

}  // namespace

std::vector<Scenario> tops_family() {
    return {three_lengths(), free_disc(), steady_top(60), steady_top(100), nodding_top()};
}

}  // namespace plumbline::study
