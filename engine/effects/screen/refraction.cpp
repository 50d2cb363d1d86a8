// Water that shows what lies below it.
#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"

namespace plumbline::effects {
namespace {

class Refraction final : public Effect {
public:
    void extract(const scene::Simulation&,
                 const scene::ViewPoint&,
                 render::RenderFrame& frame) override {
        frame.refraction = render::Refraction{};
        ++work_.calls;
    }
    std::uint64_t bytes_cpu() const override { return sizeof(*this); }
};

Callers callers_of_refraction(const scene::Simulation& simulation) {
    if (!simulation.switches.is_on("refraction", true)) return {};
    return wearers_of(simulation, [](const assets::MaterialData& material) {
        return material.attenuation_m > 0.0F;
    });
}

std::unique_ptr<Effect> make_refraction(scene::Simulation&) {
    return std::make_unique<Refraction>();
}

}  // namespace

EffectRow refraction() {
    return {.name = "refraction",
            .domain = Domain::Frame,
            .called_for_by = &callers_of_refraction,
            .make = &make_refraction,
            .gpu_owner = "refraction",
            .passes = "refraction"};
}

}  // namespace plumbline::effects
