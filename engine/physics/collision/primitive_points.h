// Points of primitives in their manifold, step after step.
#pragma once

#include "engine/physics/collision/narrow_phase/primitive.h"
#include "engine/physics/collision/pair_reach.h"

namespace plumbline::physics {

/// Finds the points of a pair of primitives within pair.reach_m and keeps those that the bodies can
/// close. `manifold` is the pair's.
void collide_primitives(const Pair& pair, Manifold& manifold, const CollideStep& step);

/// The manifold has these points from now on, in their order; those that were there before keep their
/// features and loads, wherever in the list they were. Two that are nearer than `merge_m` on `a` are
/// one, the latter. Both bodies are primitives.
void renew_points(Manifold& manifold, const PrimitiveContact& found, Real merge_m);

}  // namespace plumbline::physics
