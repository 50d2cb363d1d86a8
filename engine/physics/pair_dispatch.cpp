#include "engine/physics/pair_dispatch_impl.h"
#include "engine/physics/physics_world_impl.h"

#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include <algorithm>

namespace plumbline::physics {
namespace {

/// A flag of ours beside Bullet's on a manifold point: found in an earlier step.
constexpr int kOld = 1 << 30;

bool moves(const BodyRecord& record) {
    return record.kind != BodyKind::Static && !record.frozen;
}

/// How far continuous collision lets a body go unswept in a step; a swept one stops at what it hits.
btScalar unswept_m(const BodyRecord& record) {
    if (!moves(record)) return 0;
    return record.smallest_core_m > 0 ? record.smallest_core_m : record.radius_m / 2;
}

btScalar spin_mps(const BodyRecord& record) {
    return moves(record) ? record.rigid->getAngularVelocity().length() * record.radius_m : 0;
}

btScalar inverse_mass(const BodyRecord& record) {
    return record.rigid->getInvMass();
}

/// A ball has one point on anything convex; those that it rolled away from are no contact. The new
/// one takes over what pressed the old.
void keep_new_points(btPersistentManifold& manifold) {
    for (int i = manifold.getNumContacts() - 1; i >= 0; --i) {
        const btManifoldPoint old = manifold.getContactPoint(i);
        if ((old.m_contactPointFlags & kOld) == 0) continue;
        manifold.removeContactPoint(i);
        for (int k = 0; k < manifold.getNumContacts(); ++k) {
            btManifoldPoint& point = manifold.getContactPoint(k);
            if ((point.m_contactPointFlags & kOld) != 0 || point.m_appliedImpulse != 0) continue;
            point.m_appliedImpulse = old.m_appliedImpulse;
            point.m_appliedImpulseLateral1 = old.m_appliedImpulseLateral1;
            point.m_appliedImpulseLateral2 = old.m_appliedImpulseLateral2;
        }
    }
}

void mark_old(btPersistentManifold& manifold) {
    for (int i = 0; i < manifold.getNumContacts(); ++i) {
        manifold.getContactPoint(i).m_contactPointFlags |= kOld;
    }
}

}  // namespace

btPersistentManifold* PairDispatcher::getNewManifold(const btCollisionObject* a,
                                                     const btCollisionObject* b) {
    btPersistentManifold* manifold = btCollisionDispatcher::getNewManifold(a, b);
    manifold->setContactBreakingThreshold(reach_m);
    return manifold;
}

btScalar PairMeeting::reach_of(const Pair& pair, btScalar jolt_mps) const {
    const BodyRecord& a = *pair.a;
    const BodyRecord& b = *pair.b;
    const btVector3 apart = a.rigid->getLinearVelocity() - b.rigid->getLinearVelocity();
    const btScalar speed = apart.length() + spin_mps(a) + spin_mps(b) + jolt_mps;
    const btScalar way = speed * step_.step_s + step_.fall_m;
    // Resting bodies keep the distances at which Bullet merges and keeps points.
    if (2 * way <= pair.base_m) return pair.base_m;
    return pair.base_m + std::min(way, unswept_m(a) + unswept_m(b));
}

void PairMeeting::meet(Pair& pair, btScalar reach_m, btScalar jolt_mps) {
    dispatcher_.reach_m = reach_m;
    manifolds_.resize(0);
    if (pair.algorithm != nullptr && (pair.round || reach_m != pair.reach_m)) {
        pair.algorithm->getAllContactManifolds(manifolds_);
        for (int i = 0; i < manifolds_.size(); ++i) {
            manifolds_[i]->setContactBreakingThreshold(reach_m);
            if (pair.round) mark_old(*manifolds_[i]);
        }
    }
    pair.reach_m = reach_m;
    pair.jolt_mps = jolt_mps;
    collide(pair);

    manifolds_.resize(0);
    pair.algorithm->getAllContactManifolds(manifolds_);
    pair.touches = false;
    for (int i = 0; i < manifolds_.size(); ++i) {
        btPersistentManifold& manifold = *manifolds_[i];
        if (pair.round) keep_new_points(manifold);
        if (reach_m > pair.base_m) drop_unreachable(manifold, pair.base_m, jolt_mps);
        pair.touches = pair.touches || manifold.getNumContacts() > 0;
    }
}

void PairMeeting::collide(Pair& pair) {
    const btCollisionObject& a = *pair.a->rigid;
    const btCollisionObject& b = *pair.b->rigid;
    const btCollisionObjectWrapper first(
        nullptr, a.getCollisionShape(), &a, a.getWorldTransform(), -1, -1);
    const btCollisionObjectWrapper second(
        nullptr, b.getCollisionShape(), &b, b.getWorldTransform(), -1, -1);
    if (pair.algorithm == nullptr) {
        pair.algorithm =
            dispatcher_.findAlgorithm(&first, &second, nullptr, BT_CONTACT_POINT_ALGORITHMS);
    }
    btManifoldResult result(&first, &second);
    // Two balls are the only shapes that look at nothing else. Compounds must not see it: they
    // would throw the points of their children away.
    const bool balls = a.getCollisionShape()->getShapeType() == SPHERE_SHAPE_PROXYTYPE &&
                       b.getCollisionShape()->getShapeType() == SPHERE_SHAPE_PROXYTYPE;
    result.m_closestPointDistanceThreshold = balls ? pair.reach_m : btScalar(0);
    pair.algorithm->processCollision(&first, &second, info_, &result);
}

btScalar PairMeeting::closing_mps(const btPersistentManifold& manifold,
                                  const btManifoldPoint& point) const {
    const auto& a = static_cast<const btRigidBody&>(*manifold.getBody0());
    const auto& b = static_cast<const btRigidBody&>(*manifold.getBody1());
    const btVector3 va =
        a.getVelocityInLocalPoint(point.getPositionWorldOnA() - a.getWorldTransform().getOrigin());
    const btVector3 vb =
        b.getVelocityInLocalPoint(point.getPositionWorldOnB() - b.getWorldTransform().getOrigin());
    return (vb - va).dot(point.m_normalWorldOnB);
}

void PairMeeting::drop_unreachable(btPersistentManifold& manifold,
                                   btScalar base_m,
                                   btScalar jolt_mps) const {
    for (int i = manifold.getNumContacts() - 1; i >= 0; --i) {
        const btManifoldPoint& point = manifold.getContactPoint(i);
        const btScalar closing = std::max(btScalar(0), closing_mps(manifold, point) + jolt_mps);
        if (point.getDistance() > base_m + closing * step_.step_s + step_.fall_m) {
            manifold.removeContactPoint(i);
        }
    }
}

void PairMeeting::part(Pair& pair) {
    pair.touches = false;
    if (pair.algorithm == nullptr) return;
    manifolds_.resize(0);
    pair.algorithm->getAllContactManifolds(manifolds_);
    for (int i = 0; i < manifolds_.size(); ++i) {
        if (manifolds_[i]->getNumContacts() > 0) manifolds_[i]->clearManifold();
    }
}

Blow PairMeeting::blow_of(const Pair& pair) const {
    if (!pair.touches || pair.reach_m <= pair.base_m) return {};
    manifolds_.resize(0);
    pair.algorithm->getAllContactManifolds(manifolds_);
    btScalar change = 0;
    for (int m = 0; m < manifolds_.size(); ++m) {
        const btPersistentManifold& manifold = *manifolds_[m];
        for (int i = 0; i < manifold.getNumContacts(); ++i) {
            const btManifoldPoint& point = manifold.getContactPoint(i);
            const btScalar closing = closing_mps(manifold, point);
            if (closing * step_.step_s <= std::max(point.getDistance(), btScalar(0))) continue;
            change = std::max(change, closing * (1 + point.m_combinedRestitution));
        }
    }
    if (2 * change * step_.step_s <= pair.base_m) return {};
    const btScalar sum = inverse_mass(*pair.a) + inverse_mass(*pair.b);
    if (sum <= 0) return {};
    return {.to_a_mps = change * inverse_mass(*pair.a) / sum,
            .to_b_mps = change * inverse_mass(*pair.b) / sum};
}

void PairMeeting::list_manifolds(const Pair& pair, std::vector<btPersistentManifold*>& list) const {
    manifolds_.resize(0);
    pair.algorithm->getAllContactManifolds(manifolds_);
    for (int i = 0; i < manifolds_.size(); ++i) {
        if (manifolds_[i]->getNumContacts() > 0) list.push_back(manifolds_[i]);
    }
}

bool boxes_overlap(const Pair& pair) {
    const btBroadphaseProxy& a = *pair.a->rigid->getBroadphaseProxy();
    const btBroadphaseProxy& b = *pair.b->rigid->getBroadphaseProxy();
    return TestAabbAgainstAabb2(a.m_aabbMin, a.m_aabbMax, b.m_aabbMin, b.m_aabbMax);
}

bool boxes_are_far(const Pair& pair) {
    const auto& a = static_cast<const btDbvtProxy&>(*pair.a->rigid->getBroadphaseProxy());
    const auto& b = static_cast<const btDbvtProxy&>(*pair.b->rigid->getBroadphaseProxy());
    return !Intersect(a.leaf->volume, b.leaf->volume);
}

}  // namespace plumbline::physics
