#include "engine/physics/bullet/convex_query.h"

#include "engine/physics/bullet/convert.h"
#include "engine/physics/bullet/rigid_body.h"
#include "engine/physics/bullet/step_world.h"
#include "engine/physics/world/body_record.h"

#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btMinkowskiPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btRaycastCallback.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <algorithm>

namespace plumbline::physics {
namespace {

/// How btGjkPairDetector finds points: ways above it are what it does when there is no penetration depth.
constexpr int kByPenetration = 3;
/// Closer than this is touching. Ten times what float32 resolves 10 m from a shape's middle.
constexpr btScalar kTouching_m = btScalar(1e-5);
/// A motion this much along a surface is not into it: contact normals carry such noise.
constexpr btScalar kGrazing = btScalar(1e-3);
constexpr int kMaxAdvances = 48;

class BoxGatherer final : public btBroadphaseAabbCallback {
public:
    BoxGatherer(const BodyFilter& filter, std::vector<const BodyRecord*>& found)
        : filter_(filter), found_(found) {}

    bool process(const btBroadphaseProxy* proxy) override {
        const auto& object = *static_cast<const btCollisionObject*>(proxy->m_clientObject);
        const BodyRecord& record = record_of(object);
        if (filter_.sees(record)) found_.push_back(&record);
        return true;
    }

private:
    const BodyFilter& filter_;
    std::vector<const BodyRecord*>& found_;
};

class ClosestRay final : public btCollisionWorld::RayResultCallback {
public:
    explicit ClosestRay(const BodyFilter& filter) : filter_(filter) {
        m_flags = btTriangleRaycastCallback::kF_UseGjkConvexCastRaytest;
    }

    bool needsCollision(btBroadphaseProxy* proxy) const override {
        return filter_.sees(
            record_of(*static_cast<const btCollisionObject*>(proxy->m_clientObject)));
    }
    btScalar addSingleResult(btCollisionWorld::LocalRayResult& result, bool in_world) override {
        const BodyRecord& record = record_of(*result.m_collisionObject);
        // Equal distances: the lower id, whatever order the tree gives.
        if (hit.record != nullptr && result.m_hitFraction == hit.fraction &&
            hit.record->id < record.id) {
            return m_closestHitFraction;
        }
        m_closestHitFraction = result.m_hitFraction;
        m_collisionObject = result.m_collisionObject;
        hit.fraction = result.m_hitFraction;
        hit.normal = in_world ? result.m_hitNormalLocal
                              : result.m_collisionObject->getWorldTransform().getBasis() *
                                    result.m_hitNormalLocal;
        hit.normal.safeNormalize();
        hit.record = &record;
        return m_closestHitFraction;
    }

