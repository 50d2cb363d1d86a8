// The six pictures behind everything.
#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"

namespace plumbline::effects {
namespace {

class Skybox final : public Effect {
public:
    void extract(const scene::Simulation& simulation,
                 const scene::ViewPoint&,
                 render::RenderFrame& frame) override {
        frame.sky = render::Sky{.folder = simulation.description().sky->folder,
                                .brightness = simulation.switches.light_scale};
        ++work_.calls;
    }
    std::uint64_t bytes_cpu() const override { return sizeof(*this); }
};

Callers callers_of_skybox(const scene::Simulation& simulation) {
    const auto& sky = simulation.description().sky;
    if (!sky) return {};
    return {setting("[sky] skybox", sky->origin)};
}

std::unique_ptr<Effect> make_skybox(scene::Simulation&) {
    return std::make_unique<Skybox>();
}

}  // namespace

EffectRow skybox() {
    return {.name = "skybox",
            .domain = Domain::Picture,
            .called_for_by = &callers_of_skybox,
            .make = &make_skybox,
            .gpu_owner = "sky",
            .passes = "sky"};
}

}  // namespace plumbline::effects
