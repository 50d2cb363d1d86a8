// The shadows of lamps: of entities whose light asks for them.
#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"

namespace plumbline::effects {
namespace {

class LightShadows final : public Effect {
public:
    void extract(const scene::Simulation&,
                 const scene::ViewPoint&,
                 render::RenderFrame& frame) override {
        frame.light_shadows = render::LightShadows{};
        ++work_.calls;
    }
    std::uint64_t bytes_cpu() const override { return sizeof(*this); }
};

Callers callers_of_light_shadows(const scene::Simulation& simulation) {
    if (!simulation.switches.is_on("light_shadows", true)) return {};
    EntityCallers callers(simulation);
    for (auto [entity, light] : simulation.registry.view<const scene::PointLight>()) {
        if (light.casts_shadow) callers.add(entity);
    }
    return callers.take();
}

std::unique_ptr<Effect> make_light_shadows(scene::Simulation&) {
    return std::make_unique<LightShadows>();
}

}  // namespace

EffectRow light_shadows() {
    return {.name = "light_shadows",
            .domain = Domain::Frame,
            .called_for_by = &callers_of_light_shadows,
            .make = &make_light_shadows,
            .gpu_owner = "light_shadows",
            .passes = "shadow.lights"};
}

}  // namespace plumbline::effects
