// What a body looks like to collisions: convex parts, or a mesh of triangles. Made once and shared by all bodies
// whose mass frame lies alike in the shape.
#pragma once

#include "engine/physics/body.h"
#include "engine/physics/collision/shape/box_tree.h"
#include "engine/physics/collision/shape/convex_shape.h"

#include <memory>
#include <optional>
#include <vector>

namespace plumbline::physics {

struct MeshGeometry;

/// One convex piece of a body.
struct GeometryPart {
    ConvexShape shape;
    Transform mass_from_part{};
    Bounds bounds{};                             ///< in the body's mass frame
    std::shared_ptr<const HullGeometry> hull{};  ///< owns what `shape` names
    std::optional<PartTraits> own{};             ///< in place of the body's
};

/// Either `parts` or `mesh`. The frame of both is the body's mass frame.
struct BodyGeometry {
    std::vector<GeometryPart> parts;
    std::shared_ptr<const MeshGeometry> mesh;
};

struct PlacedConvex;

/// The box round a shape that stands at `at`.
Bounds bounds_of(const PlacedConvex& convex);
Bounds bounds_of(const ConvexShape& shape, const Transform& at);
/// The box round `bounds`, seen from another frame.
Bounds moved(const Bounds& bounds, const Transform& at);

inline bool overlap(const Bounds& a, const Bounds& b) {
    return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y &&
           b.low.y <= a.high.y && a.low.z <= b.high.z && b.low.z <= a.high.z;
}

/// The same parts in another mass frame. A mesh keeps its frame.
BodyGeometry moved(const BodyGeometry& geometry, const Transform& to_from_mass);

}  // namespace plumbline::physics
