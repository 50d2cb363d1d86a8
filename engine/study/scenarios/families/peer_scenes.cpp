// Scenes that other engines were measured on too (assets/data/README.md), with figures of the same
// meaning: the names of their first metrics are those of report/peers.cpp.
#include "engine/core/pose.h"
#include "engine/study/angle_between.h"
#include "engine/study/scenarios/families/rolling.h"
#include "engine/study/scenarios/families/tops.h"
#include "engine/study/scenarios/world/peer_scene.h"

#include <fmt/format.h>

#include <array>

namespace plumbline::study {
namespace {

using physics::BodyId;

// --- chains: 50 links of 0.4 m and 1 kg from y = 30 m, 100 kg at the end ---

constexpr std::size_t kLinks = 50;
constexpr double kLink_m = 0.4;
constexpr double kChain_m = kLinks * kLink_m;
constexpr double kAnchor_m = 30;
constexpr double kBall_m = 0.25;
constexpr double kChain_s = 20;

/// Sum of the gaps at the joints, relative to the chain's length.
double stretch(const PeerScene& chain, const Vec3d& along) {
    double sum_m = 0;
    Vec3d before{0, kAnchor_m, 0};
    const std::vector<BodyId>& bodies = chain.world.movers;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const double half_m = i < kLinks ? kLink_m / 2 : kBall_m;
        const Vec3d to_end = chain.world.turn(bodies[i]) * (along * half_m);
        sum_m += glm::length(chain.world.at(bodies[i]) - to_end - before);
        before = chain.world.at(bodies[i]) + to_end;
    }
    return sum_m / kChain_m;
}

Errors run_chain(const std::string& name, Stepper& stepper, const Vec3d& along, bool at_end) {
    const auto opened = PeerScene::open(name, stepper.setting());
    if (!opened) return stepper.refuse(opened.error());
    PeerScene& chain = **opened;
    constexpr double kTail_s = 2;
    double most = 0;
    double tail = 0;
    int in_tail = 0;
    stepper.run(chain.world, kChain_s, {.after = [&](int i) {
                    const double now = stretch(chain, along);
                    most = std::max(most, now);
                    if ((i + 1) * chain.world.step_s() < kChain_s - kTail_s + 1e-9) return;
                    tail += now;
                    ++in_tail;
                }});
    return {at_end ? tail / std::max(1, in_tail) : most};
}

Scenario peer_chain(const std::string& name, bool hangs) {
    const Vec3d along = hangs ? Vec3d{0, -1, 0} : Vec3d{1, 0, 0};
    return {
        .id = fmt::format("P {}", name),
        .title = hangs ? "a chain of 50 links hangs with 100 kg at its end"
                       : "a chain of 50 links with 100 kg at its end swings down",
        .set_up = fmt::format(
            "50 links of 0.4 m and 1 kg, ball-and-socket joints, a ball of 100 kg at the end; {}, "
            "20 s.",
            hangs ? "hanging straight" : "released lying level"),
        .reference = "The links are rigid: no joint ever opens.",
        .tier = Tier::Conserved,
        .metrics = {{hangs ? "stretch at the end" : "largest stretch",
                     hangs ? "20 m; the gaps of all joints, mean of the last 2 s"
                           : "20 m; the gaps of all joints"}},
        .run = [name, along, hangs](
                   Stepper& stepper) { return run_chain(name, stepper, along, hangs); },
        .peer_scene = name,
        .knobs = {.most_hz = 240, .doubled = false}};
}

// --- a ball that bounces without loss ---

Errors run_bounce(Stepper& stepper) {
    const auto opened = PeerScene::open("bounce", stepper.setting());
    if (!opened) return stepper.refuse(opened.error());
    ScenarioWorld& world = (*opened)->world;
    const BodyId ball = (*opened)->body("ball");
    constexpr double kRadius_m = 0.5;
    const auto height_of = [&] { return world.at(ball).y - kRadius_m; };
    const double drop_m = height_of();
    double height_m = drop_m;
    double rise_mps = 0;
    double apex_m = 0;
    // The apex lies between two steps: the energy of the nearer one says how high.
    const auto energy_height = [](double at_m, double v) { return at_m + v * v / (2 * kG_mps2); };
    stepper.run(world, 60, {.after = [&](int) {
                    const double now_m = height_of();
                    const double now_mps = world.velocity(ball).y;
                    if (rise_mps > 0 && now_mps <= 0) {
                        apex_m = rise_mps < -now_mps ? energy_height(height_m, rise_mps)
                                                     : energy_height(now_m, now_mps);
                    }
                    height_m = now_m;
                    rise_mps = now_mps;
                }});
    const bool is_dead = height_m < 0.01 * drop_m && std::abs(rise_mps) < 0.1;
    return {is_dead ? 1.0 : apex_m / drop_m - 1};
}

// --- a ball that slides until it rolls ---

Errors run_slide_roll(Stepper& stepper) {
    constexpr SlideToRoll kLaw{.speed_mps = 5, .mu = 0.3};
    constexpr double kEnd_s = 3;
    const auto opened = PeerScene::open("slideroll", stepper.setting());
    if (!opened) return stepper.refuse(opened.error());
    ScenarioWorld& world = (*opened)->world;
    const BodyId ball = (*opened)->body("ball");
    double most_m = 0;
    stepper.run(world, kEnd_s, {.after = [&](int i) {
                    const double t_s = (i + 1) * world.step_s();
                    most_m = std::max(most_m, std::abs(world.at(ball).x - kLaw.path_m(t_s)));
                }});
    return {most_m / kLaw.path_m(kEnd_s), world.velocity(ball).x / kLaw.speed_at_mps(kEnd_s) - 1};
}

// --- a T-handle that turns about its middle axis ---

Errors run_handle(Stepper& stepper) {
    constexpr double kSeen_s = 10;
    static const FreeBodyDef def = t_handle();
    static const TurningBody expected =
        turned_for({.own_spin_radps = def.spin_radps}, *def.inertia_kgm2, kSeen_s);
    const auto opened = PeerScene::open("dzhani", stepper.setting());
    if (!opened) return stepper.refuse(opened.error());
    ScenarioWorld& world = (*opened)->world;
    const BodyId handle = (*opened)->body("handle");
    const Vec3d inertia = *def.inertia_kgm2;
    const Vec3d momentum = inertia * def.spin_radps;
    const double energy = glm::dot(def.spin_radps, momentum);
    double turned_rad = kPi_d;
    double most_energy = 0;
    double most_momentum = 0;
    const double step_s = world.step_s();
    stepper.run(world, 60, {.after = [&](int i) {
                    const auto [turn, spin] = turning_body(world, handle);
                    const Vec3d now = inertia * spin;
                    most_energy = std::max(most_energy, std::abs(glm::dot(spin, now) / energy - 1));
                    most_momentum = std::max(
                        most_momentum, glm::length(turn * now - momentum) / glm::length(momentum));
                    if (std::abs((i + 1) * step_s - kSeen_s) < step_s / 4)
                        turned_rad = angle_between_rad(turn, expected.turn);
                }});
    return {turned_rad / kPi_d, most_energy, most_momentum};
}

// --- a heavy cube on a light one ---

/// How deep corners of one cube of edge 1 m lie below the other's top.
double depth_m(const ScenarioWorld& world, BodyId upper, BodyId lower) {
    double deepest_m = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3d own{(corner & 1) != 0 ? 0.5 : -0.5,
                        (corner & 2) != 0 ? 0.5 : -0.5,
                        (corner & 4) != 0 ? 0.5 : -0.5};
        const Vec3d corner_m = world.at(upper) + world.turn(upper) * own;
        deepest_m = std::max(deepest_m, -corner_m.y);  // the ground
        if (lower == upper) continue;
        const Vec3d in_lower = glm::conjugate(world.turn(lower)) * (corner_m - world.at(lower));
        const bool is_above = std::max(std::abs(in_lower.x), std::abs(in_lower.z)) < 0.51;
        if (is_above && in_lower.y > -0.5) deepest_m = std::max(deepest_m, 0.5 - in_lower.y);
    }
    return deepest_m;
}

