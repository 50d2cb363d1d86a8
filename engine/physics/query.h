// Rays, sweeps and overlaps.
#pragma once

#include "engine/physics/body.h"

#include <functional>
#include <optional>

namespace plumbline::physics {

/// Which bodies a query sees.
struct QueryFilter {
    std::uint32_t collides_with{~0U};  ///< groups seen
    /// One body not seen, e.g. the one that asks; nor are those that a joint keeps it from touching.
    BodyId ignored{};
    BodyId also_ignored{};
};

struct RayHit {
    BodyId body{};
    std::uint64_t user{0};
    Vec3 point_world{0, 0, 0};
    Vec3 normal_world{0, 1, 0};  ///< unit, out of the body that was hit
    Real distance_m{0};
};

struct SweepHit {
    BodyId body{};
    std::uint64_t user{0};
    Vec3 point_world{0, 0, 0};
    Vec3 normal_world{0, 1, 0};  ///< unit, from the body hit towards the moving shape
    Real fraction{1};            ///< 0…1 of the motion done before touching
};

/// One body that a shape overlaps or nearly touches.
struct OverlapHit {
    BodyId body{};
    std::uint64_t user{0};
    Vec3 point_world{0, 0, 0};
    Vec3 normal_world{0, 1, 0};  ///< unit, the way out for the shape that asks
    Real depth_m{0};             ///< > 0 when overlapping; negative: distance
};

}  // namespace plumbline::physics