    CastHit hit;

private:
    const BodyFilter& filter_;
};

/// Advances by the distance left over the speed along its normal: never past the first touch.
void cast_at(const btConvexShape& moving,
             const btTransform& from,
             const btVector3& motion,
             const btConvexShape& still,
             const btTransform& world_from_still,
             CastHit& best) {
    const btScalar length = motion.length();
    btTransform at = from;
    btScalar fraction = 0;
    for (int i = 0; i < kMaxAdvances; ++i) {
        at.setOrigin(from.getOrigin() + motion * fraction);
        const auto closest = closest_points(
            moving, at, still, world_from_still, length * (1 - fraction) + kTouching_m);
        if (!closest) return;
        const btScalar approach = -closest->normal.dot(motion);
        // Moving apart at the nearest features of two convex shapes: they never touch.
        if (approach <= 0) return;
        if (closest->distance <= kTouching_m) {
            if (approach <= kGrazing * length && closest->distance > -kTouching_m) return;
            best = {.fraction = fraction, .normal = closest->normal, .point = closest->point_on_b};
            return;
        }
        fraction += (closest->distance - btScalar(0.5) * kTouching_m) / approach;
        if (fraction >= best.fraction) return;
    }
}

}  // namespace

bool BodyFilter::sees(const BodyRecord& record) const {
    return &record != ignored && &record != also_ignored &&
           (record.filter.group & collides_with) != 0 &&
           (group & record.filter.collides_with) != 0 &&
           (ignored == nullptr || !collision_excluded(*ignored, record)) &&
           (unseen_group == 0 || record.sweep.group != unseen_group);
}

// NOLINTNEXTLINE(readability-function-size): two placed shapes, and what is asked of them
std::optional<ClosestPoints> closest_points(const btConvexShape& a,
                                            const btTransform& world_from_a,
                                            const btConvexShape& b,
                                            const btTransform& world_from_b,
                                            btScalar max_distance,
                                            AtDepth at_depth) {
    btVoronoiSimplexSolver simplex;
    btGjkEpaPenetrationDepthSolver depth;
    btGjkPairDetector detector(&a, &b, &simplex, &depth);
    btGjkPairDetector::ClosestPointInput input;
    input.m_transformA = world_from_a;
    input.m_transformB = world_from_b;
    const btScalar reach = max_distance + a.getMargin() + b.getMargin();
    input.m_maximumDistanceSquared = reach * reach;
    btPointCollector result;
    detector.getClosestPoints(input, result, nullptr);
    if (at_depth == AtDepth::Any && detector.m_lastUsedMethod > kByPenetration) {
        btMinkowskiPenetrationDepthSolver by_directions;
        btGjkPairDetector(&a, &b, &simplex, &by_directions)
            .getClosestPoints(input, result, nullptr);
    }
    if (!result.m_hasResult || result.m_distance > max_distance) return std::nullopt;
    return ClosestPoints{.normal = result.m_normalOnBInWorld,
                         .point_on_b = result.m_pointInWorld,
                         .distance = result.m_distance};
}

std::vector<const BodyRecord*> bodies_in_box(const btCollisionWorld& world,
                                             const btVector3& box_min,
                                             const btVector3& box_max,
                                             const BodyFilter& filter) {
    std::vector<const BodyRecord*> found;
    BoxGatherer gatherer(filter, found);
    // aabbTest reads the tree and is const in all but name.
    const_cast<btBroadphaseInterface*>(world.getBroadphase())->aabbTest(box_min, box_max, gatherer);
    std::sort(found.begin(), found.end(), [](const BodyRecord* a, const BodyRecord* b) {
        return a->id < b->id;
    });
    return found;
}

std::optional<CastHit> cast_among(const btCollisionWorld& world,
                                  const btConvexShape& moving,
                                  const btTransform& from,
                                  const btVector3& motion,
                                  const BodyFilter& filter) {
    btVector3 box_min;
    btVector3 box_max;
    moving.getAabb(from, box_min, box_max);
    btVector3 end_min = box_min + motion;
    btVector3 end_max = box_max + motion;
    box_min.setMin(end_min);
    box_max.setMax(end_max);

    CastHit best;
    for (const BodyRecord* record : bodies_in_box(world, box_min, box_max, filter)) {
        const btScalar before = best.fraction;
        each_convex(*record->rigid->getCollisionShape(),
                    record->rigid->getWorldTransform(),
                    box_min,
                    box_max,
                    [&](const btConvexShape& piece, const btTransform& world_from_piece) {
                        cast_at(moving, from, motion, piece, world_from_piece, best);
                    });
        if (best.fraction < before) best.record = record;
    }
    if (best.record == nullptr) return std::nullopt;
    return best;
}

std::vector<const BodyRecord*> bodies_near(const StepWorld& world,
                                           const Bounds& box,
                                           const BodyFilter& filter) {
    return bodies_in_box(world, bullet_from_double(box.low), bullet_from_double(box.high), filter);
}

std::optional<CastHit> ray_among(const btCollisionWorld& world,
                                 const btVector3& from,
                                 const btVector3& to,
                                 const BodyFilter& filter) {
    ClosestRay ray(filter);
    world.rayTest(from, to, ray);
    if (ray.hit.record == nullptr) return std::nullopt;
    ray.hit.point = from.lerp(to, ray.hit.fraction);
    return ray.hit;
}

}  // namespace plumbline::physics
