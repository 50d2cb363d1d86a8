// Bodies that topple, slide off and lose touch: A38.
#include "engine/study/scenarios/integrate.h"
#include "engine/study/scenarios/scenario.h"

#include <algorithm>
#include <cmath>

namespace plumbline::study {
namespace {

using physics::BodyId;

constexpr double kThin_m = 0.02;

/// A rod of 1 m that stands on its lower end at the origin, its upper end towards +x.
BodyId leaning_rod(ScenarioWorld& world, double from_vertical_rad, double friction) {
    const Quatd turn = glm::angleAxis(-from_vertical_rad, Vec3d{0, 0, 1});
    const Vec3d middle{0.5 * std::sin(from_vertical_rad), 0.5 * std::cos(from_vertical_rad), 0};
    // A capsule of nearly no thickness: its round end touches at one point.
    return world.add(
        physics::BodyKind::Dynamic,
        physics::CapsuleShape{.radius_m = real(kThin_m), .height_m = real(1 - 2 * kThin_m)},
        middle + Vec3d{0, kThin_m * (1 - std::cos(from_vertical_rad)), 0},
        {.friction = friction, .turn = turn});
}

/// Angle of a body's y axis from the vertical, towards +x.
double lean_rad(const ScenarioWorld& world, BodyId id) {
    const Vec3d axis = world.turn(id) * Vec3d{0, 1, 0};
    return std::atan2(axis.x, axis.y);
}

/// A capsule's end of radius r rests on a smooth floor; l is from its middle to the end's centre.
/// Height of the middle r + l cos a: its kinetic and potential energy give a'' (Lagrange).
struct FallingRod {
    double middle_m;  ///< l
    double inertia;   ///< about the middle, of 1 kg

