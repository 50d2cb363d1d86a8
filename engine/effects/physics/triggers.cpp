// Volumes in which a prefab appears when a body comes in. They stop nothing.
#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"
#include "engine/physics/query.h"
#include "engine/scene/simulation/entity_lookup.h"

#include <algorithm>

namespace plumbline::effects {
namespace {

class Triggers final : public Effect {
public:
    void after_step(scene::Simulation& simulation, const scene::Game&) override {
        std::vector<scene::EntityDescription> wanted;
        for (auto [entity, volume, transform] :
             simulation.registry.view<scene::TriggerVolume, const scene::Transform>()) {
            std::vector<physics::BodyId> inside =
                bodies_in(simulation, volume, transform.world_from_body);
            for (const physics::BodyId body : inside) {
                if (volume.times_left == 0) break;
                if (std::ranges::binary_search(volume.inside, body)) continue;
                --volume.times_left;
                scene::EntityDescription made = simulation.description().prefabs.at(volume.spawn);
                made.world_from_body.position = volume.at_m;
                wanted.push_back(std::move(made));
            }
            volume.inside = std::move(inside);
        }
        for (const scene::EntityDescription& description : wanted) {
            simulation.spawn(description);
            ++work_.calls;
        }
    }

private:
    static bool counts(const scene::Simulation& simulation,
                       const scene::TriggerVolume& volume,
                       physics::BodyId body) {
        if (simulation.physics.state(body).kind != physics::BodyKind::Dynamic) return false;
        const ecs::Entity entity = entity_of(simulation, body);
        if (!simulation.registry.alive(entity)) return false;
        const std::string& name = simulation.registry.get<scene::Name>(entity).text;
        return volume.of.empty() || std::ranges::find(volume.of, name) != volume.of.end();
    }

    static std::vector<physics::BodyId> bodies_in(const scene::Simulation& simulation,
                                                  const scene::TriggerVolume& volume,
                                                  const Pose& pose) {
        std::vector<physics::BodyId> bodies;
        for (const physics::OverlapHit& hit :
             physics::overlaps(simulation.physics, volume.shape, pose, Real{0})) {
            if (counts(simulation, volume, hit.body)) bodies.push_back(hit.body);
        }
        std::ranges::sort(bodies);
        bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
        return bodies;
    }
};

}  // namespace

EffectRow triggers() {
    return with_effect<Triggers>({.called_for_by = &entities_with<scene::TriggerVolume>});
}

}  // namespace plumbline::effects
