#include "engine/physics/medium.h"

#include "engine/physics/collision/mesh/placed_mesh.h"
#include "engine/physics/collision/mesh/triangle_distance.h"
#include "engine/physics/collision/narrow_phase/collide.h"
#include "engine/physics/collision/shape/hull_geometry.h"
#include "engine/physics/collision/silhouette.h"
#include "engine/physics/collision/submersion.h"
#include "engine/physics/physics_world.h"
#include "engine/physics/world/world_state.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumbline::physics {
namespace {

/// Of the farthest point from the shape's origin.
double reach_m(const ConvexShape& shape) {
    const auto r = static_cast<double>(shape.radius_m);
    const auto half = static_cast<double>(shape.half_height_m);
    switch (shape.kind) {
        case ConvexShape::Kind::None:
            return 0;
        case ConvexShape::Kind::Sphere:
            return r;
        case ConvexShape::Kind::Capsule:
            return half + r;
        case ConvexShape::Kind::Box:
            return glm::length(Vec3d(shape.half_m));
        case ConvexShape::Kind::Cylinder:
        case ConvexShape::Kind::Cone:
            return std::sqrt(r * r + half * half);
        case ConvexShape::Kind::Hull: {
            double most = 0;
            for (const Vec3d& corner : shape.hull->corners_m)
                most = std::max(most, glm::length(corner));
            return most;
        }
    }
    return 0;
}

/// The triangle that is nearest decides; where the ball's centre is behind its front, by how much.
std::optional<BallContact> near_mesh(
    const MeshGeometry& mesh, const Transform& at, const Vec3d& ball, double radius, double reach) {
    const PlacedMesh placed(mesh, at, ball);
    std::optional<BallContact> nearest;
    double nearest_m = radius + reach;
    placed.visit_round({0, 0, 0}, nearest_m, [&](std::uint32_t index) {
        const std::array<Vec3d, 3> corners = placed.corners_m(index);
        const Vec3d front =
            glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
        const Vec3d on_mesh = nearest_to({0, 0, 0}, corners, front).at;
        const double away_m = glm::length(on_mesh);
        if (away_m >= nearest_m) return;
        nearest_m = away_m;
        const bool is_behind =
            glm::dot(on_mesh, front) > 0 && !mesh.triangles[index].has_two_fronts;
        const Vec3d outward = is_behind ? on_mesh : -on_mesh;
        nearest = BallContact{.normal = normalize_or(outward, front),
                              .on_body_m = on_mesh + ball,
                              .distance_m = (is_behind ? -away_m : away_m) - radius};
    });
    return nearest;
}

}  // namespace

BallSearch::BallSearch(const PhysicsWorld& world,
                       BodyId id,
                       const MassFrame& at,
                       const Vec3d& low_m,
                       const Vec3d& high_m)
    : geometry_(*internals(world).body(id).traits.geometry),
      at_(at),
      rotation_(glm::mat3_cast(at.world_from_mass)) {
    const Transform body{.rotation = rotation_};
    const Bounds local = moved({low_m - at.center_m, high_m - at.center_m}, inverse(body));
    for (std::uint32_t i = 0; i < geometry_.parts.size(); ++i) {
        if (overlap(local, geometry_.parts[i].bounds)) parts_.push_back(i);
    }
}

bool BallSearch::has_mesh() const {
    return geometry_.mesh != nullptr;
}

