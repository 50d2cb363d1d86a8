// The torque that makes a spinning body tumble.
#include "engine/effects/effect_table.h"
#include "engine/effects/physics/physics_part.h"

namespace plumbline::effects {

EffectRow gyroscopic_torque() {
    using Use = physics::FeatureUse;
    return with_effect<PhysicsUse<&Use::gyro_bodies, &Use::gyro_ms>>(
        {.called_for_by = &callers_of_use<&Use::turned>, .key = &key_of_use<&Use::turned>});
}

}  // namespace plumbline::effects
