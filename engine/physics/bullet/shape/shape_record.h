// A shape as bodies share it.
#pragma once

#include "engine/core/pose.h"
#include "engine/core/result.h"
#include "engine/physics/shape.h"
#include "engine/physics/world/body_record.h"

#include <btBulletCollisionCommon.h>

#include <memory>
#include <string>
#include <vector>

class btTriangleIndexVertexArray;

namespace plumbline::physics {

/// Triangles as Bullet reads them; it keeps pointers into these.
struct TriangleStore {
    std::vector<btScalar> coordinates;
    std::vector<int> indices;
    std::unique_ptr<btTriangleIndexVertexArray> view;

    TriangleStore();
    ~TriangleStore();
    TriangleStore(const TriangleStore&) = delete;
    TriangleStore& operator=(const TriangleStore&) = delete;
};

/// A shape as bodies share it. "Mass frame": at the centre of mass, along the principal axes, which
/// is where Bullet wants a body's origin.
struct ShapeRecord {
    TriangleStore triangles;  // only meshes use it; must outlive the shapes
    std::vector<std::unique_ptr<btCollisionShape>> parts;
    btCollisionShape* collision{nullptr};  ///< in the mass frame; one of `parts`
    const btConvexShape* convex{nullptr};  ///< what queries move; none for meshes and compounds
    btTransform mass_from_convex{btTransform::getIdentity()};
    Pose body_from_mass{};
    bool mass_frame_is_body{true};
    bool static_only{false};
    bool mesh{false};
    Vec3d inertia_per_kg{0, 0, 0};  ///< principal
    Real inner_radius_m{
        0};  ///< of the largest ball inside its thinnest part; 0: of a mesh or a plane
    std::shared_ptr<const BodyGeometry> geometry;  ///< in the mass frame
};

/// Makes a shape's Bullet side. Refuses what ShapeDef's comments forbid.
Result<std::unique_ptr<ShapeRecord>> build_shape(const ShapeDef& def,
                                                 std::vector<std::string>* notes);

}  // namespace plumbline::physics