std::optional<BallContact> BallSearch::nearest_part(const Transform& body,
                                                    const Vec3d& local,
                                                    double radius_m,
                                                    double reach_m) const {
    const ConvexShape ball{.kind = ConvexShape::Kind::Sphere,
                           .radius_m = static_cast<Real>(radius_m)};
    const double far_m = radius_m + reach_m;
    std::optional<BallContact> nearest;
    for (const std::uint32_t number : parts_) {
        const GeometryPart& part = geometry_.parts[number];
        if (glm::any(glm::lessThan(local, part.bounds.low - far_m)) ||
            glm::any(glm::greaterThan(local, part.bounds.high + far_m)))
            continue;
        const Transform at = body * part.mass_from_part;
        const ConvexContact contact =
            collide({ball, Transform{}}, {part.shape, at}, static_cast<Real>(reach_m));
        for (const ConvexPoint& point : contact.points()) {
            const auto distance_m = static_cast<double>(point.distance_m);
            if (nearest && nearest->distance_m <= distance_m) continue;
            nearest = BallContact{.normal = Vec3d(point.normal),
                                  .on_body_m = Vec3d(point.on_b),
                                  .distance_m = distance_m};
        }
    }
    return nearest;
}

std::optional<BallContact> BallSearch::nearest(const Vec3d& ball_m,
                                               double radius_m,
                                               double reach_m) const {
    if (has_mesh())
        return near_mesh(*geometry_.mesh,
                         {.rotation = rotation_, .position_m = Vec3(at_.center_m)},
                         ball_m,
                         radius_m,
                         reach_m);
    // Near the origin, where single precision has its digits.
    const Transform body{.rotation = rotation_, .position_m = Vec3(at_.center_m - ball_m)};
    const Vec3d local = glm::conjugate(at_.world_from_mass) * (ball_m - at_.center_m);
    std::optional<BallContact> nearest = nearest_part(body, local, radius_m, reach_m);
    if (nearest) nearest->on_body_m += ball_m;
    return nearest;
}

double friction_of(const PhysicsWorld& world, BodyId id) {
    return static_cast<double>(internals(world).body(id).traits.material.friction);
}

SurfaceMotion surface_motion(const PhysicsWorld& world, BodyId id) {
    return internals(world).features.belts ? surface_motion(internals(world).body(id))
                                           : SurfaceMotion{};
}

double silhouette_m2(const PhysicsWorld& world, BodyId id, const Vec3d& direction_mass) {
    return silhouette_m2(*internals(world).body(id).traits.geometry, direction_mass);
}

Submersion submersion(const PhysicsWorld& world,
                      BodyId id,
                      const MassFrame& at,
                      double level_m,
                      const Vec3d& direction) {
    return submersion(*internals(world).body(id).traits.geometry,
                      at.center_m,
                      at.world_from_mass,
                      level_m,
                      direction);
}

Quatd mass_from_body(const PhysicsWorld& world, BodyId id) {
    return glm::conjugate(Quatd(internals(world).body(id).traits.body_from_mass.orientation));
}

Quatd world_from_mass(const PhysicsWorld& world, BodyId id) {
    return Quatd(world.state(id).world_from_body.orientation) *
           glm::conjugate(mass_from_body(world, id));
}

std::size_t part_count(const PhysicsWorld& world, BodyId id) {
    return internals(world).body(id).traits.geometry->parts.size();
}

double radius_m(const PhysicsWorld& world, BodyId id) {
    double radius = 0;
    for (const GeometryPart& part : internals(world).body(id).traits.geometry->parts) {
        const double away = glm::length(Vec3d(part.mass_from_part.position_m));
        radius = std::max(radius, away + reach_m(part.shape));
    }
    return radius;
}

double thinnest_half_m(const PhysicsWorld& world, BodyId id) {
    double thinnest = std::numeric_limits<double>::infinity();
    for (const GeometryPart& part : internals(world).body(id).traits.geometry->parts) {
        const Vec3d half = (part.bounds.high - part.bounds.low) / 2.0;
        thinnest = std::min({thinnest, half.x, half.y, half.z});
    }
    return thinnest;
}

Vec3d half_extent_m(const PhysicsWorld& world, BodyId id) {
    Vec3d half{0, 0, 0};
    for (const GeometryPart& part : internals(world).body(id).traits.geometry->parts)
        half = glm::max(half, glm::max(glm::abs(part.bounds.low), glm::abs(part.bounds.high)));
    return half;
}

}  // namespace plumbline::physics