Errors run_heavy(const std::string& name, Stepper& stepper) {
    constexpr double kLandedAfter_s = 1;
    const auto opened = PeerScene::open(name, stepper.setting());
    if (!opened) return stepper.refuse(opened.error());
    ScenarioWorld& world = (*opened)->world;
    const BodyId lower = (*opened)->body("lower");
    const BodyId upper = (*opened)->body("upper");
    double most_m = 0;
    stepper.run(
        world, 10, {.after = [&](int i) {
            if ((i + 1) * world.step_s() <= kLandedAfter_s) return;
            most_m = std::max({most_m, depth_m(world, lower, lower), depth_m(world, upper, lower)});
        }});
    // One that has fallen off sinks into nothing any more.
    constexpr double kFallen_m = 0.45;
    if (1.5 - world.at(upper).y > kFallen_m) most_m = std::max(most_m, 1.0);
    return {most_m, (world.at(upper).y - 1.5) / 1.5};
}

Scenario peer_heavy(int ratio) {
    const std::string name = fmt::format("heavy{}", ratio);
    return {.id = "P " + name,
            .title = fmt::format("a cube with one {} times as heavy on it", ratio),
            .set_up = "Two cubes of 1 m, the lower of 1000 kg, friction 0.6; 10 s.",
            .reference = "Rigid cubes do not sink into each other.",
            .tier = Tier::Conserved,
            .metrics = {{"largest penetration",
                         "an edge, 1 m; after the first second; fallen off: all of it"},
                        {"height of the upper cube", "1.5 m"}},
            .run = [name](Stepper& stepper) { return run_heavy(name, stepper); },
            .peer_scene = name,
            .knobs = {.most_hz = 480, .doubled = false}};
}

}  // namespace

