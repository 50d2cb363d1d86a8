// Drag, wind and the lift of what spins.
#include "engine/study/fields/field_reference.h"
#include "engine/study/fields/field_world.h"

#include <cmath>

namespace plumbline::study {
namespace {

constexpr double kFallingRadius_m = 0.1;
constexpr double kFallingMass_kg = 0.4;
constexpr double kRho_kgpm3 = 1.204;
constexpr double kCoefficient = 0.47;
constexpr double kArea_m2 = kPi_rad * kFallingRadius_m * kFallingRadius_m;
/// Of v' = -k v2, 1/m.
constexpr double kLoss_pm = 0.5 * kRho_kgpm3 * kCoefficient * kArea_m2 / kFallingMass_kg;

scene::SceneDescription ball_in_air(scene::Fidelity fidelity, double gravity_mps2) {
    scene::SceneDescription scene;
    scene.forces.fidelity.drag = fidelity;
    scene.gravity_mps2 = {0, static_cast<Real>(-gravity_mps2), 0};
    scene.entities.push_back(ball_of("ball", {0, 0, 0}, kFallingRadius_m, kFallingMass_kg));
    scene.entities.front().body->drag = scene::Drag{.coefficient = Real{0.47_r}};
    return scene;
}

FieldOutcome falls_as_tanh(scene::Fidelity fidelity) {
    FieldWorld world(ball_in_air(fidelity, kFieldGravity_mps2));
    const double terminal_mps = std::sqrt(kFieldGravity_mps2 / kLoss_pm);
    double error = 0;
    while (world.time_s() < 4) {
        world.step();
        const double exact_mps =
            terminal_mps * std::tanh(kFieldGravity_mps2 * world.time_s() / terminal_mps);
        error = std::max(error, std::abs(-world.velocity_mps("ball").y / exact_mps - 1));
    }
    return {error, world.cpu_ms_per_s()};
}

FieldOutcome reaches_terminal_speed(scene::Fidelity fidelity) {
    FieldWorld world(ball_in_air(fidelity, kFieldGravity_mps2));
    world.run_to(30);
    const double terminal_mps = std::sqrt(kFieldGravity_mps2 / kLoss_pm);
    return {std::abs(-world.velocity_mps("ball").y / terminal_mps - 1), world.cpu_ms_per_s()};
}

FieldOutcome is_carried_by_wind(scene::Fidelity fidelity) {
    scene::SceneDescription scene = ball_in_air(fidelity, 0);
    constexpr double kWind_mps = 10;
    scene.wind = scene::WindDescription{.speed_mps = Real{kWind_mps}, .gusts = 0};
    FieldWorld world(scene);
    world.run_to(5);
    const double exact_mps = kWind_mps * (1 - 1 / (1 + kLoss_pm * kWind_mps * world.time_s()));
    return {std::abs(world.velocity_mps("ball").x / exact_mps - 1), world.cpu_ms_per_s()};
}

/// 1000 m/s on a gram: bounded, and the closed form.
FieldOutcome survives_a_storm(scene::Fidelity fidelity) {
    scene::SceneDescription scene = ball_in_air(fidelity, 0);
    scene.entities.front().body->mass_kg = 1e-3_r;
    scene.forces.wind_zones.push_back(
        {.min_m = {-5000, -1, -1}, .max_m = {5000, 1, 1}, .velocity_mps = {1000, 0, 0}});
    FieldWorld world(scene);
    world.run_to(0.5);
    const double loss_pm = kLoss_pm * kFallingMass_kg / 1e-3;
    const double exact_mps = 1000 * (1 - 1 / (1 + loss_pm * 1000 * world.time_s()));
    return {std::abs(world.velocity_mps("ball").x / exact_mps - 1), world.cpu_ms_per_s()};
}

/// Without gravity and drag the force S w x v leads round a circle in 2 pi m / (S w).
FieldOutcome lift_leads_round(scene::Fidelity fidelity) {
    scene::SceneDescription scene = ball_in_air(fidelity, 0);
    constexpr double kSpin_radps = 50;
    scene::BodyDescription& body = *scene.entities.front().body;
    body.drag = scene::Drag{.coefficient = 0, .spin_lift = 1};
    body.velocity_mps = {10, 0, 0};
    body.angular_velocity_radps = {0, Real{kSpin_radps}, 0};
    const double lift_kg = 0.5 * kRho_kgpm3 * kArea_m2 * kFallingRadius_m;
    const double turn_s = kFallingMass_kg / (lift_kg * kSpin_radps);  // for a radian
    FieldWorld world(scene);
    double error = 0;
    while (world.time_s() < 6) {
        world.step();
        const double turned = world.time_s() / turn_s;
        const Vec3d exact{10 * std::cos(turned), 0, -10 * std::sin(turned)};
        error = std::max(error, glm::distance(world.velocity_mps("ball"), exact) / 10);
    }
    return {error, world.cpu_ms_per_s()};
}

/// A plate 1 x 1 x 0.02 m, its edge to the stream, 30 degrees to it and across: m2 / 1.
FieldOutcome pushes_by_silhouette(scene::Fidelity fidelity) {
    double error = 0;
    double cpu_ms_per_s = 0;
    for (const double angle_deg : {0.0, 30.0, 90.0}) {
        scene::SceneDescription scene = ball_in_air(fidelity, 0);
        scene.entities.front() = box_of("ball", {0, 0, 0}, {0.02_r, 1, 1}, 5);
        scene.entities.front().world_from_body.orientation =
            quat_from_euler_deg({0, static_cast<Real>(90 - angle_deg), 0});
        scene.entities.front().body->drag = scene::Drag{.coefficient = 1.18_r};
        scene.entities.front().body->velocity_mps = {20, 0, 0};
        FieldWorld world(scene);
        world.run_to(0.5);
        const double angle = radians_from_degrees(angle_deg);
        const double area_m2 = std::sin(angle) + 0.02 * std::cos(angle);
        const double loss_pm = 0.5 * kRho_kgpm3 * 1.18 * area_m2 / 5;
        const double exact_mps = 20 - 20 / (1 + loss_pm * 20 * world.time_s());
        error = std::max(error, std::abs((20 - world.velocity_mps("ball").x) / exact_mps - 1));
        cpu_ms_per_s += world.cpu_ms_per_s() / 3;
    }
    return {error, cpu_ms_per_s};
}

/// Filled with helium: (rho V - m) g lifts the ball and half as much air as it displaces.
FieldOutcome rises_as_tanh(scene::Fidelity fidelity) {
    constexpr double kMass_kg = 1.5e-3;
    scene::SceneDescription scene = ball_in_air(fidelity, kFieldGravity_mps2);
    scene.entities.front().body->mass_kg = static_cast<Real>(kMass_kg);
    scene.entities.front().body->drag->buoyant = true;
    FieldWorld world(scene);
    const double displaced_kg =
        kRho_kgpm3 * 4.0 / 3 * kPi_rad * kFallingRadius_m * kFallingRadius_m * kFallingRadius_m;
    const double lift_N = (displaced_kg - kMass_kg) * kFieldGravity_mps2;
    const double terminal_mps = std::sqrt(lift_N / (0.5 * kRho_kgpm3 * kCoefficient * kArea_m2));
    const double gain_mps2 = lift_N / (kMass_kg + displaced_kg / 2);
    double error = 0;
    while (world.time_s() < 4) {
        world.step();
        const double exact_mps =
            terminal_mps * std::tanh(gain_mps2 * world.time_s() / terminal_mps);
        error = std::max(error, std::abs(world.velocity_mps("ball").y / exact_mps - 1));
    }
    return {error, world.cpu_ms_per_s()};
}

constexpr std::array<FieldReference, 7> kAirReferences{
    {{"drag", "a fall", "v = vt tanh(g t / vt)", kByFidelity, &falls_as_tanh},
     {"drag", "terminal speed", "sqrt(2 m g / (rho Cd A))", kByFidelity, &reaches_terminal_speed},
     {"drag", "wind from rest", "w (1 - 1 / (1 + k w t))", kByFidelity, &is_carried_by_wind},
     {"drag", "1000 m/s on a gram", "w (1 - 1 / (1 + k w t))", kByFidelity, &survives_a_storm},
     {"drag", "lift of a spin", "a circle in 2 pi m / (S w)", kByFidelity, &lift_leads_round},
     {"drag", "a plate's silhouette", "A sin(angle)", kByFidelity, &pushes_by_silhouette},
     {"drag",
      "a balloon's rise",
      "vt tanh(F t / ((m + rho V / 2) vt))",
      kByFidelity,
      &rises_as_tanh}}};

}  // namespace

std::span<const FieldReference> air_references() {
    return kAirReferences;
}

}  // namespace plumbline::study
