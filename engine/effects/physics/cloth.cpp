// Cloths.
#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"
#include "engine/effects/physics/deformable_effect.h"

namespace plumbline::effects {
namespace {

class Cloth final : public DeformableEffect {
public:
    explicit Cloth(scene::Simulation& simulation)
        : DeformableEffect(simulation,
                           "cloth",
                           simulation.cloths(),
                           simulation.description().forces.fidelity.cloth) {}
};

Callers callers_of_cloth(const scene::Simulation& simulation) {
    if (!simulation.switches.is_on("cloth", true)) return {};
    Callers callers;
    for (const scene::ClothDescription& cloth : simulation.description().forces.cloths)
        callers.push_back(setting("[[cloth]] " + cloth.name, cloth.location));
    return callers;
}

}  // namespace

EffectRow cloth() {
    return with_effect<Cloth>({.called_for_by = &callers_of_cloth});
}

}  // namespace plumbline::effects
