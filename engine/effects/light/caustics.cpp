// The sun's light below rippled water, as far as refraction shows what is there.
#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"

namespace plumbline::effects {
namespace {

class Caustics final : public Effect {
public:
    void extract(const scene::Simulation&,
                 const scene::ViewPoint&,
                 render::RenderFrame& frame) override {
        if (!frame.refraction) return;
        frame.refraction->caustics = true;
        ++work_.calls;
    }
    std::uint64_t bytes_cpu() const override { return sizeof(*this); }
};

Callers callers_of_caustics(const scene::Simulation& simulation) {
    if (!simulation.switches.is_on("caustics", true)) return {};
    return wearers_of(simulation, [](const assets::MaterialData& material) {
        return material.caustics > 0.0F && material.attenuation_m > 0.0F;
    });
}

std::unique_ptr<Effect> make_caustics(scene::Simulation&) {
    return std::make_unique<Caustics>();
}

}  // namespace

EffectRow caustics() {
    return {.name = "caustics",
            .domain = Domain::Frame,
            .called_for_by = &callers_of_caustics,
            .make = &make_caustics};
}

}  // namespace plumbline::effects