std::vector<Scenario> peer_scenes_family() {
    return {{.id = "P bounce",
             .title = "a ball falls 10 m and bounces without loss for 60 s",
             .set_up = "A ball of 0.5 m, 1000 kg, restitution 1, frictionless, falls 10 m.",
             .reference = "It comes back to 10 m, for ever.",
             .tier = Tier::Conserved,
             .metrics = {{"last apex", "10 m"}},
             .run = run_bounce,
             .peer_scene = "bounce",
             .knobs = {.doubled = false}},
            peer_chain("chainh", false),
            peer_chain("chainv", true),
            {.id = "P dzhani",
             .title = "a T-handle turns about its middle axis",
             .set_up =
                 "56 kg, moments of inertia 1.562, 3.573, 4.762 kg m2, spin (0.01, 5, 0.01) rad/s, "
                 "weightless, 60 s.",
             .reference = "Euler's equations by two integrators.",
             .tier = Tier::TwoIntegrators,
             .metrics = {{"orientation at 10 s", "half a turn"},
                         {"energy", "its start"},
                         {"angular momentum", "its start"}},
             .run = run_handle,
             .peer_scene = "dzhani",
             .knobs = {.iterations = false, .doubled = false}},
            peer_heavy(100),
            peer_heavy(1000),
            {.id = "P slideroll",
             .title = "a ball slides until it rolls",
             .set_up = "A ball of 0.5 m, 500 kg, at 5 m/s without spin, friction 0.3; 3 s.",
             .reference = "v = v0 - mu g t until t = 2 v0 / (7 mu g), then 5/7 v0.",
             .tier = Tier::ClosedForm,
             .metrics = {{"place", "the path, 11.0610 m; the largest of all steps"},
                         {"speed at the end", "5/7 of 5 m/s"}},
             .run = run_slide_roll,
             .peer_scene = "slideroll",
             .knobs = {.doubled = false}}};
}

}  // namespace plumbline::study
