// Contact points of one pair of bodies: primitives' by our narrow phase, others' by Bullet's algorithms.
#pragma once

#include "engine/physics/collision/pair_reach.h"

#include <memory>

namespace plumbline::physics {

class BulletEngine;

class PairCollider {
public:
    explicit PairCollider(BulletEngine& engine);
    ~PairCollider();

    /// Finds the pair's points within its reach and keeps those that the bodies can close.
    void collide(Pair& pair, const CollideStep& step);
    /// Forgets the points of bodies whose boxes have parted.
    void separate(Pair& pair);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Whether the boxes that the broad phase holds overlap.
bool boxes_overlap(const Pair& pair);
/// Whether the broad phase may forget the pair: it will find it again when either body moves on.
bool boxes_are_far(const Pair& pair);

}  // namespace plumbline::physics
