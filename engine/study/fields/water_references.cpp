// Level water: what floats, and how.
#include "engine/scene/environment/wave_field.h"
#include "engine/study/fields/field_reference.h"
#include "engine/study/fields/field_world.h"

#include <cmath>

namespace plumbline::study {
namespace {

constexpr double kWater_kgpm3 = 1000;

scene::SceneDescription pond_with(scene::Fidelity fidelity,
                                  double drag,
                                  const scene::EntityDescription& body) {
    scene::SceneDescription scene;
    scene.forces.fidelity.buoyancy = fidelity;
    scene.gravity_mps2 = {0, static_cast<Real>(-kFieldGravity_mps2), 0};
    scene.forces.waters.push_back({.name = "pond",
                                   .min_m = {-5, -60, -5},
                                   .max_m = {5, 0, 5},
                                   .drag = static_cast<Real>(drag)});
    scene.entities.push_back(body);
    return scene;
}

/// A box of 1 x 0.4 x 1 m.
scene::EntityDescription flat_box(double density_kgpm3, double y_m) {
    return box_of("box", {0, static_cast<Real>(y_m), 0}, {1, 0.4_r, 1}, density_kgpm3 * 0.4);
}

FieldOutcome box_draws(scene::Fidelity fidelity) {
    FieldWorld world(pond_with(fidelity, 1, flat_box(300, 0.3)));
    world.run_to(30);
    return {std::abs((0.2 - world.position_m("box").y) / 0.12 - 1), world.cpu_ms_per_s()};
}

FieldOutcome box_heaves(scene::Fidelity fidelity) {
    FieldWorld world(pond_with(fidelity, 0, flat_box(500, 0.05)));
    const double heave_s = period_s(world, 10, [&world] { return world.velocity_mps("box").y; });
    return {std::abs(heave_s / (2 * kPi_rad * std::sqrt(0.2 / kFieldGravity_mps2)) - 1),
            world.cpu_ms_per_s()};
}

FieldOutcome heave_keeps_energy(scene::Fidelity fidelity) {
    FieldWorld world(pond_with(fidelity, 0, flat_box(500, 0.05)));
    const double start_J = world.energy_J();
    double error_J = 0;
    while (world.time_s() < 60) {
        world.step();
        error_J = std::max(error_J, std::abs(world.energy_J() - start_J));
    }
    const double swing_J = 0.5 * kWater_kgpm3 * kFieldGravity_mps2 * 0.05 * 0.05;
    return {error_J / swing_J, world.cpu_ms_per_s()};
}

/// 1 x 0.2 x 1 m, half under: GM = 1/1.2 + 0.05 - 0.1 m.
FieldOutcome box_rolls(scene::Fidelity fidelity) {
    scene::EntityDescription box = box_of("box", {0, 0, 0}, {1, 0.2_r, 1}, 100);
    box.world_from_body.orientation = quat_from_euler_deg({0, 0, 0.5_r});
    const double metacentric_m = 1.0 / 12 / 0.1 - 0.05;
    const double inertia_kgm2 = 100.0 / 12 * (1 + 0.04);
    const double exact_s =
        2 * kPi_rad * std::sqrt(inertia_kgm2 / (100 * kFieldGravity_mps2 * metacentric_m));
    FieldWorld world(pond_with(fidelity, 0, box));
    const double roll_s = period_s(world, 10, [&world] {
        return static_cast<double>(world.state("box").angular_velocity_radps.z);
    });
    return {std::abs(roll_s / exact_s - 1), world.cpu_ms_per_s()};
}

/// A quarter as dense as water: the cap pi h2 (3 r - h) / 3 is a quarter of the ball.
FieldOutcome ball_draws(scene::Fidelity fidelity) {
    const double volume_m3 = 4.0 / 3 * kPi_rad * 0.125;
    FieldWorld world(pond_with(fidelity, 1, ball_of("ball", {0, 0.3_r, 0}, 0.5, 250 * volume_m3)));
    world.run_to(30);
    const double draft_m = 0.5 - world.position_m("ball").y;
    double low = 0;
    double high = 0.5;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        const double cap_m3 = kPi_rad * middle * middle * (1.5 - middle) / 3;
        (cap_m3 < volume_m3 / 4 ? low : high) = middle;
    }
    return {std::abs(draft_m / low - 1), world.cpu_ms_per_s()};
}

/// Tip down: draft = height (density share)^(1/3).
FieldOutcome cone_draws(scene::Fidelity fidelity) {
    scene::EntityDescription cone = ball_of("cone", {0, 0, 0}, 1, 300 * kPi_rad / 3);
    cone.visual = scene::Primitive{physics::ConeShape{.radius_m = 1, .height_m = 1}};
    cone.world_from_body.orientation = quat_from_euler_deg({180, 0, 0});
    cone.body->center_of_mass_m = Vec3{0, 0.4_r, 0};
    FieldWorld world(pond_with(fidelity, 1, cone));
    world.run_to(40);
    return {std::abs((0.5 - world.position_m("cone").y) / std::cbrt(0.3) - 1),
            world.cpu_ms_per_s()};
}

FieldOutcome ball_rises(scene::Fidelity fidelity) {
    const double volume_m3 = 4.0 / 3 * kPi_rad * 1e-3;
    scene::EntityDescription ball = ball_of("ball", {0, -50, 0}, 0.1, 200 * volume_m3);
    ball.body->drag = scene::Drag{.coefficient = 0.47_r};
    FieldWorld world(pond_with(fidelity, 1, ball));
    world.run_to(5);
    const double exact_mps = std::sqrt(2 * 800 * volume_m3 * kFieldGravity_mps2 /
                                       (kWater_kgpm3 * 0.47 * kPi_rad * 0.01));
    return {std::abs(world.velocity_mps("ball").y / exact_mps - 1), world.cpu_ms_per_s()};
}

/// What moves along makes it slower to start: (rho - rho_b) g / (rho_b + rho / 2).
FieldOutcome added_mass_slows(scene::Fidelity fidelity) {
    const double volume_m3 = 4.0 / 3 * kPi_rad * 1e-3;
    scene::EntityDescription ball = ball_of("ball", {0, -50, 0}, 0.1, 200 * volume_m3);
    ball.body->drag = scene::Drag{.coefficient = 0};
    FieldWorld world(pond_with(fidelity, 1, ball));
    world.step();
    const double exact_mps2 = 800 * kFieldGravity_mps2 / (200 + 500);
    return {std::abs(world.velocity_mps("ball").y / world.time_s() / exact_mps2 - 1),
            world.cpu_ms_per_s()};
}

/// Still water carries what does not sink; what flows, it takes along.
FieldOutcome stream_carries(scene::Fidelity fidelity) {
    scene::SceneDescription scene = pond_with(fidelity, 1, flat_box(500, 0));
    scene.forces.waters.front().min_m.x = -500;
    scene.forces.waters.front().max_m.x = 500;
    scene.forces.waters.front().flow_mps = {1, 0, 0};
    FieldWorld world(scene);
    world.run_to(60);
    // v' = k (1 - v)2: the wetted end is 0.2 x 1 m2, half of what moves along is the water's.
    const double loss_pm = 0.5 * kWater_kgpm3 * 0.2 / (200 + 0.5 * 200);
    const double exact_mps = 1 - 1 / (1 + loss_pm * world.time_s());
    return {std::abs(world.velocity_mps("box").x / exact_mps - 1), world.cpu_ms_per_s()};
}

/// 0.3 x 1 x 0.3 m upright has a negative metacentric height, and lies down; 1 x 0.2 x 1 m stays.
FieldOutcome turns_over_as_it_must(scene::Fidelity fidelity) {
    scene::EntityDescription tall = box_of("tall", {-2, 0, 0}, {0.3_r, 1, 0.3_r}, 45);
    tall.world_from_body.orientation = quat_from_euler_deg({0, 0, 1});
    scene::SceneDescription scene = pond_with(fidelity, 1, tall);
    scene::EntityDescription flat = box_of("flat", {2, 0, 0}, {1, 0.2_r, 1}, 100);
    flat.world_from_body.orientation = quat_from_euler_deg({0, 0, 20});
    scene.entities.push_back(flat);
    FieldWorld world(scene);
    world.run_to(20);
    const auto upright = [&world](const char* name) {
        return std::abs(
            static_cast<double>((world.state(name).world_from_body.orientation * Vec3{0, 1, 0}).y));
    };
    return {std::max(upright("tall"), 1 - upright("flat")), world.cpu_ms_per_s()};
}

/// The first wave along a basin of 10 x 10 x 2 m: where its probe stands, and its energy.
FieldOutcome seiche_swings(scene::Fidelity fidelity) {
    scene::SceneDescription scene = pond_with(fidelity, 1, ball_of("ball", {0, 50, 0}, 0.1, 1));
    scene.forces.fidelity.water = fidelity;
    scene.entities.clear();
    scene::WaterDescription& pond = scene.forces.waters.front();
    pond.min_m.y = -2;
    pond.surface = scene::WaterSurface::Waves;
    pond.start = {.amplitude_m = 0.02_r, .nx = 1, .nz = 0};
    FieldWorld world(scene);
    const double k = kPi_rad / 10;
    const double omega = std::sqrt(kFieldGravity_mps2 * k * std::tanh(2 * k));
    double error_m = 0;
    while (world.time_s() < 20) {
        world.step();
        const double exact_m = 0.02 * std::cos(omega * world.time_s());
        const double found_m = world.simulation().waters.front().waves->height_m(-5, 0);
        error_m = std::max(error_m, std::abs(found_m - exact_m));
    }
    return {error_m / 0.02, world.cpu_ms_per_s()};
}

/// What sinks in raises the mean level by its volume over the basin's area.
FieldOutcome sinking_raises_the_level(scene::Fidelity fidelity) {
    scene::SceneDescription scene =
        pond_with(fidelity, 1, ball_of("ball", {0, 0.6_r, 0}, 0.5, 2000));
    scene.forces.fidelity.water = fidelity;
    scene.forces.waters.front().surface = scene::WaterSurface::Waves;
    FieldWorld world(scene);
    world.run_to(2);
    const double exact_m = 4.0 / 3 * kPi_rad * 0.125 / 100;
    return {std::abs(world.simulation().waters.front().waves->range().mean_m / exact_m - 1),
            world.cpu_ms_per_s()};
}

/// A float let go 5 cm too high: nothing of what it had may have grown after a minute.
FieldOutcome waves_take_no_energy_from_nowhere(scene::Fidelity fidelity) {
    scene::SceneDescription scene = pond_with(fidelity, 0, flat_box(500, 0.05));
    scene.forces.fidelity.water = fidelity;
    scene.entities.front().world_from_body.position.x = 1;
    scene.forces.waters.front().surface = scene::WaterSurface::Waves;
    FieldWorld world(scene);
    const double start_J = world.energy_J();
    const auto gain_J = [&] {
        const scene::WaveField& waves = *world.simulation().waters.front().waves;
        return world.energy_J() + waves.energy_J() + waves.raised_J() - start_J;
    };
    double most_J = 0;
    while (world.time_s() < 60) {
        world.step();
        most_J = std::max(most_J, gain_J());
    }
    const double swing_J = 0.5 * kWater_kgpm3 * kFieldGravity_mps2 * 0.05 * 0.05;
    return {most_J / swing_J, world.cpu_ms_per_s()};
}

/// Floats fall asleep on their last millimetres.
constexpr std::array kRestTolerance{0.01, 0.01, 0.005};

constexpr std::array<FieldReference, 13> kWaterReferences{
    {{"buoyancy", "draft of a box", "height rho_b / rho", kRestTolerance, &box_draws},
     {"buoyancy", "draft of a ball", "the cap's volume", kRestTolerance, &ball_draws},
     {"buoyancy", "draft of a cone, tip down", "H s^(1/3)", kRestTolerance, &cone_draws},
     {"buoyancy", "heave", "2 pi sqrt(draft / g)", kByFidelity, &box_heaves},
     {"buoyancy", "energy of 60 s of heave", "kept", kByFidelity, &heave_keeps_energy},
     {"buoyancy", "roll", "2 pi sqrt(I / (m g GM))", kByFidelity, &box_rolls},
     {"buoyancy",
      "rise of a light ball",
      "sqrt(2 (rho - rho_b) V g / (rho C A))",
      kByFidelity,
      &ball_rises},
     {"buoyancy",
      "its start",
      "(rho - rho_b) g / (rho_b + rho / 2)",
      kByFidelity,
      &added_mass_slows},
     {"buoyancy", "carried by a stream", "w (1 - 1 / (1 + k w t))", kByFidelity, &stream_carries},
     {"water", "seiche", "omega2 = g k tanh(k H)", kByFidelity, &seiche_swings},
     {"water", "level over what sinks", "V / A", kByFidelity, &sinking_raises_the_level},
     {"water",
      "energy of a float and its waves",
      "never grows",
      {0.3, 0.3, 0.3},
      &waves_take_no_energy_from_nowhere},
     {"buoyancy",
      "turning over",
      "where GM < 0, and only there",
      kByFidelity,
      &turns_over_as_it_must}}};

}  // namespace

std::span<const FieldReference> water_references() {
    return kWaterReferences;
}

}  // namespace plumbline::study