    State<2> operator()(double, const State<2>& s) const {
        const double sine = std::sin(s[0]);
        const double cosine = std::cos(s[0]);
        const double mass = inertia + middle_m * middle_m * sine * sine;
        return {
            s[1],
            (kG_mps2 * middle_m * sine - middle_m * middle_m * sine * cosine * s[1] * s[1]) / mass};
    }
};

Scenario smooth_floor_rod() {
    static constexpr double kSeconds = 0.5;
    static constexpr double kFrom_rad = 10 * kPi_d / 180;
    return {.id = "A38 smooth rod",
            .title = "A rod falls over on ice",
            .set_up =
                "A thin rod of 1 m stands on one end, 10 degrees off the vertical, on a floor "
                "without friction.",
            .reference =
                "Lagrange's equation of its angle by Dormand-Prince and by Gauss-Legendre; its "
                "middle falls straight down",
            .tier = Tier::TwoIntegrators,
            .metrics = {{"angle at 0.5 s", "90 degrees"},
                        {"path of its middle to the side", "half the rod"}},
            .run = [](Stepper& stepper) -> Errors {
                ScenarioWorld world(stepper.setting());
                world.floor(0);
                const BodyId rod = leaning_rod(world, kFrom_rad, 0);
                const double start_m = world.at(rod).x;
                // The moment that the world itself uses: the shape's is no part of the law.
                const FallingRod law{
                    0.5 - kThin_m,
                    static_cast<double>(world.physics.state(rod).mass.inertia_kgm2.x)};
                const State<2> expected = reference(law, State<2>{kFrom_rad, 0}, 0, kSeconds);
                stepper.run(world, kSeconds);
                return {(lean_rad(world, rod) - expected[0]) / (kPi_d / 2),
                        (world.at(rod).x - start_m) / 0.5};
            }};
}

Scenario leaving_ball() {
    static constexpr double kBig_m = 1;
    static constexpr double kSmall_m = 0.1;
    static constexpr double kAround_m = kBig_m + kSmall_m;
    static constexpr double kFrom_rad = 10 * kPi_d / 180;
    static constexpr double kSeconds = 1;
    static const auto law = [](double, const State<2>& s) {
        return State<2>{s[1], kG_mps2 / kAround_m * std::sin(s[0])};
    };
    return {
        .id = "A38 ball leaves",
        .title = "A ball slides off a ball",
        .set_up =
            "A small smooth ball is let go 10 degrees off the top of a fixed one (1 m and "
            "0.1 m); it loses touch after about 0.9 s and falls.",
        .reference =
            "pendulum's equation on top by Dormand-Prince and Gauss-Legendre until "
            "cos a = 2/3 cos a0, then the parabola",
        .tier = Tier::TwoIntegrators,
        .metrics = {{"place at 1 s", "the sum of the radii, 1.1 m"},
                    {"speed at 1 s", "that of the fall"}},
        .run = [](Stepper& stepper) -> Errors {
            static const double leaves_rad = std::acos(2.0 / 3 * std::cos(kFrom_rad));
            // When it is there: halving the time.
            static const double leaves_s = threshold_of(0, 2, 48, [](double t_s) {
                return gauss_legendre(law, State<2>{kFrom_rad, 0}, 0, t_s, 1e-2)[0] >= leaves_rad;
            });
            static const State<2> then =
                reference(law, State<2>{kFrom_rad, 0}, 0, std::min(leaves_s, kSeconds));
            const double free_s = std::max(0.0, kSeconds - leaves_s);
            const Vec3d out{std::sin(then[0]), std::cos(then[0]), 0};
            const Vec3d along{std::cos(then[0]), -std::sin(then[0]), 0};
            const Vec3d velocity = along * (then[1] * kAround_m);
            const Vec3d fall{0, -kG_mps2, 0};
            const Vec3d expected =
                out * kAround_m + velocity * free_s + fall * (free_s * free_s / 2);
            const Vec3d speed = velocity + fall * free_s;

            ScenarioWorld world(stepper.setting());
            world.fixed_sphere({0, 0, 0}, kBig_m, {.friction = 0});
            const BodyId ball =
                world.sphere(Vec3d{std::sin(kFrom_rad), std::cos(kFrom_rad), 0} * kAround_m,
                             kSmall_m,
                             {.friction = 0});
            stepper.run(world, kSeconds);
            return {glm::distance(world.at(ball), expected) / kAround_m,
                    glm::distance(world.velocity(ball), speed) / glm::length(speed)};
        }};
}

Scenario ladder() {
    static constexpr double kSeconds = 0.3;
    return {
        .id = "A38 ladder",
        .title = "A ladder slides down a wall",
        .set_up =
            "A thin rod of 1 m leans at 60 degrees between a smooth floor and a smooth wall and "
            "is let go; it leaves the wall after 0.325 s.",
        .reference = "a'' = g b sin a / (I/m + b^2) by Dormand-Prince and by Gauss-Legendre",
        .tier = Tier::TwoIntegrators,
        .metrics = {{"angle at 0.3 s", "90 degrees"},
                    {"place of its middle at 0.3 s", "half the rod"}},
        .run = [](Stepper& stepper) -> Errors {
            ScenarioWorld world(stepper.setting());
            world.floor(0);
            world.fixed_box({-1 - kThin_m, 0, 0}, {2, 8, 8}, {.friction = 0});
            // Ends' centres at (0, y) and (x, 0) of a corner moved by the ends' radius.
            const double half_m = 0.5 - kThin_m;
            const double lean = 30 * kPi_d / 180;  // from the wall
            const BodyId rod = world.add(
                physics::BodyKind::Dynamic,
                physics::CapsuleShape{.radius_m = real(kThin_m), .height_m = real(2 * half_m)},
                {half_m * std::sin(lean), kThin_m + half_m * std::cos(lean), 0},
                {.friction = 0, .turn = glm::angleAxis(lean, Vec3d{0, 0, 1})});
            const double inertia =
                static_cast<double>(world.physics.state(rod).mass.inertia_kgm2.x);
            const auto law = [&](double, const State<2>& s) {
                return State<2>{s[1],
                                kG_mps2 * half_m * std::sin(s[0]) / (inertia + half_m * half_m)};
            };
            const State<2> expected = reference(law, State<2>{lean, 0}, 0, kSeconds);
            stepper.run(world, kSeconds);
            const Vec3d middle{
                half_m * std::sin(expected[0]), kThin_m + half_m * std::cos(expected[0]), 0};
            return {(-lean_rad(world, rod) - expected[0]) / (kPi_d / 2),
                    glm::distance(world.at(rod), middle) / 0.5};
        }};
}

}  // namespace

std::vector<Scenario> leaving_family() {
    return {smooth_floor_rod(), ladder(), leaving_ball()};
}

}  // namespace plumbline::study
