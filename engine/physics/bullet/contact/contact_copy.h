// Bullet's contact points copied into our manifolds: the one place that does so.
//
// A Bullet manifold has its number in m_companionIdA, and a point the number of its feature in
// m_userPersistentData, which Bullet hands on when it finds the point again.
#pragma once

#include "engine/physics/bullet/rigid_body.h"
#include "engine/physics/collision/pair.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace plumbline::physics {

/// The record behind a Bullet object of ours.
inline BodyRecord& record_of(const btCollisionObject& object) {
    return *static_cast<BodyRecord*>(object.getUserPointer());
}

/// The one manifold of a pair of primitives, made when first asked for.
Manifold& sole_manifold(Pair& pair);

inline std::uint32_t number_of(const btPersistentManifold& manifold) {
    return static_cast<std::uint32_t>(manifold.m_companionIdA);
}

/// Makes `pair.manifolds` stand for Bullet's, one for one; those that are gone go with their loads.
void match_manifolds(const btManifoldArray& from, Pair& pair);
/// Whether they do, of pairs with one manifold; others are not checked.
inline bool is_matched(const btManifoldArray& from, const Pair& pair) {
    return from.size() == 1 && pair.manifolds.size() == 1 &&
           pair.manifolds[0].number == number_of(*from[0]);
}
/// Makes `to.points` stand for Bullet's, one for one; points found again keep their loads.
void match_points(btPersistentManifold& from, Manifold& to);
/// Takes the same point out of both.
void remove_point(btPersistentManifold& from, Manifold& to, int index);
/// bullet_*: all of it, with the impulses of the latest substep as the points' own.
void copy_manifold(const btPersistentManifold& from, Manifold& to);
/// Where the points are on the two bodies.
void copy_places(const btPersistentManifold& from, Manifold& to);

/// One of ours like Bullet's, but for its load and the radii and offsets of its sides.
ManifoldPoint copied(const btManifoldPoint& point);
void set_feature(const btManifoldPoint& point, std::uint32_t feature);
/// Says that `point` is `old`, found again.
void find_again(btManifoldPoint& point, const ManifoldPoint& old);

// What the materials of the two bodies make. A sphere's own resistance holds on any ground, so one side's
// coefficient is enough.
inline btScalar friction_of(const btCollisionObject& a, const btCollisionObject& b) {
    return std::sqrt(a.getFriction() * b.getFriction());
}
inline btScalar restitution_of(const btCollisionObject& a, const btCollisionObject& b) {
    return std::max(a.getRestitution(), b.getRestitution());
}
inline btScalar rolling_m_of(const btCollisionObject& a, const btCollisionObject& b) {
    return std::max(a.getRollingFriction(), b.getRollingFriction());
}
inline btScalar spinning_m_of(const btCollisionObject& a, const btCollisionObject& b) {
    return std::max(a.getSpinningFriction(), b.getSpinningFriction());
}
inline PairMaterial material_of(const btCollisionObject& a, const btCollisionObject& b) {
    return {.friction = friction_of(a, b),
            .restitution = restitution_of(a, b),
            .rolling_m = rolling_m_of(a, b),
            .spinning_m = spinning_m_of(a, b)};
}

}  // namespace plumbline::physics
