// Which pairs of a crowd take part in a step.
//
// n bodies on one spot are n(n-1)/2 pairs. A pair of two dynamic bodies has contact points only where it is
// among the nearest of either: at most kNearestPairs * n have. Bodies that are not crowded cost nothing,
// and a large body keeps all the small ones that it carries, as each has few.
#pragma once

#include "engine/core/math.h"
#include "engine/physics/collision/pair.h"
#include "engine/physics/physics_world.h"
#include "engine/physics/world/body_record.h"

#include <compare>
#include <unordered_map>
#include <vector>

namespace plumbline::physics {

/// Decides by poses, boxes and ids alone, so the order of questions does not matter.
class NearestPairs {
public:
    /// Poses or boxes have changed.
    void begin_step() { last_.clear(); }
    /// Of bodies whose boxes overlap. Pairs with static, frozen and kinematic bodies always do.
    bool takes_part(const Pair& pair) {
        return !may_be_crowded(*pair.a) || !may_be_crowded(*pair.b) || is_near(pair);
    }

private:
    static bool may_be_crowded(const BodyRecord& body) {
        return body.small.pairs.size() > kNearestPairs && pushable(body);
    }
    /// A body's place among those near another: by the distance to the ball round it, so that large
    /// ones come first, then by id.
    struct Rank {
        Real distance_m{0};
        BodyId id{};

        friend auto operator<=>(const Rank&, const Rank&) = default;
    };

    /// Of two that may be crowded.
    bool is_near(const Pair& pair);
    static Rank rank_beside(const BodyRecord& body, const BodyRecord& other);
    const Rank& last_beside(const BodyRecord& body);

    std::unordered_map<const BodyRecord*, Rank> last_;  ///< of the nearest, by crowded body
    std::vector<Rank> ranks_;
};

}  // namespace plumbline::physics
