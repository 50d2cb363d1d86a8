// Fog: the scene's own, or a plain one where play switches it on.
#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"
#include "engine/scene/environment/live_light.h"

namespace plumbline::effects {
namespace {

class Fog final : public Effect {
public:
    void extract(const scene::Simulation& simulation,
                 const scene::ViewPoint&,
                 render::RenderFrame& frame) override {
        const scene::FogDescription fog =
            simulation.description().fog.value_or(scene::FogDescription{});
        const scene::LiveSwitches& switches = simulation.switches;
        const Vec3f color =
            switches.fog_color == 0 ? fog.color : scene::kFogColors[switches.fog_color].color;
        frame.fog = render::Fog{.color = color * switches.light_scale,
                                .density_per_m = fog.density_per_m * switches.fog_density_scale};
        ++work_.calls;
    }
    std::uint64_t bytes_cpu() const override { return sizeof(*this); }
};

Callers callers_of_fog(const scene::Simulation& simulation) {
    const auto& fog = simulation.description().fog;
    if (!simulation.switches.is_on("fog", fog && fog->on)) return {};
    return {fog ? setting("[fog]", fog->location) : "switch fog"};
}

std::unique_ptr<Effect> make_fog(scene::Simulation&) {
    return std::make_unique<Fog>();
}

}  // namespace

EffectRow fog() {
    return {.name = "fog",
            .domain = Domain::Frame,
            .called_for_by = &callers_of_fog,
            .make = &make_fog};
}

}  // namespace plumbline::effects
