// Contact points of one pair of bodies, found by Bullet's algorithms and by ours.
//
// Points are found before bodies touch when they close fast enough to meet within the step. What is
// farther than that is dropped again at once, so slow pairs keep Bullet's distances.
#pragma once

#include "engine/physics/collision/pair.h"

#include <memory>
#include <vector>

namespace plumbline::physics {

class BulletEngine;

/// What colliding needs to know of the step.
struct CollideStep {
    Real step_s{0};
    Real fall_m{0};  ///< what gravity adds to any motion within the step, at most
};

/// The impact of a pair that meets within the step.
struct PairImpact {
    PredictedChange on_a;
    PredictedChange on_b;
};

class PairCollider {
public:
    explicit PairCollider(BulletEngine& engine);
    ~PairCollider();

    void begin_step(const CollideStep& step);

    /// How far apart points must be found so that none is missed, with the predicted changes known so far.
    Real reach_of(const Pair& pair) const;
    /// Finds the pair's points within its reach and keeps those that the bodies can close.
    void collide(Pair& pair);
    /// Whether predicted changes since the pair's latest look let its bodies come noticeably farther.
    bool knows_less(const Pair& pair) const;
    /// Forgets the points of bodies whose boxes have parted.
    void separate(Pair& pair);
    /// The impact of a pair that meets within this step faster than it rests.
    PairImpact impact_of(const Pair& pair) const;
    /// The pair's manifolds that have points, in an order that does not depend on addresses.
    void list_manifolds(Pair& pair, std::vector<Manifold*>& list) const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Whether the boxes that the broad phase holds overlap.
bool boxes_overlap(const Pair& pair);
/// Whether the broad phase may forget the pair: it will find it again when either body moves on.
bool boxes_are_far(const Pair& pair);

}  // namespace plumbline::physics
