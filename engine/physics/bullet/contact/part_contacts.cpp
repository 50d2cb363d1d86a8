#include "engine/physics/bullet/contact/part_contacts.h"

#include "engine/physics/bullet/contact/contact_copy.h"
#include "engine/physics/bullet/convert.h"
#include "engine/physics/bullet/shape/primitive_shape.h"

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include <array>
#include <new>

namespace plumbline::physics {
namespace {

/// The points of the step before, kept while the new ones are found.
class OldPoints {
public:
    explicit OldPoints(btPersistentManifold& manifold)
        : count_(static_cast<std::size_t>(manifold.getNumContacts())) {
        for (std::size_t i = 0; i < count_; ++i)
            points_[i] = copied(manifold.getContactPoint(static_cast<int>(i)));
        while (manifold.getNumContacts() > 0)
            manifold.removeContactPoint(manifold.getNumContacts() - 1);
    }
    /// The manifold's points that are nearer than `near_m` to an old one are that one, found again.
    void give(btPersistentManifold& manifold, Real near_m) {
        for (int i = 0; i < manifold.getNumContacts(); ++i) {
            btManifoldPoint& point = manifold.getContactPoint(i);
            const ManifoldPoint* const old =
                nearest_point({points_.data(), count_}, copied(point), near_m);
            if (old != nullptr) find_again(point, *old);
        }
    }

private:
    std::array<ManifoldPoint, MANIFOLD_CACHE_SIZE> points_;
    std::size_t count_;
};

/// Holds the parts' manifold; it reaches as far as the manifold's breaking threshold says.
class PartsAlgorithm final : public btCollisionAlgorithm {
public:
    PartsAlgorithm(const btCollisionAlgorithmConstructionInfo& info,
                   const btCollisionObjectWrapper& first,
                   const btCollisionObjectWrapper& second)
        : btCollisionAlgorithm(info),
          manifold_(info.m_dispatcher1->getNewManifold(first.getCollisionObject(),
                                                       second.getCollisionObject())) {}
    ~PartsAlgorithm() override { m_dispatcher->releaseManifold(manifold_); }

    void getAllContactManifolds(btManifoldArray& list) override { list.push_back(manifold_); }
    btScalar calculateTimeOfImpact(btCollisionObject*,
                                   btCollisionObject*,
                                   const btDispatcherInfo&,
                                   btManifoldResult*) override {
        return 1;
    }

    void processCollision(const btCollisionObjectWrapper* first,
                          const btCollisionObjectWrapper* second,
                          const btDispatcherInfo&,
                          btManifoldResult* result) override {
        result->setPersistentManifold(manifold_);
        const Primitive a = primitive_of(*first->getCollisionShape());
        const Primitive b = primitive_of(*second->getCollisionShape());
        const Transform at_a = transform_from_bullet(first->getWorldTransform());
        const Transform at_b = transform_from_bullet(second->getWorldTransform());
        const PrimitiveContact found =
            collide_primitives({a, at_a}, {b, at_b}, manifold_->getContactBreakingThreshold());
        OldPoints old(*manifold_);
        for (const PrimitivePoint& point : found.points())
            result->addContactPoint(
                to_bullet(point.normal), to_bullet(point.on_b), point.distance_m);
        old.give(*manifold_, found.same_m);
    }

private:
    btPersistentManifold* manifold_;
};

struct PartsMaker final : btCollisionAlgorithmCreateFunc {
    btCollisionAlgorithm* CreateCollisionAlgorithm(
        btCollisionAlgorithmConstructionInfo& info,
        const btCollisionObjectWrapper* first,
        const btCollisionObjectWrapper* second) override {
        void* memory = info.m_dispatcher1->allocateCollisionAlgorithm(sizeof(PartsAlgorithm));
        return new (memory) PartsAlgorithm(info, *first, *second);
    }
};

}  // namespace

PartContacts::PartContacts(btCollisionDispatcher& dispatcher)
    : maker_(std::make_unique<PartsMaker>()) {
    for (const int other : {BOX_SHAPE_PROXYTYPE, SPHERE_SHAPE_PROXYTYPE, CAPSULE_SHAPE_PROXYTYPE}) {
        dispatcher.registerCollisionCreateFunc(BOX_SHAPE_PROXYTYPE, other, maker_.get());
        dispatcher.registerCollisionCreateFunc(other, BOX_SHAPE_PROXYTYPE, maker_.get());
    }
}

}  // namespace plumbline::physics
