// Who is awake, and what wakes whom.
#include "engine/physics/bullet/body.h"
#include "engine/physics/world/world_state.h"

namespace plumbline::physics {

void PhysicsWorld::Impl::wake(BodyRecord& record) {
    if (!pushable(record)) return;
    if (small)
        small->wake(record);
    else
        wake_rigid_body(record);
}

void PhysicsWorld::Impl::wake_neighbours(const BodyRecord& record) {
    if (small) {
        small->wake_touching(record);
    } else {
        engine->each_manifold([this, &record](const Manifold& manifold) {
            if (manifold.a == &record) wake(*manifold.b);
            if (manifold.b == &record) wake(*manifold.a);
        });
    }
    for (const JointId id : record.joints) wake_ends(*joints.get(id));
}

void PhysicsWorld::wake(BodyId id) {
    impl_->wake(impl_->body(id));
}

std::size_t PhysicsWorld::awake_count() const {
    if (impl_->small) return impl_->small->awake_count();
    std::size_t count = 0;
    impl_->bodies.each([&count](BodyId, const std::unique_ptr<BodyRecord>& record) {
        if (pushable(*record) && is_active(*record)) ++count;
    });
    return count;
}

}  // namespace plumbline::physics
