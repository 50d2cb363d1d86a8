#include "engine/physics/bullet/contact/pair_collider.h"

#include "engine/physics/bullet/contact/contact_copy.h"
#include "engine/physics/bullet/convert.h"
#include "engine/physics/bullet/engine_parts.h"
#include "engine/physics/world/body_record.h"

#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include <algorithm>
#include <array>

namespace plumbline::physics {
namespace {

/// A flag of ours beside Bullet's on a manifold point: found in an earlier step.
constexpr int kOld = 1 << 30;

/// Bullet needs room to keep points from step to step; those of boxes are all found anew, and count
/// when nearer than this share of the distance at which others do.
constexpr btScalar kNearBoxes = btScalar(0.1);

btScalar near_m(const Pair& pair) {
    return pair.boxes ? kNearBoxes * pair.base_m : pair.base_m;
}

bool moves(const BodyRecord& record) {
    return record.kind != BodyKind::Static && !record.frozen;
}

/// How far continuous collision lets a body go unswept in a step; a swept one stops at what it hits.
btScalar unswept_m(const BodyRecord& record) {
    if (!moves(record)) return 0;
    return record.sweep.smallest_ccd_radius_m > 0 ? record.sweep.smallest_ccd_radius_m
                                                  : record.traits.radius_m / 2;
}

btScalar spin_mps(const BodyRecord& record) {
    return moves(record) ? glm::length(record.motion->spin_radps) * record.traits.radius_m : 0;
}

/// How much of an impact's change of speed `record` takes. What is backed gives way to nothing.
btScalar share_of(const BodyRecord& record, const BodyRecord& other) {
    const btScalar own = record.motion->inverse_mass;
    const btScalar others = other.small.predicted.backed ? btScalar(0) : other.motion->inverse_mass;
    return own > 0 ? own / (own + others) : btScalar(0);
}

bool is_backing(const BodyRecord& record) {
    return record.small.predicted.backed || record.motion->inverse_mass <= 0;
}

btScalar predicted_mps(const Pair& pair) {
    return glm::length(pair.a->small.predicted.change_mps) +
           glm::length(pair.b->small.predicted.change_mps);
}

Vec3 velocity_at(const BodyRecord& record, const Vec3& place_world) {
    const BodyMotion& motion = *record.motion;
    return motion.velocity_mps + glm::cross(motion.spin_radps, place_world - motion.at.position_m);
}

/// How fast the bodies come together at a point, after whatever impacts either may get.
Real closing_mps(const Manifold& manifold, const ManifoldPoint& point) {
    const Vec3 apart =
        velocity_at(*manifold.b, point.b.surface_m) - velocity_at(*manifold.a, point.a.surface_m);
    const Vec3& normal = point.normal_world;
    return glm::dot(apart, normal) +
           std::max(Real{0}, -glm::dot(manifold.a->small.predicted.change_mps, normal)) +
           std::max(Real{0}, glm::dot(manifold.b->small.predicted.change_mps, normal));
}

/// Radius of a body that is round all over or about an axis, 0 of others.
btScalar roundness_m(const btCollisionObject& object) {
    const btCollisionShape* shape = object.getCollisionShape();
    if (shape->getShapeType() == SPHERE_SHAPE_PROXYTYPE)
        return static_cast<const btSphereShape*>(shape)->getRadius();
    if (shape->getShapeType() == CAPSULE_SHAPE_PROXYTYPE)
        return static_cast<const btCapsuleShape*>(shape)->getRadius();
    return 0;
}

bool is_face_of_box(const btCollisionObject& box, const btVector3& normal) {
    constexpr btScalar kAlong = btScalar(0.9999);
    for (int k = 0; k < 3; ++k) {
        if (std::abs(box.getWorldTransform().getBasis().getColumn(k).dot(normal)) > kAlong)
            return true;
    }
    return false;
}

/// Whether a ball or capsule that is near a box's edge goes by: one that slides over the seam
/// between two boxes must not bump into the edge of the next, which it only looks at from below.
bool passes_edge(const btPersistentManifold& manifold,
                 const btManifoldPoint& point,
                 btScalar step_s) {
    constexpr btScalar kTouch = btScalar(0.005);  // of the radius, as is the next
    constexpr btScalar kFar = btScalar(0.1);
    const btCollisionObject* round = manifold.getBody0();
    const btCollisionObject* box = manifold.getBody1();
    btVector3 out = point.m_normalWorldOnB;
    btVector3 edge = point.getPositionWorldOnB();
    if (box->getCollisionShape()->getShapeType() != BOX_SHAPE_PROXYTYPE) {
        std::swap(round, box);
        out = -out;
        edge = point.getPositionWorldOnA();
    }
    const btScalar radius = roundness_m(*round);
    if (radius <= 0 || box->getCollisionShape()->getShapeType() != BOX_SHAPE_PROXYTYPE ||
        point.getDistance() < -kTouch * radius || is_face_of_box(*box, out))
        return false;
    const btVector3 center = edge + out * (radius + point.getDistance());
    const btVector3 way = to_bullet((velocity_at(record_of(*round), from_bullet(center)) -
                                     velocity_at(record_of(*box), from_bullet(edge))) *
                                    step_s);
    const btScalar length2 = way.length2();
    if (length2 < kFar * kFar * radius * radius) return false;
    const btVector3 apart = center - edge;
    const btScalar nearest = std::clamp(-apart.dot(way) / length2, btScalar(0), btScalar(1));
    return (apart + way * nearest).length() > radius * (1 - kTouch);
}

void keep_larger(PredictedChange& predicted, const Vec3& change, bool backed) {
    if (glm::dot(change, change) > glm::dot(predicted.change_mps, predicted.change_mps))
        predicted = {change, backed, false};
}

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

}  // namespace

struct PairCollider::Impl {
    PairDispatcher& dispatcher;
    const btDispatcherInfo& info;
    CollideStep step{};
    btManifoldArray manifolds{};

