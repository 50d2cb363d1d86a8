// Fog: the scene's own, or a plain one where play switches it on.
#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"

namespace plumbline::effects {
namespace {

class Fog final : public Effect {
public:
    void extract(const scene::Simulation& simulation,
                 const scene::ViewPoint&,
                 render::RenderFrame& frame) override {
        const scene::FogDescription fog =
            simulation.description().fog.value_or(scene::FogDescription{});
        frame.fog = render::Fog{.color = fog.color * simulation.switches.light_scale,
                                .density_per_m = fog.density_per_m};
        ++work_.calls;
    }
    std::uint64_t bytes_cpu() const override { return sizeof(*this); }
};

Callers callers_of_fog(const scene::Simulation& simulation) {
    const auto& fog = simulation.description().fog;
    if (!simulation.switches.is_on("fog", fog.has_value())) return {};
    return {fog ? setting("[fog]", fog->origin) : "switch fog"};
}

std::unique_ptr<Effect> make_fog(scene::Simulation&) {
    return std::make_unique<Fog>();
}

}  // namespace

EffectRow fog() {
    return {.name = "fog",
            .domain = Domain::Picture,
            .called_for_by = &callers_of_fog,
            .make = &make_fog};
}

}  // namespace plumbline::effects
