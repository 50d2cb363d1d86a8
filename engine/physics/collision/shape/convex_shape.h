// The convex shapes whose contact points we find, each in a frame of its own.
#pragma once

#include "engine/physics/transform.h"

#include <cstdint>

namespace plumbline::physics {

struct HullGeometry;

/// A convex solid: its centre at the origin, its axis of rotation, if it has one, along +Y.
struct ConvexShape {
    enum class Kind : std::uint8_t { None, Sphere, Capsule, Box, Cylinder, Cone, Hull };

    Kind kind{Kind::None};  ///< None: some other shape
    Vec3 half_m{0, 0, 0};   ///< of a box
    Real radius_m{0};       ///< of all that are round; of a cone, at its base
    Real half_height_m{
        0};  ///< of a capsule up to its caps' centres; a cone's origin is half-way up
    const HullGeometry* hull{nullptr};  ///< of a hull: outlives the shape

    /// Whether some side of it is a sphere wherever it touches (round_side()).
    bool may_be_round() const {
        return kind == Kind::Sphere || kind == Kind::Capsule || kind == Kind::Cylinder;
    }
};

/// A shape and where it is; for the length of a call.
struct PlacedShape {
    const ConvexShape& shape;
    const Transform& world_from_shape;
};

}  // namespace plumbline::physics
