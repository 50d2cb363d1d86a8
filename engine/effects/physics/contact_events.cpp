// Tells who touched whom, while somebody listens.
#include "engine/effects/effect_table.h"
#include "engine/effects/physics/physics_part.h"

namespace plumbline::effects {
namespace {

using ContactEvents = PhysicsPart<&physics::WorldFeatures::contact_events,
                                  &physics::FeatureUse::events,
                                  &physics::FeatureUse::events_ms>;

Callers callers_of_contact_events(const scene::Simulation& simulation) {
    return simulation.contact_listeners.names();
}

}  // namespace

EffectRow contact_events() {
    return with_effect<ContactEvents>({.called_for_by = &callers_of_contact_events});
}

}  // namespace plumbline::effects
