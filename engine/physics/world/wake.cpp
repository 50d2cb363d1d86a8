// Who is awake, and what wakes whom.
#include "engine/physics/bullet/body.h"
#include "engine/physics/world/world_state.h"

#include <algorithm>

namespace plumbline::physics {
namespace {

/// Manifolds hold the numbers of the old material, and friction that it bore.
void combine_anew(BodyRecord& record) {
    for (const PairLink& link : record.small.pairs) {
        for (Manifold& manifold : link.pair->manifolds) {
            manifold.material = material_of(*manifold.a, *manifold.b);
            for (ManifoldPoint& point : manifold.points) point.load.friction_N = {};
        }
    }
}

}  // namespace

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

void PhysicsWorld::set_friction(BodyId id, Real friction) {
    BodyRecord& record = impl_->body(id);
    if (!std::isfinite(friction) || friction < 0) return;
    set_rigid_friction(record, friction);
    impl_->change_material(record);
}

void PhysicsWorld::set_restitution(BodyId id, Real restitution) {
    BodyRecord& record = impl_->body(id);
    if (!std::isfinite(restitution)) return;
    set_rigid_restitution(record, std::clamp(restitution, Real{0}, Real{1}));
    impl_->change_material(record);
}

void PhysicsWorld::Impl::change_material(BodyRecord& record) {
    if (small)
        combine_anew(record);
    else
        engine->combine_materials(record);
    wake_neighbours(record);
    wake(record);
}

}  // namespace plumbline::physics
