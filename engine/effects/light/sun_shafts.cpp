// Air that the sun lights up between shadows.
#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"

namespace plumbline::effects {
namespace {

constexpr std::uint32_t shaft_samples(scene::Fidelity fidelity) {
    switch (fidelity) {
        case scene::Fidelity::Draft:
            return 8;
        case scene::Fidelity::Balanced:
            return 16;
        case scene::Fidelity::Precise:
            return 48;
    }
    return 16;
}

class SunShafts final : public Effect {
public:
    void extract(const scene::Simulation& simulation,
                 const scene::ViewPoint&,
                 render::RenderFrame& frame) override {
        const scene::SceneDescription& scene = simulation.description();
        const scene::ShaftsDescription& shafts = *scene.sun->shafts;
        frame.shafts = render::SunShafts{.density_per_m = shafts.density_per_m,
                                         .distance_m = shafts.distance_m,
                                         .steps = shaft_samples(scene.screen_fidelity.shafts)};
        ++work_.calls;
    }
    std::uint64_t bytes_cpu() const override { return sizeof(*this); }
};

Callers callers_of_shafts(const scene::Simulation& simulation) {
    const auto& sun = simulation.description().sun;
    if (!sun || !sun->shafts || !simulation.switches.is_on("sun_shafts", true)) return {};
    return {setting("[sun] shafts", sun->shafts->location)};
}

std::unique_ptr<Effect> make_shafts(scene::Simulation&) {
    return std::make_unique<SunShafts>();
}

}  // namespace

EffectRow sun_shafts() {
    return {.name = "sun_shafts",
            .domain = Domain::Frame,
            .called_for_by = &callers_of_shafts,
            .make = &make_shafts,
            .gpu_owner = "sun_shafts",
            .passes = "shafts"};
}

}  // namespace plumbline::effects
