#include "engine/physics/world_copy.h"

#include "engine/physics/bullet/rotations.h"
#include "engine/physics/collision/pair_points.h"
#include "engine/physics/collision/shape/hull_geometry.h"
#include "engine/physics/collision/shape/mesh_geometry.h"
#include "engine/physics/dynamics/joint/joint_geometry.h"
#include "engine/physics/dynamics/rotation.h"
#include "engine/physics/query.h"
#include "engine/physics/world/world_state.h"

#include <algorithm>

namespace plumbline::physics {
namespace {

ShapeDef shape_of(const ConvexShape& shape) {
    using Kind = ConvexShape::Kind;
    const Real height_m = shape.half_height_m * 2;
    switch (shape.kind) {
        case Kind::Sphere:
            return SphereShape{.radius_m = shape.radius_m};
        case Kind::Capsule:
            return CapsuleShape{.radius_m = shape.radius_m, .height_m = height_m};
        case Kind::Cylinder:
            return CylinderShape{.radius_m = shape.radius_m, .height_m = height_m};
        case Kind::Cone:
            return ConeShape{.radius_m = shape.radius_m, .height_m = height_m};
        case Kind::Hull: {
            HullShape hull;
            for (const Vec3d& corner_m : shape.hull->corners_m)
                hull.points_m.emplace_back(corner_m);
            return hull;
        }
        case Kind::Box:
        case Kind::None:
            break;
    }
    return BoxShape{.size_m = shape.half_m * 2.0_r};
}

std::vector<CompoundChild> parts_of(const BodyGeometry& geometry) {
    std::vector<CompoundChild> parts;
    parts.reserve(geometry.parts.size() + 1);
    for (const GeometryPart& part : geometry.parts) {
        CompoundChild& child = parts.emplace_back();
        child.shape = shape_of(part.shape);
        child.body_from_child = pose_of(part.mass_from_part);
    }
    if (geometry.mesh == nullptr) return parts;
    MeshShape mesh{.vertices_m = geometry.mesh->corners_m};
    for (const MeshTriangle& triangle : geometry.mesh->triangles)
        mesh.triangles.push_back(triangle.corners);
    parts.emplace_back().shape = std::move(mesh);
    return parts;
}

std::vector<PartTraits> traits_of(const BodyGeometry& geometry) {
    std::vector<PartTraits> traits;
    for (const GeometryPart& part : geometry.parts) {
        if (part.own) traits.push_back(*part.own);
    }
    return traits;
}

BodyCopy copy_of(const BodyRecord& record) {
    const BodyTraits& traits = record.traits;
    return {.id = record.id,
            .kind = record.frozen ? BodyKind::Static : record.kind,
            .parts = parts_of(*traits.geometry),
            .world_from_mass = pose_of(record.motion->at),
            .mass_kg = traits.mass_kg,
            .inertia_kgm2 = traits.inertia_kgm2,
            .friction = traits.material.friction,
            .restitution = traits.material.restitution,
            .rolling_friction_m = traits.material.rolling_m,
            .spinning_friction_m = traits.material.spinning_m,
            .linear_damping_per_s = traits.linear_damping_per_s,
            .angular_damping_per_s = traits.angular_damping_per_s,
            .linear_factor = traits.linear_factor,
            .gravity_factor = traits.gravity_factor,
            .friction_rule = traits.material.friction_rule,
            .restitution_rule = traits.material.restitution_rule,
            .can_sleep = record.can_sleep,
            .is_belt = traits.is_belt(),
            .always_ccd = record.sweep.ccd == ContinuousCollision::On,
            .filter = record.filter,
            .part_traits = traits_of(*traits.geometry)};
}

double depth_m(BodyRecord& a, BodyRecord& b) {
    Pair pair{.a = &a, .b = &b};
    find_points(pair, CollideStep{});
    double deepest_m = 0;
    for (const Manifold& manifold : pair.manifolds) {
        for (const ManifoldPoint& point : manifold.points)
            deepest_m = std::max(deepest_m, -static_cast<double>(point.distance_m));
    }
    return deepest_m;
}

MassPose mass_pose(const BodyRecord* record) {
    if (record == nullptr) return {};
    const Transform& at = record->motion->at;
    return {.position_m = Vec3d{at.position_m}, .orientation = double_quat_of(at.rotation)};
}

}  // namespace

WorldCopy copy_of(const PhysicsWorld& world) {
    WorldCopy copy;
    internals(world).bodies.each([&](BodyId, const std::unique_ptr<BodyRecord>& record) {
        if (record->in_world) copy.bodies.push_back(copy_of(*record));
    });
    internals(world).joints.each([&](JointId, const std::unique_ptr<JointRecord>& record) {
        if (!record->state.broken) copy.joints.push_back(record->def);
    });
    return copy;
}

PoseFaults pose_faults(PhysicsWorld& world) {
    const WorldState& state = internals(world);
    PoseFaults faults;
    state.bodies.each([&](BodyId id, const std::unique_ptr<BodyRecord>& record) {
        if (!record->in_world || record->kind == BodyKind::Static) return;
        Vec3 low_world{};
        Vec3 high_world{};
        bounds(world, id, low_world, high_world);
        for (const BodyId near :
             bodies_in_box(world,
                           low_world,
                           high_world,
                           {.collides_with = record->filter.collides_with, .ignored = id})) {
            BodyRecord& other = state.body(near);
            const bool seen_from_both = other.kind != BodyKind::Static && near < id;
            if (seen_from_both || !may_touch(record->filter, other.filter)) continue;
            BodyRecord& first = id < near ? *record : other;
            BodyRecord& second = id < near ? other : *record;
            faults.penetration_m = std::max(faults.penetration_m, depth_m(first, second));
        }
    });
    state.joints.each([&](JointId, const std::unique_ptr<JointRecord>& record) {
        if (record->state.broken) return;
        const JointFit fit =
            joint_error(record->solver, mass_pose(record->a), mass_pose(record->b));
        record->solver.position = fit.position;
        record->state.error_m = fit.error_m;
        record->state.position = static_cast<Real>(fit.position);
        faults.joint_error_m = std::max(faults.joint_error_m, fit.error_m);
    });
    return faults;
}

}  // namespace plumbline::physics
