// Vehicles: a cart of four wheels on level ground.
#include "engine/study/fields/field_reference.h"
#include "engine/study/fields/field_world.h"

#include <cmath>

namespace plumbline::study {
namespace {

constexpr double kChassis_kg = 400;
constexpr double kWheel_kg = 10;
constexpr double kCart_kg = kChassis_kg + 4 * kWheel_kg;
constexpr double kTyre = 0.9;
constexpr double kRadius_m = 0.35;
constexpr double kWheelbase_m = 2.4;
constexpr double kSpring_Npm = 30'000;

/// It rolls forward; the front wheels steer and the rear ones drive.
scene::SceneDescription cart_scene(scene::Fidelity fidelity,
                                   double speed_mps,
                                   const scene::VehicleControls& controls) {
    scene::SceneDescription scene;
    scene.gravity_mps2 = {0, static_cast<Real>(-kFieldGravity_mps2), 0};
    scene.entities = {floor_of({400, 1, 400}),
                      box_of("chassis", {0, 0.65_r, 0}, {1.4_r, 0.4_r, 3}, kChassis_kg)};
    for (scene::EntityDescription& entity : scene.entities)
        entity.body->friction = static_cast<Real>(kTyre);
    scene.entities.back().body->velocity_mps = {0, 0, static_cast<Real>(-speed_mps)};
    scene::VehicleDescription cart{.name = "cart", .body = "chassis", .friction = kTyre};
    cart.controls = controls;
    for (const Real x : {-0.8_r, 0.8_r}) {
        for (const Real z : {-1.2_r, 1.2_r})
            cart.wheels.push_back({.position_m = {x, -0.3_r, z},
                                   .radius_m = kRadius_m,
                                   .mass_kg = kWheel_kg,
                                   .steers = z<0, .drives = z> 0,
                                   .stiffness_Npm = kSpring_Npm});
    }
    scene.forces.fidelity.vehicles = fidelity;
    scene.forces.vehicles = {cart};
    return scene;
}

FieldOutcome vehicle_brakes(scene::Fidelity fidelity) {
    constexpr double kSpeed_mps = 20;
    FieldWorld world(cart_scene(fidelity, kSpeed_mps, {.brake = 1}));
    world.run_to(4);
    const double exact_m = kSpeed_mps * kSpeed_mps / (2 * kTyre * kFieldGravity_mps2);
    return {std::abs(-world.position_m("chassis").z / exact_m - 1), world.cpu_ms_per_s()};
}

/// A wheel, a cylinder, turns with half of its mass.
FieldOutcome vehicle_accelerates(scene::Fidelity fidelity) {
    scene::SceneDescription scene = cart_scene(fidelity, 0, {.throttle = 1});
    const double force_N = scene.forces.vehicles.front().max_torque_Nm / kRadius_m;
    FieldWorld world(scene);
    world.run_to(3);
    const double exact_mps = force_N * world.time_s() / (kCart_kg + 4 * kWheel_kg / 2);
    return {std::abs(-world.velocity_mps("chassis").z / exact_mps - 1), world.cpu_ms_per_s()};
}

/// The middle of the axle that does not steer goes round in it.
FieldOutcome vehicle_turns(scene::Fidelity fidelity) {
    constexpr double kSteer_rad = 0.2;
    FieldWorld world(cart_scene(fidelity, 4, {.steer_rad = kSteer_rad}));
    world.run_to(1);
    double way_m = 0;
    double turned_rad = 0;
    while (world.time_s() < 3) {
        world.step();
        const physics::BodyState state = world.state("chassis");
        const Vec3d rear(state.world_from_body.orientation *
                         Vec3{0, 0, static_cast<Real>(kWheelbase_m / 2)});
        const Vec3d spin_radps(state.angular_velocity_radps);
        way_m += glm::length(Vec3d(state.velocity_mps) + glm::cross(spin_radps, rear));
        turned_rad += spin_radps.y;
    }
    const double exact_m = kWheelbase_m / std::tan(kSteer_rad);
    return {std::abs(way_m / turned_rad / exact_m - 1), world.cpu_ms_per_s()};
}

FieldOutcome vehicle_rides(scene::Fidelity fidelity) {
    scene::SceneDescription scene = cart_scene(fidelity, 0, {.brake = 1});
    for (scene::WheelDescription& wheel : scene.forces.vehicles.front().wheels)
        wheel.damping_Nspm = 0;
    scene.entities.back().body->velocity_mps = {0, 0.1_r, 0};
    scene.entities.back().body->can_sleep = false;
    FieldWorld world(scene);
    const double exact_s = 2 * kPi_rad / std::sqrt(4 * kSpring_Npm / kChassis_kg);
    const double swing_s = period_s(world, 3, [&world] { return world.velocity_mps("chassis").y; });
    return {std::abs(swing_s / exact_s - 1), world.cpu_ms_per_s()};
}

/// By how much a parked cart has moved after a minute, by its length.
FieldOutcome vehicle_stands(scene::Fidelity fidelity) {
    constexpr double kSlope_rad = 0.1745329;
    scene::SceneDescription scene = cart_scene(fidelity, 0, {.brake = 1});
    scene.gravity_mps2 =
        Vec3(kFieldGravity_mps2 * Vec3d{0, -std::cos(kSlope_rad), std::sin(kSlope_rad)});
    FieldWorld world(scene);
    world.run_to(2);
    const Vec3d settled = world.position_m("chassis");
    world.run_to(62);
    return {glm::distance(world.position_m("chassis"), settled) / 3, world.cpu_ms_per_s()};
}

constexpr std::array kVehicleReferences{
    FieldReference{"vehicles",
                   "braking distance with locked wheels",
                   "v^2 / (2 mu g)",
                   kByFidelity,
                   &vehicle_brakes},
    FieldReference{"vehicles",
                   "speed after 3 s of torque",
                   "T t / (r (m + 4 I / r^2))",
                   kByFidelity,
                   &vehicle_accelerates},
    FieldReference{"vehicles", "circle at 4 m/s", "L / tan(steer)", kByFidelity, &vehicle_turns},
    FieldReference{
        "vehicles", "ride frequency", "sqrt(4 k / m) / (2 pi)", kByFidelity, &vehicle_rides},
    FieldReference{"vehicles",
                   "parked on 10 degrees for 60 s",
                   "does not move, by its length",
                   {1e-3, 3e-4, 3e-4},
                   &vehicle_stands},
};

}  // namespace

std::span<const FieldReference> vehicle_references() {
    return kVehicleReferences;
}

}  // namespace plumbline::study
