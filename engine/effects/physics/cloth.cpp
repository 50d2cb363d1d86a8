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
                           &scene::Simulation::cloths,
                           simulation.description().forces.fidelity.cloth) {}
};

Callers callers_of_cloth(const scene::Simulation& simulation) {
    return tables_of(simulation, "cloth", "cloth", simulation.description().forces.cloths);
}

}  // namespace

EffectRow cloth() {
    return with_effect<Cloth>({.called_for_by = &callers_of_cloth});
}

}  // namespace plumbline::effects
