// Who is awake, and what wakes whom.
#include "engine/physics/bullet/body.h"
#include "engine/physics/world/world_state.h"

namespace plumbline::physics {

void WorldState::wake(BodyRecord& record) {
    if (!pushable(record)) return;
    if (small)
        small->bodies.wake(record);
    else
        wake_rigid_body(record);
}

void WorldState::wake_neighbours(const BodyRecord& record) {
    if (small) {
        small->bodies.wake_touching(record);
    } else {
        engine->each_manifold([this, &record](const Manifold& manifold) {
            if (manifold.a == &record) wake(*manifold.b);
            if (manifold.b == &record) wake(*manifold.a);
        });
    }
    for (const JointId id : record.joints) wake_ends(*joints.get(id));
}

void PhysicsWorld::wake(BodyId id) {
    state_->wake(state_->body(id));
}

void WorldState::wake_ends(const JointRecord& joint) {
    if (joint.state.broken) return;
    wake(*joint.a);
    if (joint.b != nullptr) wake(*joint.b);
}

}  // namespace plumbline::physics
