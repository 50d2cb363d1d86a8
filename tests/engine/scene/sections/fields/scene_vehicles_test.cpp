// [[vehicle]]: what it says is what the description holds, what it gets wrong is named.
#include "tests/engine/scene/sections/scene_file_fixture.h"

#include <fmt/ranges.h>

namespace plumbline::scene {
namespace {

const std::string kChassis =
    "[[entity]]\nname = \"box\"\nprimitive = { box = [1, 1, 2] }\n[entity.body]\nmass_kg = 100\n";
const std::string kVehicle = "[[vehicle]]\nbody = \"box\"\n";
const std::string kWheels = "wheels = [{ position_m = [0.5, -0.5, -1] }]\n";

TEST_F(SceneFileTest, KeysOfAVehicleAreRead) {
    const Outcome outcome = load(
        kChassis + kVehicle +
        "name = \"cart\"\nfriction = 0.8\nthrottle = -0.5\nbrake = 0.25\nsteer_deg = 30\n"
        "max_torque_Nm = 50\nwheels = [{ position_m = [0.5, -0.5, -1], radius_m = 0.2, width_m "
        "= 0.1, mass_kg = 5, steers = false, drives = true, brakes = false, travel_m = 0.1, "
        "stiffness_Npm = 4000, damping_Nspm = 200 }, { position_m = [0, 0, 1] }]\n"
        "[effects.vehicles]\nfidelity = \"precise\"\n");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    ASSERT_EQ(outcome.scene->forces.vehicles.size(), 1U);
    const VehicleDescription& vehicle = outcome.scene->forces.vehicles.front();
    EXPECT_EQ(vehicle.name, "cart");
    EXPECT_EQ(vehicle.body, "box");
    EXPECT_NEAR(vehicle.friction, 0.8, 1e-6);
    EXPECT_NEAR(vehicle.controls.throttle, -0.5, 1e-6);
    EXPECT_NEAR(vehicle.controls.brake, 0.25, 1e-6);
    EXPECT_NEAR(vehicle.controls.steer_rad, 0.523599, 1e-5);
    EXPECT_NEAR(vehicle.max_torque_Nm, 50, 1e-6);
    ASSERT_EQ(vehicle.wheels.size(), 2U);
    const WheelDescription& wheel = vehicle.wheels.front();
    expect_near(wheel.position_m, {0.5_r, -0.5_r, -1});
    EXPECT_NEAR(wheel.radius_m, 0.2, 1e-6);
    EXPECT_NEAR(wheel.width_m, 0.1, 1e-6);
    EXPECT_NEAR(wheel.mass_kg, 5, 1e-6);
    EXPECT_FALSE(wheel.steers);
    EXPECT_TRUE(wheel.drives);
    EXPECT_FALSE(wheel.brakes);
    EXPECT_NEAR(wheel.travel_m, 0.1, 1e-6);
    EXPECT_NEAR(wheel.stiffness_Npm, 4000, 1e-3);
    EXPECT_NEAR(wheel.damping_Nspm, 200, 1e-3);
    EXPECT_TRUE(vehicle.wheels[1].steers);
    EXPECT_EQ(outcome.scene->forces.fidelity.vehicles, Fidelity::Precise);
}

TEST_F(SceneFileTest, FaultsOfVehiclesAreNamed) {
    const Outcome outcome =
        load(kChassis +
             "[[entity]]\nname = \"post\"\nprimitive = { box = [1, 1, 1] }\n[entity.body]\n"
             "kind = \"static\"\n" +
             kVehicle + kVehicle + kWheels + kVehicle + kWheels + "[[vehicle]]\nbody = \"post\"\n" +
             kWheels + "[[vehicle]]\nbody = \"bix\"\n" + kWheels + kVehicle +
             "wheels = [{}]\nbrake = 2\nsteer_deg = 90\nname = \"post\"\n");
    EXPECT_FALSE(outcome.scene.ok());
    const std::string faults = fmt::format("{}", fmt::join(outcome.faults, "\n"));
    for (const char* part : {"a list of 1 to 32 tables",
                             "\"box\" has wheels already",
                             "\"post\" does not move",
                             "did you mean \"box\"",
                             "where its hub is",
                             "a number from 0 to 1",
                             "an angle from -80 to 80",
                             "is the name of another vehicle, rope or entity"})
        EXPECT_NE(faults.find(part), std::string::npos) << part << "\n" << faults;
}

}  // namespace
}  // namespace plumbline::scene
