// The torque that makes a spinning body tumble.
#include "engine/effects/effect_table.h"
#include "engine/effects/physics_part.h"

namespace plumbline::effects {
namespace {

using GyroscopicTorque = PhysicsPart<&physics::WorldFeatures::gyroscopic_torque,
                                     &physics::FeatureUse::gyro_bodies,
                                     &physics::FeatureUse::gyro_ms>;

Callers callers(const scene::Simulation& simulation) {
    const ecs::Entity spinning = simulation.motion_demand().spinning;
    if (!simulation.registry.alive(spinning)) return {};
    return {simulation.describe(spinning)};
}

std::uint64_t key(const scene::Simulation& simulation) {
    return scene::mark_of(simulation.motion_demand().spinning);
}

std::unique_ptr<Effect> make(scene::Simulation& simulation) {
    return std::make_unique<GyroscopicTorque>(simulation);
}

}  // namespace

EffectRow gyroscopic_torque() {
    return {.name = "gyroscopic_torque",
            .domain = Domain::Step,
            .called_for_by = &callers,
            .make = &make,
            .key = &key};
}

}  // namespace plumbline::effects
