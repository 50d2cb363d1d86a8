// The torque that makes a spinning body tumble.
#include "engine/effects/effect_table.h"
#include "engine/effects/physics/physics_part.h"
#include "engine/scene/simulation/entity_lookup.h"

namespace plumbline::effects {
namespace {

using GyroscopicTorque = PhysicsPart<&physics::WorldFeatures::gyroscopic_torque,
                                     &physics::FeatureUse::gyro_bodies,
                                     &physics::FeatureUse::gyro_ms>;

Callers callers_of_gyroscopic_torque(const scene::Simulation& simulation) {
    const ecs::Entity spinning = simulation.motion_demand.spinning;
    if (!simulation.registry.alive(spinning)) return {};
    return {describe(simulation, spinning)};
}

std::uint64_t key_of_gyroscopic_torque(const scene::Simulation& simulation) {
    return scene::mark_of(simulation.motion_demand.spinning);
}

std::unique_ptr<Effect> make_gyroscopic_torque(scene::Simulation& simulation) {
    return std::make_unique<GyroscopicTorque>(simulation);
}

}  // namespace

EffectRow gyroscopic_torque() {
    return {.name = "gyroscopic_torque",
            .domain = Domain::Step,
            .called_for_by = &callers_of_gyroscopic_torque,
            .make = &make_gyroscopic_torque,
            .key = &key_of_gyroscopic_torque};
}

}  // namespace plumbline::effects
