// Belts and turntables that stand still.
#include "engine/study/fields/field_reference.h"
#include "engine/study/fields/field_world.h"

#include <cmath>

namespace plumbline::study {
namespace {

constexpr double kBeltMu = 0.5;
constexpr double kBelt_mps = 2;

scene::SceneDescription box_on_belt(scene::Fidelity fidelity) {
    scene::SceneDescription scene;
    scene.forces.fidelity.conveyor = fidelity;
    scene.gravity_mps2 = {0, static_cast<Real>(-kFieldGravity_mps2), 0};
    scene::EntityDescription belt = floor_of({60, 1, 60});
    belt.body->friction = static_cast<Real>(kBeltMu);
    belt.body->surface_velocity_mps = {static_cast<Real>(kBelt_mps), 0, 0};
    scene.entities.push_back(belt);
    scene.entities.push_back(box_of("box", {0, 0.25_r, 0}, {0.5_r, 0.5_r, 0.5_r}, 10));
    scene.entities.back().body->friction = static_cast<Real>(kBeltMu);
    return scene;
}

FieldOutcome slips_until_it_rides(scene::Fidelity fidelity) {
    FieldWorld world(box_on_belt(fidelity));
    world.run_to(3);
    const double slip_m = kBelt_mps * world.time_s() - world.position_m("box").x;
    return {std::abs(slip_m / (kBelt_mps * kBelt_mps / (2 * kBeltMu * kFieldGravity_mps2)) - 1),
            world.cpu_ms_per_s()};
}

FieldOutcome rides_at_its_speed(scene::Fidelity fidelity) {
    FieldWorld world(box_on_belt(fidelity));
    world.run_to(3);
    return {std::abs(world.velocity_mps("box").x / kBelt_mps - 1), world.cpu_ms_per_s()};
}

/// What comes across at 3 m/s slides straight in the belt's frame, as far as on a floor at sqrt(3^2 + 2^2).
FieldOutcome comes_across_straight(scene::Fidelity fidelity) {
    scene::SceneDescription scene = box_on_belt(fidelity);
    scene.entities.back().body->velocity_mps = {0, 0, 3};
    FieldWorld world(scene);
    const Vec3d start = world.position_m("box");
    world.run_to(2);
    Vec3d slid = world.position_m("box") - start;
    slid.x -= kBelt_mps * world.time_s();
    const Vec3d exact =
        Vec3d{-kBelt_mps, 0, 3} * std::sqrt(13.0) / (2 * kBeltMu * kFieldGravity_mps2);
    slid.y = 0;
    return {glm::distance(slid, exact) / glm::length(exact), world.cpu_ms_per_s()};
}

/// At 2 m from the axis, turning at 1 rad/s: 2 m/s2 of 4.9 that friction gives. The error is a share of the way.
FieldOutcome goes_round_with_a_turntable(scene::Fidelity fidelity) {
    scene::SceneDescription scene = box_on_belt(fidelity);
    scene::BodyDescription& table = *scene.entities.front().body;
    table.surface_velocity_mps = {0, 0, 0};
    table.surface_spin_radps = {0, 1, 0};
    scene.entities.back() = box_of("box", {2, 0.1_r, 0}, {0.2_r, 0.2_r, 0.2_r}, 1);
    scene::BodyDescription& box = *scene.entities.back().body;
    box.friction = static_cast<Real>(kBeltMu);
    box.velocity_mps = {0, 0, -2};
    box.angular_velocity_radps = {0, 1, 0};
    FieldWorld world(scene);
    world.run_to(10);
    const double t = world.time_s();
    const Vec3d exact{2 * std::cos(t), 0, -2 * std::sin(t)};
    Vec3d at = world.position_m("box");
    at.y = 0;
    return {glm::distance(at, exact) / (2 * t), world.cpu_ms_per_s()};
}

constexpr std::array<FieldReference, 4> kBeltReferences{
    {{"conveyor", "slip of a box put down", "v2 / (2 mu g)", kByFidelity, &slips_until_it_rides},
     {"conveyor", "speed on the belt", "that of the belt", kByFidelity, &rides_at_its_speed},
     {"conveyor",
      "a box from across",
      "straight in the belt's frame",
      kByFidelity,
      &comes_across_straight},
     {"conveyor", "a turntable, 10 s", "a circle", kByFidelity, &goes_round_with_a_turntable}}};

}  // namespace

std::span<const FieldReference> belt_references() {
    return kBeltReferences;
}

}  // namespace plumbline::study
