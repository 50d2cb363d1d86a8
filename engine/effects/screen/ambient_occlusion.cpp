// Less ambient light in corners and narrow places.
#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"

namespace plumbline::effects {
namespace {

struct Samples {
    std::uint32_t slices;
    std::uint32_t steps;
};

constexpr Samples samples_of(scene::Fidelity fidelity) {
    switch (fidelity) {
        case scene::Fidelity::Draft:
            return {.slices = 1, .steps = 2};
        case scene::Fidelity::Balanced:
            return {.slices = 2, .steps = 3};
        case scene::Fidelity::Precise:
            return {.slices = 3, .steps = 4};
    }
    return {.slices = 2, .steps = 3};
}

class Occlusion final : public Effect {
public:
    void extract(const scene::Simulation& simulation,
                 const scene::ViewPoint&,
                 render::RenderFrame& frame) override {
        const scene::SceneDescription& scene = simulation.description();
        const Samples samples = samples_of(scene.screen_fidelity.occlusion);
        frame.occlusion = render::AmbientOcclusion{.radius_m = scene.occlusion->radius_m,
                                                   .strength = scene.occlusion->strength,
                                                   .slices = samples.slices,
                                                   .steps = samples.steps};
        ++work_.calls;
    }
    std::uint64_t bytes_cpu() const override { return sizeof(*this); }
};

Callers callers_of_occlusion(const scene::Simulation& simulation) {
    const auto& occlusion = simulation.description().occlusion;
    if (!occlusion || !simulation.switches.is_on("ambient_occlusion", true)) return {};
    return {setting("[ambient] occlusion", occlusion->location)};
}

std::unique_ptr<Effect> make_occlusion(scene::Simulation&) {
    return std::make_unique<Occlusion>();
}

}  // namespace

EffectRow ambient_occlusion() {
    return {.name = "ambient_occlusion",
            .domain = Domain::Frame,
            .called_for_by = &callers_of_occlusion,
            .make = &make_occlusion,
            .gpu_owner = "ambient_occlusion",
            .passes = "occlusion"};
}

}  // namespace plumbline::effects
