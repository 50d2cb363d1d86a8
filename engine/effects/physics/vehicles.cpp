// Vehicles. Their wheels are bodies that the physics solves; this row drives, brakes and steers them.
#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"
#include "engine/effects/physics/parts.h"
#include "engine/scene/build/vehicle_layout.h"

#include <algorithm>

namespace plumbline::effects {
namespace {

/// How fast wheels are turned to the side.
constexpr double kSteering_radps = 1.2;

/// While it does not live, wheels stand still as they are.
class Vehicles final : public Effect {
public:
    explicit Vehicles(scene::Simulation& simulation) : simulation_(simulation) { stop(false); }
    ~Vehicles() override { stop(true); }
    Vehicles(const Vehicles&) = delete;
    Vehicles& operator=(const Vehicles&) = delete;

    void before_step(scene::Simulation& simulation) override {
        const auto& described = simulation.description().forces.vehicles;
        for (std::size_t i = 0; i < described.size(); ++i) {
            scene::Vehicle& vehicle = simulation.vehicles()[i];
            for (std::size_t w = 0; w < vehicle.wheels.size(); ++w) {
                drive(simulation, described[i], vehicle, w);
                steer(simulation, described[i], vehicle, w);
            }
        }
    }

    void after_step(scene::Simulation& simulation, const scene::Game&) override {
        for (const scene::Vehicle& vehicle : simulation.vehicles()) {
            work_.calls += simulation.physics.contains(vehicle.chassis) &&
                                   simulation.physics.state(vehicle.chassis).awake
                               ? 1U
                               : 0U;
        }
    }

private:
    /// What it does not change, it leaves asleep.
    static void set_motor(physics::PhysicsWorld& world,
                          physics::JointId joint,
                          const physics::JointMotor& motor) {
        const auto& now = world.joint(joint).def.motor;
        const physics::JointMotor is = now.value_or(physics::JointMotor{});
        if (is.target == motor.target && is.max == motor.max && is.turn_rad == motor.turn_rad)
            return;
        world.set_joint_motor(joint, motor);
    }

    static void drive(scene::Simulation& simulation,
                      const scene::VehicleDescription& described,
                      const scene::Vehicle& vehicle,
                      std::size_t number) {
        const scene::Wheel& wheel = vehicle.wheels[number];
        if (!simulation.physics.contains(wheel.axle)) return;
        const scene::WheelDescription& own = described.wheels[number];
        const double braking_Nm = described.friction * wheel.load_N * own.radius_m;
        const scene::WheelDrive drive = scene::wheel_drive(
            described, own, vehicle.controls, braking_Nm, simulation.spin_radps(wheel));
        // Forward is a turn to the left about the axle, which points to the right.
        set_motor(simulation.physics,
                  wheel.axle,
                  {.target = static_cast<Real>(-drive.target_radps),
                   .max = static_cast<Real>(drive.max_Nm)});
    }

    static void steer(scene::Simulation& simulation,
                      const scene::VehicleDescription& described,
                      const scene::Vehicle& vehicle,
                      std::size_t number) {
        const scene::Wheel& wheel = vehicle.wheels[number];
        if (!described.wheels[number].steers || !simulation.physics.contains(wheel.strut)) return;
        const double wanted_rad =
            scene::wheel_turn_rad(described, number, vehicle.controls.steer_rad) - wheel.turn_rad;
        const auto& motor = simulation.physics.joint(wheel.strut).def.motor;
        const double now_rad = motor ? static_cast<double>(motor->turn_rad) : 0.0;
        const double most_rad = kSteering_radps * simulation.step_s();
        const double turn_rad = now_rad + std::clamp(wanted_rad - now_rad, -most_rad, most_rad);
        set_motor(simulation.physics, wheel.strut, {.turn_rad = static_cast<Real>(turn_rad)});
    }

    void stop(bool stopped) { stop_parts(simulation_, scene::PartOf::Whole::Vehicle, stopped); }

    scene::Simulation& simulation_;
};

Callers callers_of_vehicles(const scene::Simulation& simulation) {
    return tables_of(simulation, "vehicles", "vehicle", simulation.description().forces.vehicles);
}

}  // namespace

EffectRow vehicles() {
    return with_effect<Vehicles>({.called_for_by = &callers_of_vehicles});
}

}  // namespace plumbline::effects
