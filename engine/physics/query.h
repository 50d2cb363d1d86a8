// Rays, sweeps and overlaps.
#pragma once

#include "engine/physics/body.h"
#include "engine/physics/contact.h"

#include <optional>
#include <vector>

namespace plumbline::physics {

class PhysicsWorld;

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

/// The first body hit from outside; one that the ray starts in is not hit.
std::optional<RayHit> cast_ray(const PhysicsWorld& world,
                               const Vec3& from_world,
                               const Vec3& to_world,
                               const QueryFilter& filter = {});
/// Moves a convex shape along a straight line; meshes and compounds may be hit, not swept. Stops
/// within 0.01 mm of touching. Overlap at the start stops it at fraction 0 only on a way deeper.
std::optional<SweepHit> sweep(const PhysicsWorld& world,
                              ShapeId shape,
                              const Pose& from,
                              const Vec3& to_position_world,
                              const QueryFilter& filter = {});
/// Bodies within `margin_m` of a convex shape, deepest first; a body of several pieces or
/// triangles may be listed several times.
std::vector<OverlapHit> overlaps(const PhysicsWorld& world,
                                 ShapeId shape,
                                 const Pose& pose,
                                 Real margin_m,
                                 const QueryFilter& filter = {});
/// Bodies whose boxes touch this one, in the order of their ids.
std::vector<BodyId> bodies_in_box(const PhysicsWorld& world,
                                  const Vec3& min_world,
                                  const Vec3& max_world,
                                  const QueryFilter& filter = {});
/// Every contact point of the latest step, those of sleeping bodies too, pair by pair; `points` is overwritten.
void contact_points(const PhysicsWorld& world, std::vector<ContactPoint>& points);
/// World-space box of a body's shape at its present pose.
void bounds(const PhysicsWorld& world, BodyId id, Vec3& min_world, Vec3& max_world);

}  // namespace plumbline::physics
