// What a scene file says of a vehicle, as plain data in SI units and radians.
#pragma once

#include "engine/core/math.h"
#include "engine/core/text/source_location.h"

#include <string>
#include <vector>

namespace plumbline::scene {

struct WheelDescription {
    Vec3 position_m{0, 0, 0};  ///< of the hub, in the chassis' frame, at rest
    double radius_m{0.35};
    double width_m{0.2};
    double mass_kg{10};
    bool steers{true};
    bool drives{false};
    bool brakes{true};
    double travel_m{0.2};  ///< of the hub, as far up as down from where it rests
    double stiffness_Npm{30'000};
    double damping_Nspm{3'000};
};

/// What is done with it.
struct VehicleControls {
    double throttle{0};   ///< -1 to 1, forward positive
    double brake{0};      ///< 0 to 1, which locks wheels
    double steer_rad{0};  ///< of an imagined middle wheel, left positive
};

/// `[[vehicle]]`.
struct VehicleDescription {
    std::string name;
    std::string body;      ///< an entity with a dynamic body; forward is its -Z
    double friction{0.9};  ///< of tyres
    std::vector<WheelDescription> wheels;
    VehicleControls controls{};  ///< while nobody drives
    double max_torque_Nm{300};   ///< of all driven wheels together, at any speed
    std::string material;        ///< what its wheels look like
    SourceLocation location{};
};

}  // namespace plumbline::scene