    void collide(BulletPair& pair);
    void drop_unreachable(btPersistentManifold& from, Manifold& manifold, Real base_m) const;
};

PairCollider::PairCollider(BulletEngine& engine)
    : impl_(std::make_unique<Impl>(
          Impl{.dispatcher = static_cast<PairDispatcher&>(*engine.parts().dispatcher),
               .info = engine.world().getDispatchInfo()})) {}
PairCollider::~PairCollider() = default;

void PairCollider::begin_step(const CollideStep& step) {
    impl_->step = step;
}

Real PairCollider::reach_of(const Pair& pair) const {
    const CollideStep& step = impl_->step;
    const BodyRecord& a = *pair.a;
    const BodyRecord& b = *pair.b;
    const Vec3 apart = a.motion->velocity_mps - b.motion->velocity_mps;
    const btScalar speed = glm::length(apart) + spin_mps(a) + spin_mps(b) + predicted_mps(pair);
    const btScalar way = speed * step.step_s + step.fall_m;
    const btScalar unswept = unswept_m(a) + unswept_m(b);
    if (pair.boxes) return near_m(pair) + std::min(way, unswept);
    // Resting bodies keep the distances at which Bullet merges and keeps points.
    if (2 * way <= pair.base_m) return pair.base_m;
    // Points of round shapes are found at any distance; what others reach no further for is swept.
    return pair.base_m + (pair.round ? way : std::min(way, unswept));
}

void PairCollider::collide(Pair& pair) {
    btManifoldArray& manifolds = impl_->manifolds;
    BulletPair& side = bullet_side(pair);
    const btScalar reach_m = reach_of(pair);
    impl_->dispatcher.reach_m = reach_m;
    manifolds.resize(0);
    if (side.algorithm != nullptr && (pair.round || reach_m != pair.reach_m)) {
        side.algorithm->getAllContactManifolds(manifolds);
        for (int i = 0; i < manifolds.size(); ++i) {
            manifolds[i]->setContactBreakingThreshold(reach_m);
            if (pair.round) mark_old(*manifolds[i]);
        }
    }
    pair.reach_m = reach_m;
    pair.predicted_mps = predicted_mps(pair);
    impl_->collide(side);

    manifolds.resize(0);
    side.algorithm->getAllContactManifolds(manifolds);
    match_manifolds(manifolds, pair);
    pair.touches = false;
    for (int i = 0; i < manifolds.size(); ++i) {
        btPersistentManifold& from = *manifolds[i];
        Manifold& manifold = pair.manifolds[static_cast<std::size_t>(i)];
        match_points(from, manifold);
        if (pair.round) keep_new_points(from, manifold);
        if (reach_m > near_m(pair)) impl_->drop_unreachable(from, manifold, near_m(pair));
        copy_places(from, manifold);
        pair.touches = pair.touches || !manifold.points.empty();
    }
}

void PairCollider::Impl::collide(BulletPair& pair) {
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
    // Two balls are the only shapes that look at nothing else. Compounds must not see it: they
    // would throw the points of their children away.
    const bool balls = a.getCollisionShape()->getShapeType() == SPHERE_SHAPE_PROXYTYPE &&
                       b.getCollisionShape()->getShapeType() == SPHERE_SHAPE_PROXYTYPE;
    result.m_closestPointDistanceThreshold = balls ? pair.reach_m : btScalar(0);
    pair.algorithm->processCollision(&first, &second, info, &result);
}

void PairCollider::Impl::drop_unreachable(btPersistentManifold& from,
                                          Manifold& manifold,
                                          Real base_m) const {
    for (int i = from.getNumContacts() - 1; i >= 0; --i) {
        const ManifoldPoint& point = manifold.points[static_cast<std::size_t>(i)];
        if (passes_edge(from, from.getContactPoint(i), step.step_s)) {
            remove_point(from, manifold, i);
            continue;
        }
        const Real closing = std::max(Real{0}, closing_mps(manifold, point));
        const Vec3 gap = point.a.surface_m - point.b.surface_m;
        const Real drift2 = glm::dot(gap, gap) - point.distance_m * point.distance_m;
        if (point.distance_m > base_m + closing * step.step_s + step.fall_m ||
            drift2 > base_m * base_m) {
            remove_point(from, manifold, i);
        }
    }
}

bool PairCollider::knows_less(const Pair& pair) const {
    // Boxes that only an impact brings together meet in the next step, at most their CCD spheres apart.
    return !pair.boxes &&
           2 * (predicted_mps(pair) - pair.predicted_mps) * impl_->step.step_s > pair.base_m;
}

void PairCollider::separate(Pair& pair) {
    pair.touches = false;
    btManifoldArray& manifolds = impl_->manifolds;
    const BulletPair& side = bullet_side(pair);
    if (side.algorithm == nullptr) return;
    manifolds.resize(0);
    side.algorithm->getAllContactManifolds(manifolds);
    for (int i = 0; i < manifolds.size(); ++i) {
        if (manifolds[i]->getNumContacts() > 0) manifolds[i]->clearManifold();
    }
    for (Manifold& manifold : pair.manifolds) manifold.points.clear();
}

PairImpact PairCollider::impact_of(const Pair& pair) const {
    const CollideStep& step = impl_->step;
    PairImpact impact;
    if (!pair.touches || pair.reach_m <= pair.base_m) return impact;
    for (const Manifold& manifold : pair.manifolds) {
        const BodyRecord& a = *manifold.a;
        const BodyRecord& b = *manifold.b;
        for (const ManifoldPoint& point : manifold.points) {
            const Real closing = closing_mps(manifold, point);
            const Real change = closing * (1 + manifold.material.restitution);
            if (closing * step.step_s <= std::max(point.distance_m, Real{0}) ||
                2 * change * step.step_s <= pair.base_m) {
                continue;
            }
            const Vec3 push = point.normal_world * change;
            keep_larger(
                &a == pair.a ? impact.on_a : impact.on_b, push * share_of(a, b), is_backing(b));
            keep_larger(
                &a == pair.a ? impact.on_b : impact.on_a, -push * share_of(b, a), is_backing(a));
        }
    }
    return impact;
}

void PairCollider::list_manifolds(Pair& pair, std::vector<Manifold*>& list) const {
    for (Manifold& manifold : pair.manifolds) {
        if (!manifold.points.empty()) list.push_back(&manifold);
    }
}

bool boxes_overlap(const Pair& pair) {
    const btBroadphaseProxy& a = *bullet_side(pair).box_a;
    const btBroadphaseProxy& b = *bullet_side(pair).box_b;
    return TestAabbAgainstAabb2(a.m_aabbMin, a.m_aabbMax, b.m_aabbMin, b.m_aabbMax);
}

bool boxes_are_far(const Pair& pair) {
    const BulletPair& side = bullet_side(pair);
    return !Intersect(side.box_a->leaf->volume, side.box_b->leaf->volume);
}

}  // namespace plumbline::physics
