// Sweeps bodies that are fast enough to pass through others.
#include "engine/effects/effect_table.h"
#include "engine/effects/physics/physics_part.h"
#include "engine/scene/simulation/entity_lookup.h"

namespace plumbline::effects {
namespace {

using ContinuousCollision = PhysicsPart<&physics::WorldFeatures::continuous_collision,
                                        &physics::FeatureUse::swept_bodies,
                                        &physics::FeatureUse::sweep_ms>;

Callers callers_of_continuous_collision(const scene::Simulation& simulation) {
    const ecs::Entity swept = simulation.motion_demand.swept;
    if (!simulation.registry.alive(swept)) return {};
    return {describe(simulation, swept)};
}

std::uint64_t key_of_continuous_collision(const scene::Simulation& simulation) {
    return scene::mark_of(simulation.motion_demand.swept);
}

std::unique_ptr<Effect> make_continuous_collision(scene::Simulation& simulation) {
    return std::make_unique<ContinuousCollision>(simulation);
}

}  // namespace

EffectRow continuous_collision() {
    return {.name = "continuous_collision",
            .domain = Domain::Step,
            .called_for_by = &callers_of_continuous_collision,
            .make = &make_continuous_collision,
            .key = &key_of_continuous_collision};
}

}  // namespace plumbline::effects
