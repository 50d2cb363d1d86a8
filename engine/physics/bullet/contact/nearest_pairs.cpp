#include "engine/physics/bullet/contact/nearest_pairs.h"

#include "engine/physics/bullet/body.h"
#include "engine/physics/bullet/contact/pair_filter.h"

#include <algorithm>
#include <limits>

namespace plumbline::physics {
namespace {

bool bodies_overlap(const BodyRecord& a, const BodyRecord& b) {
    return boxes_overlap(proxy_of(a), proxy_of(b));
}

/// Lists the bodies of leaves.
class LeafList final : public btDbvt::ICollide {
public:
    explicit LeafList(std::vector<BodyRecord*>& list) : list_(list) {}
    void Process(const btDbvtNode* leaf) override {
        list_.push_back(&record_behind(*static_cast<const btDbvtProxy*>(leaf->data)));
    }

private:
    std::vector<BodyRecord*>& list_;
};

NearRank rank_beside(const BodyRecord& body, const BodyRecord& other) {
    const Real apart_m = glm::distance(body.motion->at.position_m, other.motion->at.position_m);
    return {.distance_m = apart_m - other.traits.radius_m, .id = other.id};
}

}  // namespace

bool NearestPairs::needed() const {
    return filter_.has_crowds;
}

void NearestPairs::begin_step() {
    ++step_;
    left_out_ = 0;
}

void NearestPairs::complete(BodyRecord& body) {
    list_near(body, near_);
    if (near_.size() > kNearestPairs) {
        rank(body, near_);
        const Crowd& crowd = *body.crowd;
        const auto is_for_other = [&](const BodyRecord* other) {
            if (!are_crowded(body, *other)) return false;
            if (!bodies_overlap(body, *other)) return true;
            if (rank_beside(body, *other) <= crowd.last) return false;
            // An active one adds the pair itself.
            const bool is_last = !is_active(*other) || other->crowd->completed == step_;
            const bool is_taken = is_last && rank_beside(*other, body) <= crowd_of(*other).last;
            if (is_last && !is_taken) ++left_out_;
            return is_active(*other) || !is_taken;
        };
        std::erase_if(near_, is_for_other);
        body.crowd->completed = step_;
    } else {
        body.crowd.reset();
    }
    std::sort(near_.begin(), near_.end(), by_id);
    filter_.takes_crowds = true;
    for (const BodyRecord* other : near_)
        pairs_.addOverlappingPair(body.rigid->getBroadphaseHandle(),
                                  other->rigid->getBroadphaseHandle());
    filter_.takes_crowds = false;
}

bool NearestPairs::takes_part(const BodyRecord& a, const BodyRecord& b) {
    return !are_crowded(a, b) || rank_beside(a, b) <= crowd_of(a).last ||
           rank_beside(b, a) <= crowd_of(b).last;
}

Crowd& NearestPairs::crowd_of(const BodyRecord& body) {
    if (body.crowd->ranked != step_) {
        list_near(body, others_);
        rank(body, others_);
    }
    return *body.crowd;
}

/// Its last is behind all others where there are no more than the nearest.
void NearestPairs::rank(const BodyRecord& body, const std::vector<BodyRecord*>& near) {
    Crowd& crowd = *body.crowd;
    crowd.ranked = step_;
    crowd.last = {.distance_m = std::numeric_limits<Real>::infinity()};
    ranks_.clear();
    for (const BodyRecord* other : near) {
        if (pushable(*other) && bodies_overlap(body, *other))
            ranks_.push_back(rank_beside(body, *other));
    }
    if (ranks_.size() <= kNearestPairs) return;
    const auto nth = ranks_.begin() + (kNearestPairs - 1);
    std::nth_element(ranks_.begin(), nth, ranks_.end());
    crowd.last = *nth;
}

/// Those that may touch it and whose leaves its own overlaps, in the order of the trees.
void NearestPairs::list_near(const BodyRecord& body, std::vector<BodyRecord*>& near) {
    near.clear();
    LeafList list(near);
    for (const btDbvt& set : boxes_.m_sets)
        set.collideTV(set.m_root, proxy_of(body).leaf->volume, list);
    filter_.takes_crowds = true;
    btBroadphaseProxy* proxy = body.rigid->getBroadphaseHandle();
    std::erase_if(near, [&](const BodyRecord* other) {
        return other == &body ||
               !filter_.needBroadphaseCollision(proxy, other->rigid->getBroadphaseHandle());
    });
    filter_.takes_crowds = false;
}

}  // namespace plumbline::physics
