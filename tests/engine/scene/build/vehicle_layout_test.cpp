// What springs carry, where steered wheels point, and what drives them.
#include "engine/scene/build/vehicle_layout.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::scene {
namespace {

VehicleDescription cart() {
    VehicleDescription vehicle;
    for (const Real x : {-0.8_r, 0.8_r}) {
        for (const Real z : {-1.2_r, 1.2_r})
            vehicle.wheels.push_back({.position_m = {x, -0.3_r, z}, .steers = z<0, .drives = z> 0});
    }
    return vehicle;
}

TEST(VehicleLayout, SpringsHoldTheChassisEven) {
    const std::vector<double> loads = spring_loads_N(cart(), {0.1, 0, -0.3}, 4000);
    ASSERT_EQ(loads.size(), 4U);
    EXPECT_NEAR(loads[0] + loads[1] + loads[2] + loads[3], 4000, 1e-9);
    // Moments about the centre of mass.
    EXPECT_NEAR((loads[0] + loads[2]) * 0.9, (loads[1] + loads[3]) * 1.5, 1e-3);
    EXPECT_NEAR((loads[0] + loads[1]) * 0.9, (loads[2] + loads[3]) * 0.7, 1e-3);
}

TEST(VehicleLayout, OneWheelCarriesItAll) {
    VehicleDescription barrow;
    barrow.wheels = {{.position_m = {0, -0.3_r, -1}}};
    EXPECT_EQ(spring_loads_N(barrow, {0, 0, 0}, 300), (std::vector<double>{300}));
    barrow.wheels[0].stiffness_Npm = 0;
    EXPECT_EQ(spring_loads_N(barrow, {0, 0, 0}, 300), (std::vector<double>{0}));
}

// Each axle points at the same place, which is as far to the side as the middle wheel says.
TEST(VehicleLayout, AllWheelsRollAboutOnePoint) {
    const VehicleDescription vehicle = cart();
    for (const double steer_rad : {0.2, -0.2, 0.6, 1.4}) {
        const double center_x_m = -2.4 / std::tan(steer_rad);
        for (const std::size_t wheel : {0U, 2U}) {
            const Vec3& at = vehicle.wheels[wheel].position_m;
            const double turn_rad = wheel_turn_rad(vehicle, wheel, steer_rad);
            // The axle, to the right of a wheel turned to the left.
            const double right_x = std::cos(turn_rad);
            const double right_z = -std::sin(turn_rad);
            const double to_x_m = center_x_m - static_cast<double>(at.x);
            EXPECT_NEAR(right_x * 2.4 - right_z * to_x_m, 0, 1e-5) << steer_rad;
            EXPECT_GT(turn_rad * steer_rad, 0);
        }
        EXPECT_EQ(wheel_turn_rad(vehicle, 1, steer_rad), 0);
    }
}

TEST(VehicleLayout, TorqueIsSharedAndBrakesWorkAgainstIt) {
    const VehicleDescription vehicle = cart();
    const WheelDescription& rear = vehicle.wheels[1];
    const WheelDrive half = wheel_drive(vehicle, rear, {.throttle = 0.5}, 100, 3);
    EXPECT_NEAR(half.max_Nm, 75, 1e-9);
    EXPECT_GT(half.target_radps, 100);
    const WheelDrive back = wheel_drive(vehicle, rear, {.throttle = -1, .brake = 0.5}, 100, 0);
    EXPECT_NEAR(back.max_Nm, 100, 1e-9);
    EXPECT_LT(back.target_radps, -100);
    const WheelDrive slowed = wheel_drive(vehicle, rear, {.throttle = -1, .brake = 0.5}, 100, 3);
    EXPECT_NEAR(slowed.max_Nm, 200, 1e-9);
    EXPECT_EQ(slowed.target_radps, 0);
    const WheelDrive held = wheel_drive(vehicle, rear, {.throttle = 0.1, .brake = 0.5}, 100, 3);
    EXPECT_NEAR(held.max_Nm, 35, 1e-9);
    EXPECT_GT(wheel_drive(vehicle, rear, {.brake = 1}, 0, 3).max_Nm, 1e6) << "locked";
    EXPECT_EQ(wheel_drive(vehicle, vehicle.wheels[0], {.throttle = 1}, 100, 3).max_Nm, 0);
}

}  // namespace
}  // namespace plumbline::scene
