// Where the wheels of a vehicle point and what each carries.
#pragma once

#include "engine/scene/environment/vehicle_description.h"

#include <cstddef>
#include <vector>

namespace plumbline::scene {

/// What each spring carries of a weight at rest on level ground, N: the chassis stays even, so that springs give way in a plane.
/// Where wheels cannot hold it even (one or two, or all in a line), each carries by its stiffness.
std::vector<double> spring_loads_N(const VehicleDescription& vehicle,
                                   const Vec3d& center_of_mass_m,
                                   double weight_N);

/// How far a wheel is turned to the left when the imagined one in the middle is: so that all roll about one point, which lies on the
/// axis of those that do not steer (Ackermann). 0 for these.
double wheel_turn_rad(const VehicleDescription& vehicle, std::size_t wheel, double steer_rad);

/// Torque that drives it forward at the steady speed `target_radps`, as a motor does: the bound, and the speed it aims for.
struct WheelDrive {
    double target_radps{0};  ///< forward positive
    double max_Nm{0};
};
/// `braking_Nm`: what a whole brake without locking takes. A brake of 1 locks the wheel. `spin_radps`: forward positive.
WheelDrive wheel_drive(const VehicleDescription& vehicle,
                       const WheelDescription& wheel,
                       const VehicleControls& controls,
                       double braking_Nm,
                       double spin_radps);

}  // namespace plumbline::scene
