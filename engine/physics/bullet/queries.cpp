// Rays, sweeps and overlaps.
#include "engine/physics/bullet/body.h"
#include "engine/physics/bullet/convert.h"
#include "engine/physics/bullet/convex_query.h"
#include "engine/physics/bullet/rigid_body.h"
#include "engine/physics/bullet/shape/shape_record.h"
#include "engine/physics/bullet/step_world.h"
#include "engine/physics/query.h"
#include "engine/physics/world/world_state.h"

#include <algorithm>

namespace plumbline::physics {
namespace {

const BodyRecord* record_or_null(const BodyTable& bodies, BodyId id) {
    const auto* found = bodies.find(id);
    return found != nullptr ? found->get() : nullptr;
}

BodyFilter filter_for(const QueryFilter& filter, const BodyTable& bodies) {
    return {.collides_with = filter.collides_with,
            .ignored = record_or_null(bodies, filter.ignored),
            .also_ignored = record_or_null(bodies, filter.also_ignored)};
}

/// Where the convex shape of `record` is when its body stands at `pose`.
btTransform convex_at(const ShapeRecord& record, const Pose& pose) {
    const Pose mass = record.mass_frame_is_body ? pose : compose(pose, record.body_from_mass);
    return to_bullet(mass) * record.mass_from_convex;
}

}  // namespace

std::optional<RayHit> cast_ray(const PhysicsWorld& world,
                               const Vec3& from_world,
                               const Vec3& to_world,
                               const QueryFilter& filter) {
    if (!is_finite(from_world) || !is_finite(to_world) || from_world == to_world) {
        return std::nullopt;
    }
    const auto hit = ray_among(internals(world).engine->world(),
                               to_bullet(from_world),
                               to_bullet(to_world),
                               filter_for(filter, internals(world).bodies));
    if (!hit) return std::nullopt;
    return RayHit{.body = hit->record->id,
                  .user = hit->record->user,
                  .point_world = from_bullet(hit->point),
                  .normal_world = from_bullet(hit->normal),
                  .distance_m = hit->fraction * glm::distance(from_world, to_world)};
}

std::optional<SweepHit> sweep(const PhysicsWorld& world,
                              ShapeId shape,
                              const Pose& from,
                              const Vec3& to_position_world,
                              const QueryFilter& filter) {
    const ShapeRecord& record = internals(world).shapes.get(shape);
    PL_ASSERT(record.convex != nullptr, "a convex shape to sweep");
    if (!is_finite(from) || !is_finite(to_position_world)) return std::nullopt;
    const btVector3 motion = to_bullet(to_position_world - from.position);
    if (motion.isZero()) return std::nullopt;
    const auto hit = cast_among(internals(world).engine->world(),
                                *record.convex,
                                convex_at(record, from),
                                motion,
                                filter_for(filter, internals(world).bodies));
    if (!hit) return std::nullopt;
    return SweepHit{.body = hit->record->id,
                    .user = hit->record->user,
                    .point_world = from_bullet(hit->point),
                    .normal_world = from_bullet(hit->normal),
                    .fraction = hit->fraction};
}

std::vector<OverlapHit> overlaps(const PhysicsWorld& world,
                                 ShapeId shape,
                                 const Pose& pose,
                                 Real margin_m,
                                 const QueryFilter& filter) {
    const ShapeRecord& record = internals(world).shapes.get(shape);
    PL_ASSERT(record.convex != nullptr, "a convex shape to overlap");
    std::vector<OverlapHit> hits;
    if (!is_finite(pose)) return hits;
    const btTransform at = convex_at(record, pose);
    btVector3 low;
    btVector3 high;
    record.convex->getAabb(at, low, high);
    const btVector3 reach(margin_m, margin_m, margin_m);
    low -= reach;
    high += reach;
    const BodyFilter seen = filter_for(filter, internals(world).bodies);
    for (const BodyRecord* other :
         bodies_in_box(internals(world).engine->world(), low, high, seen)) {
        each_convex(*other->rigid->getCollisionShape(),
                    other->rigid->getWorldTransform(),
                    low,
                    high,
                    [&](const btConvexShape& piece, const btTransform& world_from_piece) {
                        const auto closest = closest_points(
                            *record.convex, at, piece, world_from_piece, margin_m, AtDepth::Any);
                        if (!closest) return;
                        hits.push_back({.body = other->id,
                                        .user = other->user,
                                        .point_world = from_bullet(closest->point_on_b),
                                        .normal_world = from_bullet(closest->normal),
                                        .depth_m = -closest->distance});
                    });
    }
    std::stable_sort(hits.begin(), hits.end(), [](const OverlapHit& a, const OverlapHit& b) {
        return a.depth_m > b.depth_m;
    });
    return hits;
}

std::vector<BodyId> bodies_in_box(const PhysicsWorld& world,
                                  const Vec3& min_world,
                                  const Vec3& max_world,
                                  const QueryFilter& filter) {
    std::vector<BodyId> found;
    for (const BodyRecord* record : bodies_in_box(internals(world).engine->world(),
                                                  to_bullet(min_world),
                                                  to_bullet(max_world),
                                                  filter_for(filter, internals(world).bodies)))
        found.push_back(record->id);
    return found;
}

void bounds(const PhysicsWorld& world, BodyId id, Vec3& min_world, Vec3& max_world) {
    const Box box = box_of(internals(world).body(id));
    min_world = box.low;
    max_world = box.high;
}

}  // namespace plumbline::physics
