// Who is awake, and what wakes whom.
#include "engine/physics/bullet/contact_copy.h"
#include "engine/physics/world/small_step_world.h"
#include "engine/physics/world/world_state.h"

#include <algorithm>

namespace plumbline::physics {
namespace {

/// Manifolds hold the numbers of the old material, and friction that it bore.
void combine_anew(BodyRecord& record) {
    for (const PairLink& link : record.pairs) {
        for (Manifold& manifold : link.pair->manifolds) {
            manifold.material = material_of(*manifold.a->rigid, *manifold.b->rigid);
            for (ManifoldPoint& point : manifold.points) point.load.friction_N = {};
        }
    }
}

}  // namespace

template <class Fn>
void PhysicsWorld::Impl::each_manifold_of(const BodyRecord& record, Fn&& fn) {
    for (int i = 0; i < dispatcher->getNumManifolds(); ++i) {
        btPersistentManifold& manifold = *dispatcher->getManifoldByIndexInternal(i);
        const bool first = manifold.getBody0() == record.rigid.get();
        if (first || manifold.getBody1() == record.rigid.get()) {
            fn(manifold, record_of(first ? *manifold.getBody1() : *manifold.getBody0()));
        }
    }
}

void PhysicsWorld::Impl::wake(BodyRecord& record) {
    if (!pushable(record)) return;
    if (small)
        small->wake(record);
    else
        record.rigid->activate(true);
}

void PhysicsWorld::Impl::wake_neighbours(const BodyRecord& record) {
    if (small) {
        small->wake_touching(record);
    } else {
        each_manifold_of(record, [this](btPersistentManifold&, BodyRecord& other) { wake(other); });
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
        if (pushable(*record) && record->rigid->isActive()) ++count;
    });
    return count;
}

void PhysicsWorld::set_friction(BodyId id, Real friction) {
    BodyRecord& record = impl_->body(id);
    if (!std::isfinite(friction) || friction < 0) return;
    record.rigid->setFriction(friction);
    impl_->change_material(record);
}

void PhysicsWorld::set_restitution(BodyId id, Real restitution) {
    BodyRecord& record = impl_->body(id);
    if (!std::isfinite(restitution)) return;
    record.rigid->setRestitution(std::clamp(restitution, Real{0}, Real{1}));
    impl_->change_material(record);
}

void PhysicsWorld::Impl::change_material(BodyRecord& record) {
    if (small) {
        combine_anew(record);
    } else {
        each_manifold_of(record, [](btPersistentManifold& manifold, BodyRecord&) {
            combine_materials(manifold);
        });
    }
    wake_neighbours(record);
    wake(record);
}

}  // namespace plumbline::physics
