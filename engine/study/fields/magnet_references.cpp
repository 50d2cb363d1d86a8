// Dipoles.
#include "engine/physics/totals.h"
#include "engine/study/fields/field_reference.h"
#include "engine/study/fields/field_world.h"

#include <cmath>

namespace plumbline::study {
namespace {

constexpr double kMu0 = 4e-7 * kPi_rad;
constexpr double kMoment_Am2 = 5;
constexpr double kMagnetMass_kg = 0.1;
constexpr double kMagnetRadius_m = 0.02;

scene::EntityDescription magnet_of(const std::string& name,
                                   const Vec3& position_m,
                                   const Vec3& moment_Am2) {
    scene::EntityDescription magnet = ball_of(name, position_m, kMagnetRadius_m, kMagnetMass_kg);
    magnet.body->magnet = scene::Magnet{moment_Am2};
    return magnet;
}

scene::SceneDescription magnets_of(scene::Fidelity fidelity,
                                   std::vector<scene::EntityDescription> magnets) {
    scene::SceneDescription scene;
    scene.forces.fidelity.magnets = fidelity;
    scene.gravity_mps2 = {0, 0, 0};
    scene.entities = std::move(magnets);
    return scene;
}

/// The first step's change of speed against the force that acts along it.
FieldOutcome pulls_by(scene::Fidelity fidelity, const Vec3& apart_m, double exact_N) {
    const Vec3 moment{0, 0, Real{kMoment_Am2}};
    FieldWorld world(
        magnets_of(fidelity, {magnet_of("a", {0, 0, 0}, moment), magnet_of("b", apart_m, moment)}));
    world.step();
    const Vec3d along = glm::normalize(Vec3d(apart_m));
    const double force_N =
        glm::dot(world.velocity_mps("a"), along) * kMagnetMass_kg / world.time_s();
    return {std::abs(force_N / exact_N - 1), world.cpu_ms_per_s()};
}

double coaxial_N(double apart_m) {
    return 3 * kMu0 * kMoment_Am2 * kMoment_Am2 / (2 * kPi_rad * std::pow(apart_m, 4));
}

FieldOutcome pulls_in_line(scene::Fidelity fidelity) {
    return pulls_by(fidelity, {0, 0, 0.2_r}, coaxial_N(0.2));
}

FieldOutcome pushes_side_by_side(scene::Fidelity fidelity) {
    return pulls_by(fidelity, {0.2_r, 0, 0}, -coaxial_N(0.2) / 2);
}

FieldOutcome needle_swings(scene::Fidelity fidelity) {
    constexpr double kField_T = 0.01;
    constexpr double kAngle_rad = 0.01;
    scene::SceneDescription scene =
        magnets_of(fidelity,
                   {magnet_of("needle",
                              {0, 0, 0},
                              {static_cast<Real>(kMoment_Am2 * std::cos(kAngle_rad)),
                               0,
                               static_cast<Real>(kMoment_Am2 * std::sin(kAngle_rad))})});
    scene.forces.magnetic_field_T = {static_cast<Real>(kField_T), 0, 0};
    const double inertia_kgm2 = 0.4 * kMagnetMass_kg * kMagnetRadius_m * kMagnetRadius_m;
    const double exact_s = 2 * kPi_rad * std::sqrt(inertia_kgm2 / (kMoment_Am2 * kField_T));
    FieldWorld world(scene);
    const double swing_s = period_s(world, 4, [&world] {
        return static_cast<double>(world.state("needle").angular_velocity_radps.y);
    });
    return {std::abs(swing_s / exact_s - 1), world.cpu_ms_per_s()};
}

/// Two that come together and turn, until just before they touch.
FieldWorld free_pair(scene::Fidelity fidelity) {
    return FieldWorld(magnets_of(fidelity,
                                 {magnet_of("a", {0, 0, 0}, {0, 2, 1}),
                                  magnet_of("b", {0.15_r, 0.03_r, 0.02_r}, {1, 0, 2})}));
}

FieldOutcome pair_keeps_energy(scene::Fidelity fidelity) {
    FieldWorld world = free_pair(fidelity);
    const double start_J = world.energy_J();
    double most_J = 0;
    double error_J = 0;
    while (world.time_s() < 1.2) {
        world.step();
        most_J = std::max(most_J, physics::energy(world.simulation().physics).kinetic_J);
        error_J = std::max(error_J, std::abs(world.energy_J() - start_J));
    }
    return {error_J / most_J, world.cpu_ms_per_s()};
}

FieldOutcome pair_keeps_angular_momentum(scene::Fidelity fidelity) {
    FieldWorld world = free_pair(fidelity);
    double spin = 0;
    while (world.time_s() < 1.2) {
        world.step();
        const double inertia_kgm2 = 0.4 * kMagnetMass_kg * kMagnetRadius_m * kMagnetRadius_m;
        spin = std::max(spin,
                        inertia_kgm2 * static_cast<double>(
                                           glm::length(world.state("a").angular_velocity_radps)));
    }
    const Vec3d momentum = physics::angular_momentum_kgm2ps(world.simulation().physics);
    return {glm::length(momentum) / spin, world.cpu_ms_per_s()};
}

constexpr std::array<FieldReference, 5> kMagnetReferences{
    {{"magnets", "pull in line", "3 mu0 m1 m2 / (2 pi r4)", kByFidelity, &pulls_in_line},
     {"magnets", "push side by side", "half of that", kByFidelity, &pushes_side_by_side},
     {"magnets", "a needle's swing", "2 pi sqrt(I / (m B))", kByFidelity, &needle_swings},
     {"magnets", "energy of a free pair", "kept", {0.2, 0.01, 0.001}, &pair_keeps_energy},
     {"magnets",
      "angular momentum of a free pair",
      "none",
      {1e-4, 1e-4, 1e-4},
      &pair_keeps_angular_momentum}}};

}  // namespace

std::span<const FieldReference> magnet_references() {
    return kMagnetReferences;
}

}  // namespace plumbline::study
