// What Bullet keeps from step to step, for saved games: boxes of the broad phase, pairs, contact points.
// Private to the physics module.
#pragma once

#include "engine/core/pose_archive.h"
#include "engine/core/slot_map.h"
#include "engine/physics/body.h"

#include <btBulletDynamicsCommon.h>

#include <functional>
#include <memory>
#include <vector>

namespace plumbline {

inline void serialize(Archive& archive, btVector3& v) {
    archive(v[0], v[1], v[2]);
}
inline void serialize(Archive& archive, btMatrix3x3& m) {
    archive(m[0], m[1], m[2]);
}
inline void serialize(Archive& archive, btTransform& at) {
    archive(at.getBasis(), at.getOrigin());
}

inline void serialize(Archive& archive, btJointFeedback& load) {
    archive(load.m_appliedForceBodyA,
            load.m_appliedTorqueBodyA,
            load.m_appliedForceBodyB,
            load.m_appliedTorqueBodyB);
}

}  // namespace plumbline

class btCompoundCollisionAlgorithm;

namespace plumbline::physics {

struct BodyRecord;
struct JointRecord;
struct Pair;
using BodyTable = SlotMap<BodyId, std::unique_ptr<BodyRecord>>;

/// Whose state an archive holds.
struct BodyScope {
    const BodyTable& bodies;
    const std::function<bool(BodyId)>& keeps;  ///< when written; empty: all

    bool holds(BodyId id) const { return !keeps || keeps(id); }
    bool holds(const JointRecord& joint) const;
};

/// Bodies by their ids; those out of scope are left out.
void serialize(Archive& archive, std::vector<BodyRecord*>& list, const BodyScope& scope);

/// The algorithms of pairs with their manifolds. Both ways meet them in the same order, so that a
/// manifold may be named by its number.
class ContactArchive {
public:
    ContactArchive(Archive& archive,
                   btCollisionDispatcher& dispatcher,
                   const btDispatcherInfo& info)
        : archive_(archive), dispatcher_(dispatcher), info_(info) {}

    /// Made when read, with all that hangs on it, if there was one.
    void pair(btCollisionAlgorithm*& algorithm, btRigidBody& first, btRigidBody& second);
    /// ... with the manifolds of ours that stand for Bullet's, and what they carried.
    void small_pair(Pair& pair);
    /// The dispatcher lists its manifolds as it did.
    void order();

private:
    void algorithm(btCollisionAlgorithm*& algorithm,
                   const btCollisionObjectWrapper& first,
                   const btCollisionObjectWrapper& second);
    void children(btCompoundCollisionAlgorithm& compound,
                  const btCollisionObjectWrapper& first,
                  const btCollisionObjectWrapper& second);
    void child_pairs(btCollisionAlgorithm& compounds,
                     const btCollisionObjectWrapper& first,
                     const btCollisionObjectWrapper& second);
    void single(btCollisionAlgorithm& single,
                const btCollisionObjectWrapper& first,
                const btCollisionObjectWrapper& second);
    void forget(btCollisionAlgorithm*& algorithm);

    Archive& archive_;
    btCollisionDispatcher& dispatcher_;
    const btDispatcherInfo& info_;
    std::vector<btPersistentManifold*> manifolds_;
};

/// Boxes as the broad phase holds them, and which of its lists each body is in. `in_world` are the
/// bodies behind its proxies; when read, they have proxies with no pairs yet.
void serialize_boxes(Archive& archive,
                     btDbvtBroadphase& broadphase,
                     const std::vector<BodyRecord*>& in_world);

}  // namespace plumbline::physics
