// Pairs of bodies whose boxes overlap, kept by body.
//
// Takes the place of Bullet's own pair cache for small_step: a step visits only the pairs of the
// bodies that it moves, and finds them in an order that ids decide.
#pragma once

#include "engine/physics/bullet/contact/pair_boxes.h"
#include "engine/physics/bullet/contact/pair_filter.h"
#include "engine/physics/collision/pair.h"

#include <btBulletDynamicsCommon.h>

#include <cstdint>
#include <deque>
#include <vector>

namespace plumbline::physics {

/// Bullet's side of a pair.
struct BulletPair : Pair {
    const btDbvtProxy* box_a{nullptr};
    const btDbvtProxy* box_b{nullptr};
};

inline BulletPair& bullet_side(Pair& pair) {
    return static_cast<BulletPair&>(pair);
}
inline const BulletPair& bullet_side(const Pair& pair) {
    return static_cast<const BulletPair&>(pair);
}

class PairList final : public btOverlappingPairCache {
public:
    explicit PairList(PairFilter& filter) : filter_(filter) {}

    std::size_t size() const { return size_; }
    /// Frees its manifolds.
    void remove(Pair& pair);
    /// Every manifold, in an order that does not depend on addresses.
    template <class Fn>
    void each_manifold(Fn&& fn) const {
        for (const BulletPair& pair : pool_) {
            for (const Manifold& manifold : pair.manifolds) fn(manifold);
        }
    }

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
    void setOverlapFilterCallback(btOverlapFilterCallback*) override {}
    btOverlapFilterCallback* getOverlapFilterCallback() override { return &filter_; }
    bool needsBroadphaseCollision(btBroadphaseProxy* first,
                                  btBroadphaseProxy* second) const override {
        return filter_.needBroadphaseCollision(first, second);
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
    PairFilter& filter_;
    btBroadphasePairArray none_;
    std::deque<BulletPair> pool_;
    std::vector<BulletPair*> free_;
    std::size_t size_{0};
};

}  // namespace plumbline::physics
