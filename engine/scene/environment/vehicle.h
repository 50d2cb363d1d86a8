// A vehicle of a running scene: its chassis is an entity of the file, its wheels are bodies of their own.
#pragma once

#include "engine/physics/joint.h"
#include "engine/scene/environment/vehicle_description.h"

#include <string>
#include <vector>

namespace plumbline::scene {

/// The hub slides up and down in the chassis on a spring, turned as it is steered; the wheel turns on the hub.
struct Wheel {
    physics::BodyId body{};
    physics::BodyId hub{};
    physics::JointId strut{};  ///< slider, of the hub in the chassis
    physics::JointId axle{};   ///< hinge, of the wheel on the hub
    double load_N{0};          ///< at rest, with its own weight
    double turn_rad{0};  ///< of the wheel on the hub: where it was steered to when it was made
};

struct Vehicle {
    std::string name;
    physics::BodyId chassis{};
    std::vector<Wheel> wheels;
    VehicleControls controls{};
};

}  // namespace plumbline::scene
