// Plaques: what is measured for them, after each step.
#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"

#include <cmath>

namespace plumbline::effects {
namespace {

using scene::PlaqueQuantity;

constexpr double kDegrees = 180 / 3.14159265358979323846;  // in a radian

class Plaques final : public Effect {
public:
    void after_step(scene::Simulation& simulation, const scene::Game&) override {
        for (auto [entity, plaque] : simulation.registry.view<scene::Plaque>()) {
            const auto value = value_of(simulation, plaque.says);
            if (!value) continue;
            plaque.meter.note(plaque.says.quantity, *value, simulation.step_s());
            ++work_.calls;
        }
    }

private:
    static const scene::Transform* find(const scene::Simulation& simulation,
                                        const std::string& name) {
        const ecs::Entity entity = simulation.find(name);
        if (!simulation.registry.alive(entity)) return nullptr;
        return simulation.registry.find<scene::Transform>(entity);
    }

    /// None: what is measured went.
    static std::optional<double> value_of(const scene::Simulation& simulation,
                                          const scene::PlaqueDescription& says) {
        const scene::Transform* at = find(simulation, says.of);
        if (at == nullptr) return {};
        const Vec3d here(at->world_from_body.position);
        if (says.quantity == PlaqueQuantity::Period) return here[says.axis];
        if (says.quantity == PlaqueQuantity::Height) return here.y;
        if (says.quantity == PlaqueQuantity::Speed || says.quantity == PlaqueQuantity::Spin)
            return speed_of(simulation, says);
        const scene::Transform* from = find(simulation, says.from);
        if (from == nullptr) return {};
        const Vec3d away = here - Vec3d(from->world_from_body.position);
        if (says.quantity == PlaqueQuantity::Distance) return glm::length(away);
        return portable_atan2(glm::length(Vec3d(away.x, 0, away.z)), std::abs(away.y)) * kDegrees;
    }

    static std::optional<double> speed_of(const scene::Simulation& simulation,
                                          const scene::PlaqueDescription& says) {
        const auto* ref = simulation.registry.find<scene::BodyRef>(simulation.find(says.of));
        if (ref == nullptr || !simulation.physics.contains(ref->body)) return {};
        const physics::BodyState state = simulation.physics.state(ref->body);
        if (says.quantity == PlaqueQuantity::Spin)
            return glm::length(Vec3d(state.angular_velocity_radps)) * kDegrees;
        return glm::length(Vec3d(state.velocity_mps));
    }
};

}  // namespace

EffectRow plaques() {
    return with_effect<Plaques>({.called_for_by = &entities_with<scene::Plaque>});
}

}  // namespace plumbline::effects
