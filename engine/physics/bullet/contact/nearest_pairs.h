// Which pairs of a crowd take part in a step.
//
// n bodies on one spot are n(n-1)/2 pairs. A pair of two dynamic bodies has contact points only where it is
// among the nearest of either: at most kNearestPairs * n have. Of two bodies that have more pairs than
// that the broad phase reports none (PairFilter): theirs are chosen here, step by step. Bodies that are
// not crowded cost nothing, and a large body keeps all the small ones that it carries, as each has few.
#pragma once

#include "engine/physics/physics_world.h"
#include "engine/physics/world/body_record.h"

#include <cstdint>
#include <vector>

class btOverlappingPairCache;
struct btDbvtBroadphase;

namespace plumbline::physics {

class PairFilter;

/// Decides by poses, boxes and ids alone, so the order of questions does not matter.
class NearestPairs {
public:
    /// All three outlive it.
    NearestPairs(const btDbvtBroadphase& boxes, btOverlappingPairCache& pairs, PairFilter& filter)
        : boxes_(boxes), pairs_(pairs), filter_(filter) {}

    /// Whether any body ever was crowded.
    bool needed() const;
    /// Poses or boxes have changed.
    void begin_step();
    /// Adds what is missing among the pairs of an active crowded body; every such body is completed in
    /// each step. Finds out whether it still is crowded.
    void complete(BodyRecord& body);
    /// Whether the pair takes part. Only one of two crowded bodies may not.
    bool takes_part(const BodyRecord& a, const BodyRecord& b);
    /// How many pairs of bodies whose boxes overlap take no part in this step.
    std::uint64_t left_out() const { return left_out_; }

private:
    Crowd& crowd_of(const BodyRecord& body);
    void rank(const BodyRecord& body, const std::vector<BodyRecord*>& near);
    void list_near(const BodyRecord& body, std::vector<BodyRecord*>& near);

    const btDbvtBroadphase& boxes_;
    btOverlappingPairCache& pairs_;
    PairFilter& filter_;
    std::uint32_t step_{0};
    std::uint64_t left_out_{0};
    std::vector<BodyRecord*> near_;
    std::vector<BodyRecord*> others_;
    std::vector<NearRank> ranks_;
};

}  // namespace plumbline::physics
