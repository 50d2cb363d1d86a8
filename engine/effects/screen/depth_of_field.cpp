// A lens that is sharp at one distance.
#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"

namespace plumbline::effects {
namespace {

constexpr std::uint32_t lens_samples(scene::Fidelity fidelity) {
    switch (fidelity) {
        case scene::Fidelity::Draft:
            return 24;
        case scene::Fidelity::Balanced:
            return 48;
        case scene::Fidelity::Precise:
            return 128;
    }
    return 48;
}

class DepthOfField final : public Effect {
public:
    void extract(const scene::Simulation& simulation,
                 const scene::ViewPoint&,
                 render::RenderFrame& frame) override {
        const scene::SceneDescription& scene = simulation.description();
        const scene::FocusDescription& focus = *scene.camera.focus;
        frame.depth_of_field =
            render::DepthOfField{.focus_m = focus.distance_m,
                                 .aperture_m = focus.aperture_m,
                                 .samples = lens_samples(scene.screen_fidelity.focus)};
        ++work_.calls;
    }
    std::uint64_t bytes_cpu() const override { return sizeof(*this); }
};

Callers callers_of_depth_of_field(const scene::Simulation& simulation) {
    const auto& focus = simulation.description().camera.focus;
    if (!focus || !simulation.switches.is_on("depth_of_field", true)) return {};
    return {setting("[camera] focus", focus->location)};
}

std::unique_ptr<Effect> make_depth_of_field(scene::Simulation&) {
    return std::make_unique<DepthOfField>();
}

}  // namespace

EffectRow depth_of_field() {
    return {.name = "depth_of_field",
            .domain = Domain::Frame,
            .called_for_by = &callers_of_depth_of_field,
            .make = &make_depth_of_field,
            .gpu_owner = "depth_of_field",
            .passes = "focus"};
}

}  // namespace plumbline::effects
