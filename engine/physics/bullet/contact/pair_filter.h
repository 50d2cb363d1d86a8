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

    bool takes_crowds{
        false};  ///< whoever asks has chosen the pair or goes on choosing: NearestPairs
};

/// The body behind a box of the broad phase, and its box.
BodyRecord& record_behind(const btBroadphaseProxy& proxy);
inline btDbvtProxy& proxy_of(const BodyRecord& record) {
    return static_cast<btDbvtProxy&>(*record.rigid->getBroadphaseHandle());
}

/// A pair more that lists `pairs` of a body in all: whether the body is in a crowd.
inline void note_crowd(BodyRecord& record, std::size_t pairs) {
    if (pairs > kNearestPairs && record.crowd == nullptr && pushable(record))
        record.crowd = std::make_unique<Crowd>();
}

/// Of two such bodies NearestPairs chooses the pair; the broad phase does not.
inline bool are_crowded(const BodyRecord& a, const BodyRecord& b) {
    return a.crowd != nullptr && b.crowd != nullptr && pushable(a) && pushable(b);
}

/// Bullet's own pairs, counted by body.
class CountedPairs final : public btHashedOverlappingPairCache {
public:
    btBroadphasePair* addOverlappingPair(btBroadphaseProxy* first,
                                         btBroadphaseProxy* second) override;
    void* removeOverlappingPair(btBroadphaseProxy* first,
                                btBroadphaseProxy* second,
                                btDispatcher* dispatcher) override;
};

}  // namespace plumbline::physics
