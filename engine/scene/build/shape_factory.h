// Collision shapes from descriptions: scaled, fitted to models, and made once however many bodies
// share them.
#pragma once

#include "engine/assets/mesh_data.h"
#include "engine/core/result.h"
#include "engine/physics/physics_world.h"
#include "engine/scene/scene_description.h"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace plumbline::scene {

/// A shape and what bodies need to know of it.
struct BuiltShape {
    physics::ShapeId id{};
    Real volume_m3{0};       ///< 0 where the shape encloses none
    Real inner_radius_m{0};  ///< of a ball that fits inside; an estimate from below for hulls
    bool convex{true};
};

/// The same shape in stretched space. Round shapes that stretch unevenly become hulls.
physics::ShapeDef scaled(const physics::ShapeDef& shape, const Vec3& scale);
Real volume_of(const physics::ShapeDef& shape);
Real inner_radius_of(const physics::ShapeDef& shape);
/// Corners of the shape's box, in the body frame.
void bounds_of(const physics::ShapeDef& shape, Vec3& min_body, Vec3& max_body);
/// Corners, or points all over the surface of round shapes.
std::vector<Vec3> points_of(const physics::ShapeDef& shape);
/// Volume of the convex hull of the points; 0 for fewer than 4 and for flat sets.
Real hull_volume_m3(const std::vector<Vec3>& points_m);
/// Its faces, counter-clockwise from outside, by number of the points; none of flat sets.
std::vector<std::array<std::uint32_t, 3>> hull_triangles(const std::vector<Vec3>& points_m);

inline physics::ShapeDef shape_of_primitive(const Primitive& primitive) {
    return std::visit([](const auto& shape) { return physics::ShapeDef{shape}; }, primitive);
}
physics::ShapeDef hull_of(const assets::MeshData& mesh);
physics::ShapeDef mesh_of(const assets::MeshData& mesh);

class ShapeFactory {
public:
    explicit ShapeFactory(physics::PhysicsWorld& physics) : physics_(physics) {}

    /// Shapes with the same content are one. Warnings of the physics go to `notes`.
    Result<BuiltShape> make(const physics::ShapeDef& shape, std::vector<std::string>& notes);
    /// A model's hull or triangles; `mesh_id` names the model so that it is read only once.
    Result<BuiltShape> make_from_model(const assets::MeshData& mesh,
                                       std::uint32_t mesh_id,
                                       bool as_hull,
                                       const Vec3& scale,
                                       std::vector<std::string>& notes);

    std::size_t shape_count() const { return shapes_.size(); }

private:
    physics::PhysicsWorld& physics_;
    std::map<std::uint64_t, BuiltShape> shapes_;  ///< by content
};

}  // namespace plumbline::scene
