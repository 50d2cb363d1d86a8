#include "engine/physics/bullet/contact/pair_list.h"

#include "engine/physics/world/body_record.h"

#include <algorithm>

namespace plumbline::physics {
namespace {

using Links = std::vector<PairLink>;

/// Where the pair with `other` is or would be among the record's.
Links::iterator place_of(BodyRecord& record, BodyId other) {
    return std::lower_bound(record.small.pairs.begin(),
                            record.small.pairs.end(),
                            other,
                            [](const PairLink& link, BodyId id) { return link.other < id; });
}

bool is_pair_with(const BodyRecord& record, Links::iterator place, BodyId other) {
    return place != record.small.pairs.end() && place->other == other;
}

bool is_sphere(const BodyRecord& record) {
    return record.traits.primitive.kind == ConvexShape::Kind::Sphere;
}

bool is_single(const BodyRecord& record) {
    return record.traits.geometry->parts.size() <= 1;
}

}  // namespace

btBroadphasePair* PairList::addOverlappingPair(btBroadphaseProxy* first,
                                               btBroadphaseProxy* second) {
    if (!needsBroadphaseCollision(first, second)) return nullptr;
    if (record_behind(*second).id < record_behind(*first).id) std::swap(first, second);
    BodyRecord& a = record_behind(*first);
    BodyRecord& b = record_behind(*second);
    // Searching the shorter list: the ground has a pair with everybody.
    BodyRecord& few = a.small.pairs.size() < b.small.pairs.size() ? a : b;
    BodyRecord& many = &few == &a ? b : a;
    const auto place = place_of(few, many.id);
    if (is_pair_with(few, place, many.id)) return nullptr;

    BulletPair* pair = nullptr;
    if (free_.empty()) {
        pair = &pool_.emplace_back();
    } else {
        pair = free_.back();
        free_.pop_back();
    }
    *pair = {};
    pair->a = &a;
    pair->b = &b;
    pair->box_a = static_cast<const btDbvtProxy*>(first);
    pair->box_b = static_cast<const btDbvtProxy*>(second);
    pair->base_m = std::min(a.traits.contact_margin_m, b.traits.contact_margin_m);
    pair->round = (is_sphere(a) && is_single(b)) || (is_sphere(b) && is_single(a));
    few.small.pairs.insert(place, {many.id, pair});
    many.small.pairs.insert(place_of(many, few.id), {few.id, pair});
    for (BodyRecord* record : {&a, &b}) filter_.note_pair(*record, record->small.pairs.size());
    ++size_;
    return nullptr;
}

void PairList::remove(Pair& pair) {
    pair.manifolds = {};
    pair.a->small.pairs.erase(place_of(*pair.a, pair.b->id));
    pair.b->small.pairs.erase(place_of(*pair.b, pair.a->id));
    free_.push_back(&bullet_side(pair));
    --size_;
}

void* PairList::removeOverlappingPair(btBroadphaseProxy* first,
                                      btBroadphaseProxy* second,
                                      btDispatcher*) {
    BodyRecord& a = record_behind(*first);
    const BodyId b = record_behind(*second).id;
    const auto place = place_of(a, b);
    if (is_pair_with(a, place, b)) remove(*place->pair);
    return nullptr;
}

void PairList::removeOverlappingPairsContainingProxy(btBroadphaseProxy* proxy, btDispatcher*) {
    BodyRecord& record = record_behind(*proxy);
    while (!record.small.pairs.empty()) remove(*record.small.pairs.back().pair);
}

bool boxes_overlap(const Pair& pair) {
    const BulletPair& side = bullet_side(pair);
    return boxes_overlap(*side.box_a, *side.box_b);
}

bool boxes_are_far(const Pair& pair) {
    const BulletPair& side = bullet_side(pair);
    return !Intersect(side.box_a->leaf->volume, side.box_b->leaf->volume);
}

}  // namespace plumbline::physics
