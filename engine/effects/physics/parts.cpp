#include "engine/effects/physics/parts.h"

namespace plumbline::effects {

void stop_parts(scene::Simulation& simulation, scene::PartOf::Whole of, bool stopped) {
    simulation.registry.view<scene::PartOf, const scene::BodyRef>().each(
        [&](ecs::Entity, scene::PartOf& part, const scene::BodyRef& ref) {
            if (part.whole != of || part.stopped == stopped) return;
            if (stopped && simulation.physics.state(ref.body).frozen) return;
            part.stopped = stopped;
            simulation.physics.set_frozen(ref.body, stopped);
        });
}

}  // namespace plumbline::effects
