// Bodies that turn freely, and tops on a pivot: A05 to A08.
#include "engine/study/scenarios/integrate.h"
#include "engine/study/scenarios/scenario.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline::study {
namespace {

using physics::BodyId;

constexpr Knobs kFreeKnobs{.substeps = false, .iterations = false};

double angle_between(const Quatd& a, const Quatd& b) {
    const Quatd between = glm::conjugate(a) * b;
    return 2 * std::asin(std::min(1.0, glm::length(Vec3d{between.x, between.y, between.z})));
}

/// Euler's equations with the orientation: w x y z of the turn, then the spin about body axes.
struct FreeBody {
    Vec3d inertia;

    State<7> operator()(double, const State<7>& s) const {
        const Quatd turn{s[0], s[1], s[2], s[3]};
        const Vec3d w{s[4], s[5], s[6]};
        const Quatd rate = turn * Quatd{0, w.x, w.y, w.z} * 0.5;
        return {rate.w,
                rate.x,
                rate.y,
                rate.z,
                (inertia.y - inertia.z) * w.y * w.z / inertia.x,
                (inertia.z - inertia.x) * w.z * w.x / inertia.y,
                (inertia.x - inertia.y) * w.x * w.y / inertia.z};
    }
};

/// What a free body keeps, watched: largest relative errors.
struct Kept {
    double energy{0};
    double momentum{0};

    static Kept run(Course& course, Rig& rig, double seconds) {
        const double start_J = rig.world.energy().kinetic_J;
        const Vec3d start = rig.world.angular_momentum_kgm2ps();
        Kept kept;
        course.run(rig, seconds, {.after = [&](int) {
                       const double now_J = rig.world.energy().kinetic_J;
                       const Vec3d now = rig.world.angular_momentum_kgm2ps();
                       kept.energy = std::max(kept.energy, std::abs(now_J / start_J - 1));
                       kept.momentum =
                           std::max(kept.momentum, glm::distance(now, start) / glm::length(start));
                   }});
        return kept;
    }
};

Scenario three_lengths() {
    static constexpr double kSeconds = 10;
    static const FreeBody law{Vec3d{13, 10, 5} / 12.0};
    static const State<7> start{1, 0, 0, 0, 0.01, 5, 0.01};
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
            .run = [](const Setting& setting, Course& course) -> Errors {
                static const State<7> expected = reference(law, start, 0, kSeconds);
                Rig rig(setting, {0, 0, 0});
                const BodyId body = rig.box({0, 0, 0}, {1, 2, 3}, {.spin_radps = {0.01, 5, 0.01}});
                const Kept kept = Kept::run(course, rig, kSeconds);
                const Vec3d spin = glm::conjugate(rig.turn(body)) * rig.spin(body);
                const Quatd turn{expected[0], expected[1], expected[2], expected[3]};
                return {glm::distance(spin, {expected[4], expected[5], expected[6]}) / 5,
                        angle_between(rig.turn(body), turn),
                        kept.energy,
                        kept.momentum};
            },
            .knobs = kFreeKnobs,
            .theory = orders_in_step(2, std::nullopt)};
}

