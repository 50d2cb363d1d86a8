// Sweeps bodies that are fast enough to pass through others.
#include "engine/effects/effect_table.h"
#include "engine/effects/physics/physics_part.h"

namespace plumbline::effects {

EffectRow continuous_collision() {
    using Use = physics::FeatureUse;
    return with_effect<PhysicsUse<&Use::swept_bodies, &Use::sweep_ms>>(
        {.called_for_by = &callers_of_use<&Use::swept>, .key = &key_of_use<&Use::swept>});
}

}  // namespace plumbline::effects
