#include "engine/physics/bullet/contact/pair_collider.h"

#include "engine/physics/bullet/contact/contact_copy.h"
#include "engine/physics/bullet/engine_parts.h"
#include "engine/physics/collision/primitive_points.h"
#include "engine/physics/world/body_record.h"

#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include <algorithm>

namespace plumbline::physics {
namespace {

/// A flag of ours beside Bullet's on a manifold point: found in an earlier step.
constexpr int kOld = 1 << 30;

/// A ball has one point on anything convex; those that it rolled away from are no contact. The new
/// one takes over what pressed the old.
void keep_new_points(btPersistentManifold& from, Manifold& manifold) {
    const auto is_old = [&from](int i) {
        return (from.getContactPoint(i).m_contactPointFlags & kOld) != 0;
    };
    for (int i = from.getNumContacts() - 1; i >= 0; --i) {
        if (!is_old(i)) continue;
        const PointLoad old = manifold.points[static_cast<std::size_t>(i)].load;
        remove_point(from, manifold, i);
        for (int k = 0; k < from.getNumContacts(); ++k) {
            PointLoad& load = manifold.points[static_cast<std::size_t>(k)].load;
            if (is_old(k) || load.normal_N != 0) continue;
            load.normal_N = old.normal_N;
            load.friction_N = old.friction_N;
        }
    }
}

void mark_old(btPersistentManifold& manifold) {
    for (int i = 0; i < manifold.getNumContacts(); ++i) {
        manifold.getContactPoint(i).m_contactPointFlags |= kOld;
    }
}

/// Puts points into manifolds as Bullet does, but takes two for one only when they are as near as
/// those of slow pairs: a long reach must not melt the corners of a box into one.
class GrownResult final : public btManifoldResult {
public:
    GrownResult(const btCollisionObjectWrapper* a,
                const btCollisionObjectWrapper* b,
                btScalar merge_m)
        : btManifoldResult(a, b), merge_m_(merge_m) {}

    void addContactPoint(const btVector3& normal,
                         const btVector3& on_b,
                         btScalar distance) override {
        btPersistentManifold& manifold = *m_manifoldPtr;
        if (distance > manifold.getContactBreakingThreshold()) return;
        const btVector3 on_a = on_b + normal * distance;
        btManifoldPoint point(manifold.getBody0()->getWorldTransform().invXform(on_a),
                              manifold.getBody1()->getWorldTransform().invXform(on_b),
                              normal,
                              distance);
        point.m_positionWorldOnA = on_a;
        point.m_positionWorldOnB = on_b;
        const bool swapped = manifold.getBody0() != m_body0Wrap->getCollisionObject();
        point.m_partId0 = swapped ? m_partId1 : m_partId0;
        point.m_partId1 = swapped ? m_partId0 : m_partId1;
        point.m_index0 = swapped ? m_index1 : m_index0;
        point.m_index1 = swapped ? m_index0 : m_index1;
        const int same = same_point(manifold, point);
        if (same >= 0)
            manifold.replaceContactPoint(point, same);
        else
            manifold.addManifoldPoint(point);
    }

private:
    int same_point(const btPersistentManifold& manifold, const btManifoldPoint& point) const {
        int nearest = -1;
        btScalar least = merge_m_ * merge_m_;
        for (int i = 0; i < manifold.getNumContacts(); ++i) {
            const btScalar away =
                manifold.getContactPoint(i).m_localPointA.distance2(point.m_localPointA);
            if (away >= least) continue;
            least = away;
            nearest = i;
        }
        return nearest;
    }

    btScalar merge_m_;
};

bool has_points(const Pair& pair) {
    return std::ranges::any_of(pair.manifolds,
                               [](const Manifold& manifold) { return !manifold.points.empty(); });
}

/// Pieces of compounds and faces of meshes get manifolds as they touch; two convex bodies keep theirs.
bool has_parts(const Pair& pair) {
    return !pair.a->rigid->getCollisionShape()->isConvex() ||
           !pair.b->rigid->getCollisionShape()->isConvex();
}

void drop_unreachable(btPersistentManifold& from,
                      Manifold& manifold,
                      Real near_m,
                      const CollideStep& step) {
    for (int i = from.getNumContacts() - 1; i >= 0; --i) {
        if (!is_reachable(manifold, manifold.points[static_cast<std::size_t>(i)], near_m, step))
            remove_point(from, manifold, i);
    }
}

}  // namespace

struct PairCollider::Impl {
    PairDispatcher& dispatcher;
    const btDispatcherInfo& info;
    btManifoldArray manifolds{};

