// How far apart two bodies' points are searched, and what points say of the step.
//
// Points are found before bodies touch when they close fast enough to collide within the step. What is
// farther than that is dropped again at once, so slow pairs keep Bullet's distances.
#pragma once

#include "engine/physics/collision/pair.h"

namespace plumbline::physics {

/// What colliding needs to know of the step.
struct CollideStep {
    Real step_s{0};
    Real drop_m{0};                   ///< what gravity adds to any motion within the step, at most
    const PairRules* rules{nullptr};  ///< the world's
    bool again{false};                ///< within a step: what the points carried in it so far stays
    bool refined{false};      ///< the points were found just before, with fewer impacts foretold
    bool only_struck{false};  ///< what moves as it did before the latest impact keeps its points
    bool turned_back{false};  ///< impacts have led bodies out of the boxes that the step began with
};

/// The impact of a pair that collides within the step.
struct PairImpact {
    PredictedChange on_a;
    PredictedChange on_b;
};

/// How far ahead of a body points are looked for: what it moves beyond that is swept. Thin bodies turn onto their faces
/// faster than they are thick.
Real ahead_m(const BodyRecord& record);
/// How far apart points must be found so that none is missed, with the predicted changes known so far.
Real reach_of(const Pair& pair, const CollideStep& step);
/// Whether the balls round the two are within that.
bool are_within_reach(const Pair& pair, const CollideStep& step);
/// Points of the pair count up to this distance, however slowly the bodies close.
Real near_m(const Pair& pair);
/// Of both bodies.
Real predicted_mps(const Pair& pair);
/// Whether predicted changes since the pair's latest test let its bodies come noticeably farther.
bool knows_less(const Pair& pair, const CollideStep& step);

/// What the record's surface moves by as it turns, at most.
Real spin_mps(const BodyRecord& record);
/// Whether the bodies can close the point within the step: near ones count anyway.
bool is_reachable(const Manifold& manifold,
                  const ManifoldPoint& point,
                  Real near_m,
                  const CollideStep& step);

/// The impact of a pair that collides within this step faster than it rests.
PairImpact impact_of(const Pair& pair, const CollideStep& step);

}  // namespace plumbline::physics
