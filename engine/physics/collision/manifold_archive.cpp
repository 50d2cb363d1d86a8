#include "engine/physics/collision/manifold_archive.h"

#include "engine/core/io/pose_archive.h"
#include "engine/physics/collision/pair_points.h"
#include "engine/physics/world/body_record.h"

namespace plumbline::physics {
namespace {

void serialize_side(Archive& archive, ContactSide& side) {
    archive(
        side.radius_m, side.offset_m, side.surface_m, side.local_m, side.axis, side.is_moving_face);
}

void serialize_point(Archive& archive, ManifoldPoint& point) {
    serialize_side(archive, point.a);
    serialize_side(archive, point.b);
    archive(point.normal_world,
            point.distance_m,
            point.age_steps,
            point.feature,
            point.load.normal_N,
            point.load.friction_N,
            point.load.twist_Nm,
            point.normal_Ns);
}

void serialize_manifold(Archive& archive, Manifold& manifold) {
    archive(manifold.part_a,
            manifold.part_b,
            manifold.features_made,
            manifold.load.step,
            manifold.load.age_steps,
            manifold.load.normal_N,
            manifold.load.before_N,
            manifold.load.lasting_N,
            manifold.load.friction_N,
            manifold.load.rolling_Nm);
    std::size_t count = archive.count(manifold.points.size());
    if (archive.failed()) count = 0;
    manifold.points.resize(count);
    for (ManifoldPoint& point : manifold.points) serialize_point(archive, point);
}

}  // namespace

void serialize_pair(Archive& archive, Pair& pair) {
    archive(pair.reach_m, pair.touches);
    std::size_t count = archive.count(pair.manifolds.size());
    if (archive.failed()) count = 0;
    pair.manifolds.resize(count);
    for (Manifold& manifold : pair.manifolds) {
        serialize_manifold(archive, manifold);
        if (!archive.reads()) continue;
        manifold.a = pair.a;
        manifold.b = pair.b;
        manifold.material = material_of(manifold);
    }
}

}  // namespace plumbline::physics