    void collide_by_bullet(BulletPair& pair, Real reach_before_m, const CollideStep& step);
    void run_algorithm(BulletPair& pair);
    btManifoldArray& list_manifolds_of(btCollisionAlgorithm& algorithm);
};

PairCollider::PairCollider(BulletEngine& engine)
    : impl_(std::make_unique<Impl>(
          Impl{.dispatcher = static_cast<PairDispatcher&>(*engine.parts().dispatcher),
               .info = engine.world().getDispatchInfo()})) {}
PairCollider::~PairCollider() = default;

void PairCollider::collide(Pair& pair, const CollideStep& step) {
    const Real reach_before_m = pair.reach_m;
    pair.reach_m = reach_of(pair, step);
    pair.predicted_mps = predicted_mps(pair);
    if (pair.primitives)
        collide_primitives(pair, sole_manifold(pair), step);
    else
        impl_->collide_by_bullet(bullet_side(pair), reach_before_m, step);
    pair.touches = has_points(pair);
}

void PairCollider::Impl::collide_by_bullet(BulletPair& pair,
                                           Real reach_before_m,
                                           const CollideStep& step) {
    dispatcher.reach_m = pair.reach_m;
    const bool starts_with_list =
        pair.algorithm != nullptr && (pair.round || pair.reach_m != reach_before_m);
    if (starts_with_list) {
        list_manifolds_of(*pair.algorithm);
        for (int i = 0; i < manifolds.size(); ++i) {
            manifolds[i]->setContactBreakingThreshold(pair.reach_m);
            if (pair.round) mark_old(*manifolds[i]);
        }
    }
    run_algorithm(pair);
    if (!starts_with_list || has_parts(pair)) list_manifolds_of(*pair.algorithm);
    if (!is_matched(manifolds, pair)) match_manifolds(manifolds, pair);
    for (int i = 0; i < manifolds.size(); ++i) {
        btPersistentManifold& from = *manifolds[i];
        Manifold& manifold = pair.manifolds[static_cast<std::size_t>(i)];
        match_points(from, manifold);
        if (pair.round) keep_new_points(from, manifold);
        if (pair.reach_m > near_m(pair)) drop_unreachable(from, manifold, near_m(pair), step);
        copy_places(from, manifold);
    }
}

void PairCollider::Impl::run_algorithm(BulletPair& pair) {
    const btCollisionObject& a = *pair.a->rigid;
    const btCollisionObject& b = *pair.b->rigid;
    const btCollisionObjectWrapper first(
        nullptr, a.getCollisionShape(), &a, a.getWorldTransform(), -1, -1);
    const btCollisionObjectWrapper second(
        nullptr, b.getCollisionShape(), &b, b.getWorldTransform(), -1, -1);
    if (pair.algorithm == nullptr) {
        pair.algorithm =
            dispatcher.findAlgorithm(&first, &second, nullptr, BT_CONTACT_POINT_ALGORITHMS);
    }
    GrownResult result(&first, &second, pair.base_m);
    pair.algorithm->processCollision(&first, &second, info, &result);
}

btManifoldArray& PairCollider::Impl::list_manifolds_of(btCollisionAlgorithm& algorithm) {
    manifolds.resize(0);
    algorithm.getAllContactManifolds(manifolds);
    return manifolds;
}

void PairCollider::separate(Pair& pair) {
    pair.touches = false;
    for (Manifold& manifold : pair.manifolds) manifold.points.clear();
    const BulletPair& side = bullet_side(pair);
    if (side.algorithm == nullptr) return;
    const btManifoldArray& manifolds = impl_->list_manifolds_of(*side.algorithm);
    for (int i = 0; i < manifolds.size(); ++i) {
        if (manifolds[i]->getNumContacts() > 0) manifolds[i]->clearManifold();
    }
}

bool boxes_overlap(const Pair& pair) {
    const BulletPair& side = bullet_side(pair);
    return boxes_overlap(*side.box_a, *side.box_b);
}

bool boxes_are_far(const Pair& pair) {
    const BulletPair& side = bullet_side(pair);
    return !Intersect(side.box_a->leaf->volume, side.box_b->leaf->volume);
}

}  // namespace plumbline::physics
