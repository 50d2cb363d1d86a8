// Soft bodies.
#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"
#include "engine/effects/physics/deformable_effect.h"

namespace plumbline::effects {
namespace {

class Soft final : public DeformableEffect {
public:
    explicit Soft(scene::Simulation& simulation)
        : DeformableEffect(simulation,
                           "soft",
                           &scene::Simulation::softs,
                           simulation.description().forces.fidelity.soft) {}
};

Callers callers_of_soft(const scene::Simulation& simulation) {
    return tables_of(simulation, "soft", "soft", simulation.description().forces.softs);
}

}  // namespace

EffectRow soft() {
    return with_effect<Soft>({.called_for_by = &callers_of_soft});
}

}  // namespace plumbline::effects
