#include "engine/physics/bullet/contact/pair_filter.h"

#include "engine/physics/bullet/rigid_body.h"

namespace plumbline::physics {
namespace {

std::uint32_t& pairs_of(const btBroadphaseProxy& proxy) {
    return record_behind(proxy).rigid->pairs;
}

}  // namespace

BodyRecord& record_behind(const btBroadphaseProxy& proxy) {
    return record_of(*static_cast<const btCollisionObject*>(proxy.m_clientObject));
}

bool PairFilter::needBroadphaseCollision(btBroadphaseProxy* first,
                                         btBroadphaseProxy* second) const {
    const BodyRecord& a = record_behind(*first);
    const BodyRecord& b = record_behind(*second);
    if (a.rigid->isStaticOrKinematicObject() && b.rigid->isStaticOrKinematicObject()) return false;
    if (!takes_crowds && are_crowded(a, b)) return false;
    return may_touch(a.filter, b.filter) && !collision_excluded(a, b) &&
           (rules == nullptr || rules->may_touch(a.user, b.user));
}

void PairFilter::begin_crowd(BodyRecord& record) {
    record.crowd = std::make_unique<Crowd>();
    has_crowds = true;
}

btBroadphasePair* CountedPairs::addOverlappingPair(btBroadphaseProxy* first,
                                                   btBroadphaseProxy* second) {
    const int before = getNumOverlappingPairs();
    btBroadphasePair* pair = btHashedOverlappingPairCache::addOverlappingPair(first, second);
    if (getNumOverlappingPairs() == before) return pair;
    for (const btBroadphaseProxy* proxy : {first, second})
        filter_.note_pair(record_behind(*proxy), ++pairs_of(*proxy));
    return pair;
}

void* CountedPairs::removeOverlappingPair(btBroadphaseProxy* first,
                                          btBroadphaseProxy* second,
                                          btDispatcher* dispatcher) {
    const int before = getNumOverlappingPairs();
    void* info = btHashedOverlappingPairCache::removeOverlappingPair(first, second, dispatcher);
    if (getNumOverlappingPairs() == before) return info;
    for (const btBroadphaseProxy* proxy : {first, second}) --pairs_of(*proxy);
    return info;
}

}  // namespace plumbline::physics
