// Two bodies that may touch, as the world keeps them from step to step.
#pragma once

#include "engine/physics/body.h"
#include "engine/physics/collision/manifold.h"

#include <cstdint>
#include <vector>

namespace plumbline::physics {

/// What the impacts of a step may do to a body's velocity: others that it did not move towards may
/// then be in its way.
struct PredictedChange {
    Vec3 change_mps{0, 0, 0};  ///< the largest
    bool backed{false};        ///< ... from what does not give way
    bool spread{false};        ///< its pairs have been tested again
};

/// `a` has the lower id.
struct Pair {
    BodyRecord* a{nullptr};
    BodyRecord* b{nullptr};
    std::vector<Manifold> manifolds;  ///< in the order of their parts
    Real base_m{0};                   ///< points of a slow pair count up to this distance
    Real reach_m{0};                  ///< and those of the latest step up to this one
    Real predicted_mps{0};            ///< of both bodies, as the latest test knew it
    std::uint32_t seen{0};            ///< the walk that visited it last
    bool touches{false};              ///< has contact points
    bool round{false};                ///< one of them is a sphere
};

inline BodyRecord& partner(const Pair& pair, const BodyRecord& record) {
    return pair.a == &record ? *pair.b : *pair.a;
}

/// A pair as one of its bodies lists it.
struct PairLink {
    BodyId other{};
    Pair* pair{nullptr};
};

}  // namespace plumbline::physics