Scenario free_disc() {
    static constexpr double kSeconds = 20;
    static constexpr double kTilt_rad = 20 * kPi_d / 180;
    return {.id = "A06",
            .title = "A disc that wobbles",
            .set_up =
                "A disc of radius 0.5 m, 0.1 m thick, spins at 30 rad/s, 20 degrees off its "
                "axis.",
            .reference = "its axis goes round the angular momentum L on a cone at the rate L/I1",
            .metrics = {{"direction of its axis at 20 s", "1 rad"},
                        {"largest change of the cone's angle", "1 rad"},
                        {"largest error of angular momentum", "the momentum"}},
            .run = [](const Setting& setting, Course& course) -> Errors {
                Rig rig(setting, {0, 0, 0});
                const Vec3d spin{30 * std::sin(kTilt_rad), 30 * std::cos(kTilt_rad), 0};
                const BodyId body = rig.cylinder({0, 0, 0}, 0.5, 0.1, {.spin_radps = spin});
                // The shape's own moments, in double: m (3 r^2 + h^2) / 12 and m r^2 / 2.
                const Vec3d inertia{0.76 / 12, 0.125, 0.76 / 12};
                const Vec3d momentum = inertia * spin;
                const Vec3d up = glm::normalize(momentum);
                const Vec3d first{0, 1, 0};
                const double cone = std::acos(glm::dot(first, up));
                const auto axis = [&] { return rig.turn(body) * first; };
                double cone_off = 0;
                double momentum_off = 0;
                course.run(rig, kSeconds, {.after = [&](int) {
                               const double now = std::acos(std::min(1.0, glm::dot(axis(), up)));
                               cone_off = std::max(cone_off, std::abs(now - cone));
                               momentum_off = std::max(
                                   momentum_off,
                                   glm::distance(rig.world.angular_momentum_kgm2ps(), momentum) /
                                       glm::length(momentum));
                           }});
                const double phase = glm::length(momentum) / inertia.x * kSeconds;
                const Vec3d expected = glm::angleAxis(phase, up) * first;
                return {std::acos(std::clamp(glm::dot(axis(), expected), -1.0, 1.0)),
                        cone_off,
                        momentum_off};
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
    Rig rig;
    BodyId body;
    physics::JointId pivot;

    /// `around_radps` is the rate at which the axis goes round the vertical.
    HeavyTop(const Setting& setting, double spin_radps, double around_radps) : rig(setting) {
        const Quatd turn = glm::angleAxis(-kTopTilt_rad, Vec3d{0, 0, 1});
        const Vec3d axis = turn * Vec3d{0, 1, 0};
        // Its component along the axis is spin_radps.
        const Vec3d up{0, 1, 0};
        const Vec3d spin =
            axis * (spin_radps - around_radps * std::cos(kTopTilt_rad)) + up * around_radps;
        body = rig.cylinder(axis,
                            0.5,
                            0.1,
                            {.velocity_mps = glm::cross(spin, axis),
                             .spin_radps = spin,
                             .turn = turn,
                             .touches = false});
        pivot = rig.join({.kind = physics::JointKind::Ball, .a = body});
    }
    Vec3d axis() const { return rig.turn(body) * Vec3d{0, 1, 0}; }
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
            "A disc on an arm of 1 m stands on a ball joint, 30 degrees off the vertical, "
            "and has the spin at which it goes round without nodding.",
        .reference = "slow root of I1 cos(a) W^2 - I3 w3 W + m g l = 0",
        .metrics = {{"direction of its axis at 10 s", "1 rad"},
                    {"largest change of its tilt", "1 rad"},
                    {"largest gap at the pivot", "the arm, 1 m"}},
        .run = [=](const Setting& setting, Course& course) -> Errors {
            HeavyTop top(setting, spin_radps, around_radps);
            double tilt_off = 0;
            double gap_m = 0;
            course.run(top.rig, kSeconds, {.after = [&](int) {
                           tilt_off = std::max(tilt_off, std::abs(top.tilt_rad() - kTopTilt_rad));
                           gap_m = std::max(gap_m, top.rig.joint(top.pivot).error_m);
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
            .run = [](const Setting& setting, Course& course) -> Errors {
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
                HeavyTop top(setting, kSpin_radps, 0);
                double gap_m = 0;
                double last_tilt = 0;
                const double step_s = top.rig.step_s();
                course.run(top.rig, kSeconds, {.after = [&](int i) {
                               if ((i + 1) * step_s > kSeconds - 1)
                                   last_tilt = std::max(last_tilt, top.tilt_rad());
                               gap_m = std::max(gap_m, top.rig.joint(top.pivot).error_m);
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

void add_tops(std::vector<Scenario>& all) {
    all.push_back(three_lengths());
    all.push_back(free_disc());
    for (const double spin_radps : {60.0, 100.0}) all.push_back(steady_top(spin_radps));
    all.push_back(nodding_top());
}

}  // namespace plumbline::study
