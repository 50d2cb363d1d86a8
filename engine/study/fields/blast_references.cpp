// Charges.
#include "engine/study/fields/field_reference.h"
#include "engine/study/fields/field_world.h"

#include <cmath>

namespace plumbline::study {
namespace {

constexpr double kImpulse_Ns = 1000;
constexpr double kStruckMass_kg = 2;

scene::SceneDescription charge_among(scene::Fidelity fidelity,
                                     std::vector<scene::EntityDescription> bodies) {
    scene::SceneDescription scene;
    scene.forces.fidelity.explosion = fidelity;
    scene.gravity_mps2 = {0, 0, 0};
    scene.forces.explosions.push_back({.at_s = 0.05, .impulse_Ns = Real{kImpulse_Ns}});
    scene.entities = std::move(bodies);
    return scene;
}

double impulse_Ns(const FieldWorld& world, const std::string& name) {
    return glm::length(world.velocity_mps(name)) * kStruckMass_kg;
}

FieldOutcome pushes_a_ball(scene::Fidelity fidelity) {
    FieldWorld world(charge_among(fidelity,
                                  {ball_of("near", {1, 0, 0}, 0.2, kStruckMass_kg),
                                   ball_of("far", {0, 3, -4}, 0.5, kStruckMass_kg)}));
    world.run_to(0.1);
    const double near = impulse_Ns(world, "near") / (kImpulse_Ns * 0.04 / 4) - 1;
    const double far = impulse_Ns(world, "far") / (kImpulse_Ns * 0.01 / 4) - 1;
    return {std::max(std::abs(near), std::abs(far)), world.cpu_ms_per_s()};
}

/// A wall up to the line from the charge to its middle hides half of it.
FieldOutcome hides_half_a_ball(scene::Fidelity fidelity) {
    scene::EntityDescription wall = box_of("wall", {1, 0.5_r, 0}, {0.1_r, 1, 3}, 1);
    wall.body->kind = physics::BodyKind::Static;
    FieldWorld world(charge_among(fidelity,
                                  {ball_of("half", {2, 0, 0}, 0.2, kStruckMass_kg),
                                   ball_of("behind", {3, 0.6_r, 0}, 0.2, kStruckMass_kg),
                                   wall}));
    world.run_to(0.1);
    const double half = glm::dot(world.velocity_mps("half"), Vec3d{1, 0, 0}) * kStruckMass_kg /
                            (kImpulse_Ns * 0.01 / 8) -
                        1;
    return {std::max(std::abs(half), impulse_Ns(world, "behind")), world.cpu_ms_per_s()};
}

/// The face of a box of 1 m, 2.5 m away: the integral of z2 / r4 over it, by 400 x 400 places.
FieldOutcome pushes_a_box(scene::Fidelity fidelity) {
    FieldWorld world(charge_among(fidelity, {box_of("box", {0, 0, 3}, {1, 1, 1}, kStruckMass_kg)}));
    world.run_to(0.1);
    constexpr int kPlaces = 400;
    double sum = 0;
    for (int i = 0; i < kPlaces; ++i) {
        for (int j = 0; j < kPlaces; ++j) {
            const double x = (i + 0.5) / kPlaces - 0.5;
            const double y = (j + 0.5) / kPlaces - 0.5;
            const double r2 = x * x + y * y + 6.25;
            sum += 6.25 / (r2 * r2) / (kPlaces * kPlaces);
        }
    }
    const double exact_Ns = kImpulse_Ns / (4 * kPi_rad) * sum;
    return {std::abs(world.velocity_mps("box").z * kStruckMass_kg / exact_Ns - 1),
            world.cpu_ms_per_s()};
}

/// Casts of rays miss a box's rim by some millimetres: 1 % of this one's face, whatever the number of rays.
constexpr std::array kBoxTolerance{0.05, 0.03, 0.02};

constexpr std::array<FieldReference, 3> kBlastReferences{
    {{"explosion", "a ball in the open", "I (R / d)2 / 4", kByFidelity, &pushes_a_ball},
     {"explosion",
      "a ball half hidden",
      "half of that, nothing behind the wall",
      {0.1, 0.03, 0.005},
      &hides_half_a_ball},
     {"explosion", "a box", "integral over its face", kBoxTolerance, &pushes_a_box}}};

}  // namespace

std::span<const FieldReference> blast_references() {
    return kBlastReferences;
}

}  // namespace plumbline::study
