// Which bodies' boxes make a pair.
#pragma once

#include "engine/physics/bullet/rigid_body.h"
#include "engine/physics/world/body_record.h"

namespace plumbline::physics {

/// Groups must agree both ways, something must be able to give way, no joint forbids it, and it is not
/// one of a crowd.
class PairFilter final : public btOverlapFilterCallback {
public:
    bool needBroadphaseCollision(btBroadphaseProxy* first,
                                 btBroadphaseProxy* second) const override;

    /// One of so many pairs of the body has been made: whether it is in a crowd.
    void note_pair(BodyRecord& record, std::size_t pairs) {
        if (pairs > kNearestPairs && record.crowd == nullptr && pushable(record))
            begin_crowd(record);
    }

    const PairRules* rules{nullptr};
    bool takes_crowds{false};  ///< whoever asks has chosen the pair
    bool has_crowds{false};    ///< there was one

private:
    void begin_crowd(BodyRecord& record);
};

/// The body behind a box of the broad phase, and its box.
BodyRecord& record_behind(const btBroadphaseProxy& proxy);
inline btDbvtProxy& proxy_of(const BodyRecord& record) {
    return static_cast<btDbvtProxy&>(*record.rigid->getBroadphaseHandle());
}

inline bool boxes_overlap(const btBroadphaseProxy& a, const btBroadphaseProxy& b) {
    return TestAabbAgainstAabb2(a.m_aabbMin, a.m_aabbMax, b.m_aabbMin, b.m_aabbMax);
}

/// Of two such bodies NearestPairs chooses the pair; the broad phase does not.
inline bool are_crowded(const BodyRecord& a, const BodyRecord& b) {
    return a.crowd != nullptr && b.crowd != nullptr && pushable(a) && pushable(b);
}

/// Bullet's own pairs, counted by body.
class CountedPairs final : public btHashedOverlappingPairCache {
public:
    /// The filter outlives it.
    explicit CountedPairs(PairFilter& filter) : filter_(filter) {
        setOverlapFilterCallback(&filter);
    }
    btBroadphasePair* addOverlappingPair(btBroadphaseProxy* first,
                                         btBroadphaseProxy* second) override;
    void* removeOverlappingPair(btBroadphaseProxy* first,
                                btBroadphaseProxy* second,
                                btDispatcher* dispatcher) override;

private:
    PairFilter& filter_;
};

}  // namespace plumbline::physics
