// A cart on level ground, for tests of vehicles.
#pragma once

#include "tests/support/scene_in_code.h"

namespace plumbline::test {

inline constexpr double kCart_kg = 440;  ///< with its wheels
inline constexpr double kWheelbase_m = 2.4;

/// Four wheels: the front two steer, the rear two drive, all brake. It rolls forward, towards -Z.
inline scene::SceneDescription cart_at(double speed_mps) {
    scene::EntityDescription chassis = box("chassis", {0, 0.65_r, 0}, {1.4_r, 0.4_r, 3});
    chassis.body->mass_kg = 400;
    chassis.body->velocity_mps = {0, 0, static_cast<Real>(-speed_mps)};
    scene::EntityDescription road =
        box("road", {0, -1, 0}, {400, 2, 400}, physics::BodyKind::Static);
    for (scene::EntityDescription* each : {&chassis, &road}) each->body->friction = 0.9_r;
    scene::SceneDescription scene = scene_of({chassis, road});
    scene.gravity_mps2 = {0, -9.81_r, 0};
    scene::VehicleDescription cart{.name = "cart", .body = "chassis"};
    for (const Real x : {-0.8_r, 0.8_r}) {
        for (const Real z : {-1.2_r, 1.2_r})
            cart.wheels.push_back({.position_m = {x, -0.3_r, z}, .steers = z<0, .drives = z> 0});
    }
    scene.forces.vehicles = {cart};
    return scene;
}

}  // namespace plumbline::test
