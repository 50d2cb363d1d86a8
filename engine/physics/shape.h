// What a body looks like to collisions. Sizes are full lengths in metres; the shape's own +Y is
// the axis of cylinder, capsule and cone.
#pragma once

#include "engine/core/id.h"
#include "engine/core/pose.h"

#include <array>
#include <cstdint>
#include <memory>
#include <variant>
#include <vector>

namespace plumbline::physics {

struct ShapeTag;
using ShapeId = Id<ShapeTag>;

struct BoxShape {
    Vec3 size_m{1, 1, 1};  ///< full edge lengths
};
struct SphereShape {
    Real radius_m{0.5_r};
};
struct CylinderShape {
    Real radius_m{0.5_r};
    Real height_m{1};
};
struct CapsuleShape {
    Real radius_m{0.5_r};
    Real height_m{1};  ///< between the centres of the two caps
};
struct ConeShape {
    Real radius_m{0.5_r};
    Real height_m{1};  ///< origin half-way up
};
/// A level rectangle, top at y = 0, solid below to a depth of thickness_m. Static bodies only.
struct PlaneShape {
    Vec2 size_m{100, 100};
    Real thickness_m{1};
};
/// The convex hull of at least 4 points; flat and thin ones become thin boxes, with a warning.
struct HullShape {
    std::vector<Vec3> points_m;
};
/// Triangles, counter-clockwise from outside. Static and kinematic bodies only.
struct MeshShape {
    std::vector<Vec3> vertices_m;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};
struct CompoundChild;
struct CompoundShape {
    std::vector<CompoundChild> children;
};

using ShapeDef = std::variant<BoxShape,
                              SphereShape,
                              CylinderShape,
                              CapsuleShape,
                              ConeShape,
                              PlaneShape,
                              HullShape,
                              MeshShape,
                              CompoundShape>;

struct CompoundChild {
    ShapeDef shape;
    Pose body_from_child{};
};

}  // namespace plumbline::physics
