#include "engine/scene/build/vehicle_layout.h"

#include <algorithm>
#include <cmath>

namespace plumbline::scene {
namespace {

/// Of the size of the wheels' base: below it they stand in a line.
constexpr double kFlat = 1e-6;
/// Straight ahead.
constexpr double kStraight_rad = 1e-6;
constexpr double kAnySpeed_radps = 1e4;
constexpr double kLocked_Nm = 1e7;

/// The axis about which all wheels roll: that of the ones that do not steer, or else the middle of all.
double axis_z_m(const VehicleDescription& vehicle) {
    double fixed = 0;
    double sum_m = 0;
    for (const bool with_steered : {false, true}) {
        for (const WheelDescription& wheel : vehicle.wheels) {
            if (wheel.steers && !with_steered) continue;
            fixed += 1;
            sum_m += static_cast<double>(wheel.position_m.z);
        }
        if (fixed > 0) break;
    }
    return sum_m / std::max(fixed, 1.0);
}

/// How far ahead of the axis the steered wheels are; of those behind it too, the farthest.
double wheelbase_m(const VehicleDescription& vehicle, double axis_m) {
    double ahead_m = 0;
    for (const WheelDescription& wheel : vehicle.wheels) {
        const double each_m = axis_m - static_cast<double>(wheel.position_m.z);
        if (wheel.steers && std::abs(each_m) > std::abs(ahead_m)) ahead_m = each_m;
    }
    return ahead_m;
}

}  // namespace

std::vector<double> spring_loads_N(const VehicleDescription& vehicle,
                                   const Vec3d& center_of_mass_m,
                                   double weight_N) {
    // A load is stiffness times (a + b x + c z), with x and z from the centre of mass.
    glm::dmat3 sums{0.0};
    double all_Npm = 0;
    double widest_m = 0;
    const auto place_of = [&](const WheelDescription& wheel) {
        const Vec3d at = Vec3d(wheel.position_m) - center_of_mass_m;
        return Vec3d{1, at.x, at.z};
    };
    for (const WheelDescription& wheel : vehicle.wheels) {
        const Vec3d place = place_of(wheel);
        sums += glm::outerProduct(place, place) * wheel.stiffness_Npm;
        all_Npm += wheel.stiffness_Npm;
        widest_m = std::max({widest_m, std::abs(place.y), std::abs(place.z)});
    }
    std::vector<double> loads;
    if (!(all_Npm > 0)) return std::vector<double>(vehicle.wheels.size(), 0.0);
    const double size = all_Npm * all_Npm * all_Npm * whole_power(widest_m, 4);
    const bool is_flat = std::abs(glm::determinant(sums)) <= kFlat * size;
    const Vec3d plane =
        is_flat ? Vec3d{weight_N / all_Npm, 0, 0} : glm::inverse(sums) * Vec3d{weight_N, 0, 0};
    for (const WheelDescription& wheel : vehicle.wheels)
        loads.push_back(std::max(wheel.stiffness_Npm * glm::dot(plane, place_of(wheel)), 0.0));
    return loads;
}

double wheel_turn_rad(const VehicleDescription& vehicle, std::size_t wheel, double steer_rad) {
    const WheelDescription& turned = vehicle.wheels[wheel];
    if (!turned.steers || std::abs(steer_rad) < kStraight_rad) return 0;
    const double axis_m = axis_z_m(vehicle);
    const double base_m = wheelbase_m(vehicle, axis_m);
    const double ahead_m = axis_m - static_cast<double>(turned.position_m.z);
    if (base_m == 0) return steer_rad;
    const double sine = portable_sin(steer_rad);
    // The point about which it rolls, to the left, as a fraction with the sine below: at 90 degrees it is in the middle.
    const double radius_times_sine = std::abs(base_m) * portable_cos(steer_rad);
    const double side = -static_cast<double>(turned.position_m.x) * sine;
    const double sign = sine < 0 ? -1.0 : 1.0;
    return sign * portable_atan2(ahead_m * std::abs(sine) * (base_m < 0 ? -1.0 : 1.0),
                                 radius_times_sine - side);
}

WheelDrive wheel_drive(const VehicleDescription& vehicle,
                       const WheelDescription& wheel,
                       const VehicleControls& controls,
                       double braking_Nm,
                       double spin_radps) {
    if (wheel.brakes && controls.brake >= 1) return {.target_radps = 0, .max_Nm = kLocked_Nm};
    const auto driven = std::ranges::count(vehicle.wheels, true, &WheelDescription::drives);
    const double torque_Nm =
        wheel.drives && driven > 0
            ? controls.throttle * vehicle.max_torque_Nm / static_cast<double>(driven)
            : 0.0;
    const double brake_Nm = wheel.brakes ? controls.brake * braking_Nm : 0.0;
    // While it rolls the other way, both slow it down.
    if (torque_Nm * spin_radps < 0 && brake_Nm > 0)
        return {.target_radps = 0, .max_Nm = std::abs(torque_Nm) + brake_Nm};
    if (std::abs(torque_Nm) <= brake_Nm)
        return {.target_radps = 0, .max_Nm = brake_Nm - std::abs(torque_Nm)};
    return {.target_radps = torque_Nm > 0 ? kAnySpeed_radps : -kAnySpeed_radps,
            .max_Nm = std::abs(torque_Nm) - brake_Nm};
}

}  // namespace plumbline::scene
