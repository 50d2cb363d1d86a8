// Pairs of bodies whose boxes overlap, kept by body.
//
// Takes the place of Bullet's own pair cache for small_step: a step looks only at the pairs of the
// bodies that it moves, and finds them in an order that ids decide.
#pragma once

#include "engine/physics/physics_world.h"

#include <btBulletDynamicsCommon.h>

#include <cstdint>
#include <deque>
#include <vector>

namespace plumbline::physics {

struct BodyRecord;

/// What the blows of a step may do to a body's velocity: others that it did not move towards may
/// then be in its way.
struct Jolt {
    btVector3 change_mps{0, 0, 0};  ///< the largest
    bool backed{false};             ///< ... from what does not give way
    bool spread{false};             ///< its pairs have been looked at again
};

/// Two bodies that may touch. `a` has the lower id.
struct Pair {
    BodyRecord* a{nullptr};
    BodyRecord* b{nullptr};
    const btDbvtProxy* box_a{nullptr};
    const btDbvtProxy* box_b{nullptr};
    btCollisionAlgorithm* algorithm{nullptr};  ///< holds the manifolds; none until boxes overlap
    btScalar base_m{0};                        ///< points of a slow pair count up to this distance
    btScalar reach_m{0};                       ///< and those of the latest step up to this one
    btScalar jolt_mps{0};                      ///< of both bodies, as the latest look knew it
    std::uint32_t seen{0};                     ///< the walk that looked at it last
    bool touches{false};                       ///< has contact points
    bool round{false};                         ///< a ball: its points are new in every step
    bool boxes{false};                         ///< two boxes: likewise, found at any distance
};

inline BodyRecord& partner(const Pair& pair, const BodyRecord& record) {
    return pair.a == &record ? *pair.b : *pair.a;
}

/// A pair as one of its bodies lists it.
struct PairLink {
    BodyId other{};
    Pair* pair{nullptr};
};

class PairList final : public btOverlappingPairCache {
public:
    explicit PairList(btDispatcher& dispatcher);
    ~PairList() override;
    PairList(const PairList&) = delete;
    PairList& operator=(const PairList&) = delete;

    std::size_t size() const { return size_; }
    void remove(Pair& pair);

    // What the broad phase calls. The array that it would tidy up stays empty: pairs whose boxes
    // have parted are found by whoever walks them.
    btBroadphasePair* addOverlappingPair(btBroadphaseProxy* first,
                                         btBroadphaseProxy* second) override;
    void* removeOverlappingPair(btBroadphaseProxy* first,
                                btBroadphaseProxy* second,
                                btDispatcher*) override;
    void removeOverlappingPairsContainingProxy(btBroadphaseProxy* proxy, btDispatcher*) override;
    void cleanProxyFromPairs(btBroadphaseProxy*, btDispatcher*) override {}
    void cleanOverlappingPair(btBroadphasePair&, btDispatcher*) override {}
    void setOverlapFilterCallback(btOverlapFilterCallback* filter) override { filter_ = filter; }
    btOverlapFilterCallback* getOverlapFilterCallback() override { return filter_; }
    bool needsBroadphaseCollision(btBroadphaseProxy* first,
                                  btBroadphaseProxy* second) const override {
        return filter_ == nullptr || filter_->needBroadphaseCollision(first, second);
    }
    bool hasDeferredRemoval() override { return false; }

    btBroadphasePair* getOverlappingPairArrayPtr() override { return nullptr; }
    const btBroadphasePair* getOverlappingPairArrayPtr() const override { return nullptr; }
    btBroadphasePairArray& getOverlappingPairArray() override { return none_; }
    int getNumOverlappingPairs() const override { return 0; }
    btBroadphasePair* findPair(btBroadphaseProxy*, btBroadphaseProxy*) override { return nullptr; }
    void processAllOverlappingPairs(btOverlapCallback*, btDispatcher*) override {}
    void setInternalGhostPairCallback(btOverlappingPairCallback*) override {}
    void sortOverlappingPairs(btDispatcher*) override {}

private:
    void forget_algorithm(Pair& pair);

    btDispatcher& dispatcher_;
    btOverlapFilterCallback* filter_{nullptr};
    btBroadphasePairArray none_;
    std::deque<Pair> pool_;
    std::vector<Pair*> free_;
    std::size_t size_{0};
};

}  // namespace plumbline::physics
