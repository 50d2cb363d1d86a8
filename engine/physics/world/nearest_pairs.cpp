#include "engine/physics/world/nearest_pairs.h"

#include "engine/physics/bullet/contact/pair_collider.h"

#include <algorithm>
#include <limits>

namespace plumbline::physics {

bool NearestPairs::is_near(const Pair& pair) {
    const BodyRecord& a = *pair.a;
    const BodyRecord& b = *pair.b;
    return rank_beside(a, b) <= last_beside(a) || rank_beside(b, a) <= last_beside(b);
}

NearestPairs::Rank NearestPairs::rank_beside(const BodyRecord& body, const BodyRecord& other) {
    const Real apart_m = glm::distance(body.motion->at.position_m, other.motion->at.position_m);
    return {.distance_m = apart_m - other.traits.radius_m, .id = other.id};
}

/// The last of the nearest; one behind all others where there are no more than that.
const NearestPairs::Rank& NearestPairs::last_beside(const BodyRecord& body) {
    const auto [place, is_new] =
        last_.try_emplace(&body, Rank{.distance_m = std::numeric_limits<Real>::infinity()});
    Rank& last = place->second;
    if (!is_new) return last;
    ranks_.clear();
    for (const PairLink& link : body.small.pairs) {
        const BodyRecord& other = partner(*link.pair, body);
        if (pushable(other) && boxes_overlap(*link.pair))
            ranks_.push_back(rank_beside(body, other));
    }
    if (ranks_.size() <= kNearestPairs) return last;
    const auto nth = ranks_.begin() + (kNearestPairs - 1);
    std::nth_element(ranks_.begin(), nth, ranks_.end());
    last = *nth;
    return last;
}

}  // namespace plumbline::physics
