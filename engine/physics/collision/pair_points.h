// Contact points of a pair of bodies, part by part, step after step.
#pragma once

#include "engine/physics/collision/narrow_phase/collide.h"
#include "engine/physics/collision/pair_reach.h"

#include <span>

namespace plumbline::physics {

/// Finds the pair's points within its reach and keeps those that the bodies can close.
void find_points(Pair& pair, const CollideStep& step);
/// Forgets the points of bodies whose boxes have parted.
void separate(Pair& pair);

/// What the materials of its two parts make together.
Material material_of(const Manifold& manifold);

/// Two parts of a manifold and where they are; null: a mesh's triangles.
struct ManifoldParts {
    const PlacedShape* a{nullptr};
    const PlacedShape* b{nullptr};
};

/// The manifold has these points from now on, in their order; those that were there before keep their features and
/// loads, wherever in the list they were, if they moved by less than `same_m`.
void renew_points(Manifold& manifold,
                  const ManifoldParts& parts,
                  std::span<const ConvexPoint> found,
                  Real same_m,
                  const CollideStep& step = {});

}  // namespace plumbline::physics
