// Colliders of glTF files as shapes of bodies.
#include "engine/scene/build/shape_factory.h"
#include "engine/scene/gltf_scene/gltf_scene_impl.h"

#include <cmath>

namespace plumbline::scene {
namespace {

constexpr double kEven = 1e-6;  // of a stretch: what is less off an axis is rounding
constexpr int kRoundPoints = 24;
constexpr int kCapRings = 6;
constexpr double kQuarterTurn_rad = 1.57079632679489661923;

/// Radii along the axis of a cylinder whose ends differ, or of a capsule whose caps do, as a hull.
physics::HullShape hull_of_round(const assets::ModelRound& round) {
    physics::HullShape hull;
    const auto add_ring = [&hull](double y_m, double radius_m) {
        if (radius_m < 1e-9) return hull.points_m.emplace_back(Vec3d{0, y_m, 0}), void();
        for (int i = 0; i < kRoundPoints; ++i) {
            const double angle = 4 * kQuarterTurn_rad * i / kRoundPoints;
            hull.points_m.emplace_back(
                Vec3d{radius_m * portable_cos(angle), y_m, radius_m * portable_sin(angle)});
        }
    };
    const double half_m = round.height_m / 2;
    if (!round.is_capsule) {
        add_ring(-half_m, round.radius_bottom_m);
        add_ring(half_m, round.radius_top_m);
        return hull;
    }
    for (int i = 0; i <= kCapRings; ++i) {
        const double angle = kQuarterTurn_rad * i / kCapRings;
        const double across = i == kCapRings ? 0.0 : portable_cos(angle);
        add_ring(-half_m - round.radius_bottom_m * portable_sin(angle),
                 round.radius_bottom_m * across);
        add_ring(half_m + round.radius_top_m * portable_sin(angle), round.radius_top_m * across);
    }
    return hull;
}

physics::ShapeDef shape_of_round(const assets::ModelRound& round) {
    const Real height_m(static_cast<Real>(round.height_m));
    const Real radius_m(static_cast<Real>(round.radius_bottom_m));
    if (round.radius_top_m == round.radius_bottom_m) {
        if (round.is_capsule)
            return physics::CapsuleShape{.radius_m = radius_m, .height_m = height_m};
        return physics::CylinderShape{.radius_m = radius_m, .height_m = height_m};
    }
    if (!round.is_capsule && round.radius_top_m == 0.0)
        return physics::ConeShape{.radius_m = radius_m, .height_m = height_m};
    return hull_of_round(round);
}

/// Triangles before the stretch of their node.
physics::MeshShape mesh_of_triangles(const assets::ModelData& model,
                                     const assets::ModelTriangles& triangles) {
    physics::MeshShape shape;
    for (const assets::ColliderMesh& part : triangles.meshes) {
        const assets::ModelMesh& mesh = model.meshes[part.mesh];
        const auto first = static_cast<std::uint32_t>(shape.vertices_m.size());
        const bool as_it_is = part.collider_from_mesh == Mat4f{1.0F};
        const bool mirrored = glm::determinant(Mat3f{part.collider_from_mesh}) < 0.0F;
        for (const assets::Vertex& vertex : mesh.vertices) {
            const Vec4f at = part.collider_from_mesh * Vec4f{vertex.position_body, 1.0F};
            shape.vertices_m.emplace_back(as_it_is ? vertex.position_body : Vec3f{at});
        }
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            std::array<std::uint32_t, 3> corners{
                first + mesh.indices[i], first + mesh.indices[i + 1], first + mesh.indices[i + 2]};
            if (mirrored) std::swap(corners[1], corners[2]);
            shape.triangles.push_back(corners);
        }
    }
    return shape;
}

physics::ShapeDef unstretched(const GltfScene& gltf,
                              const assets::ModelCollider& collider,
                              bool solid) {
    if (const auto* box = std::get_if<assets::ModelBox>(&collider.shape))
        return physics::BoxShape{.size_m = Vec3(box->size_m)};
    if (const auto* sphere = std::get_if<assets::ModelSphere>(&collider.shape))
        return physics::SphereShape{.radius_m = static_cast<Real>(sphere->radius_m)};
    if (const auto* round = std::get_if<assets::ModelRound>(&collider.shape))
        return shape_of_round(*round);
    const auto& triangles = std::get<assets::ModelTriangles>(collider.shape);
    physics::MeshShape mesh = mesh_of_triangles(gltf.model, triangles);
    if (triangles.convex_hull) return physics::HullShape{.points_m = std::move(mesh.vertices_m)};
    if (!solid) return mesh;
    gltf.warn(collider.node,
              "its mesh has no inside, so it cannot move: the convex hull collides in its place");
    return physics::HullShape{.points_m = std::move(mesh.vertices_m)};
}

/// The scale along the axes that a stretch is; nothing where it shears.
std::optional<Vec3d> scale_of(const glm::dmat3& stretch) {
    Vec3d scale{0, 0, 0};
    double off = 0.0;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            if (i == j) scale[i] = std::abs(stretch[i][j]);
            if (i != j) off = std::max(off, std::abs(stretch[i][j]));
        }
    }
    if (off > kEven * std::max({scale.x, scale.y, scale.z})) return {};
    return scale;
}

physics::ShapeDef stretched_shape(const physics::ShapeDef& shape, const glm::dmat3& stretch) {
    if (stretch == glm::dmat3{1.0}) return shape;
    // A mirrored mesh is another one; primitives look the same from both sides.
    const bool has_points = std::holds_alternative<physics::MeshShape>(shape) ||
                            std::holds_alternative<physics::HullShape>(shape);
    const auto scale = scale_of(stretch);
    if (scale && !has_points) return scaled(shape, Vec3(*scale));
    const Mat3 linear(stretch);
    if (const auto* mesh = std::get_if<physics::MeshShape>(&shape)) {
        physics::MeshShape moved = *mesh;
        for (Vec3& point : moved.vertices_m) point = linear * point;
        if (glm::determinant(stretch) < 0.0) {
            for (auto& corners : moved.triangles) std::swap(corners[1], corners[2]);
        }
        return moved;
    }
    physics::HullShape hull{.points_m = points_of(shape)};
    for (Vec3& point : hull.points_m) point = linear * point;
    return hull;
}

}  // namespace

physics::CompoundChild shape_of_collider(const GltfScene& gltf,
                                         const assets::ModelCollider& collider,
                                         const assets::NodePlace& body,
                                         bool solid) {
    const assets::NodePlace& own = gltf.places[collider.node];
    physics::CompoundChild child{
        .shape = stretched_shape(unstretched(gltf, collider, solid), own.stretch)};
    if (&own == &body) return child;
    const Quatd back = glm::conjugate(body.turn);
    child.body_from_child = {.position = Vec3(back * (own.position_m - body.position_m)),
                             .orientation = own.turn == body.turn
                                                ? Quat{1, 0, 0, 0}
                                                : Quat(glm::normalize(back * own.turn))};
    return child;
}

}  // namespace plumbline::scene
