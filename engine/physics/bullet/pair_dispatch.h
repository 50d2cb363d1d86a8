// Contact points of one pair of bodies, found by Bullet's algorithms.
//
// Points are found before bodies touch when they close fast enough to meet within the step. What is
// farther than that is dropped again at once, so slow pairs keep Bullet's distances.
#pragma once

#include "engine/physics/bullet/pair_list.h"

#include <btBulletDynamicsCommon.h>

#include <vector>

namespace plumbline::physics {

/// Makes manifolds that reach as far as the pair at work.
class PairDispatcher final : public btCollisionDispatcher {
public:
    explicit PairDispatcher(btCollisionConfiguration* configuration)
        : btCollisionDispatcher(configuration) {}

    btPersistentManifold* getNewManifold(const btCollisionObject* a,
                                         const btCollisionObject* b) override;
    /// Who walks the pairs decides; algorithms ask again while they are made.
    bool needsCollision(const btCollisionObject*, const btCollisionObject*) override {
        return true;
    }

    btScalar reach_m{0};
    int manifolds_made{0};  ///< ever; numbers them
};

/// What meeting needs to know of the step.
struct MeetStep {
    btScalar step_s{0};
    btScalar fall_m{0};  ///< what gravity adds to any motion within the step, at most
};

/// The blow of a pair that meets within the step.
struct Blow {
    Jolt on_a;
    Jolt on_b;
};

class PairMeeting {
public:
    PairMeeting(PairDispatcher& dispatcher, const btDispatcherInfo& info)
        : dispatcher_(dispatcher), info_(info) {}

    void begin_step(const MeetStep& step) { step_ = step; }

    /// How far apart points must be found so that none is missed, with the jolts known so far.
    btScalar reach_of(const Pair& pair) const;
    /// Finds the pair's points within its reach and keeps those that the bodies can close.
    void meet(Pair& pair);
    /// Whether jolts since the pair's latest look let its bodies come noticeably farther.
    bool knows_less(const Pair& pair) const;
    /// Forgets the points of bodies whose boxes have parted.
    void part(Pair& pair);
    /// The blow of a pair that meets within this step faster than it rests.
    Blow blow_of(const Pair& pair) const;
    /// The pair's manifolds that have points, in an order that does not depend on addresses.
    void list_manifolds(Pair& pair, std::vector<Manifold*>& list) const;

private:
    void collide(BulletPair& pair);
    void drop_unreachable(btPersistentManifold& from, Manifold& manifold, btScalar base_m) const;

    PairDispatcher& dispatcher_;
    const btDispatcherInfo& info_;
    MeetStep step_{};
    btManifoldArray manifolds_;
};

/// Whether the boxes that the broad phase holds overlap.
bool boxes_overlap(const Pair& pair);
/// Whether the broad phase may forget the pair: it will find it again when either body moves on.
bool boxes_are_far(const Pair& pair);

}  // namespace plumbline::physics
