// ShapeDef cut into convex pieces.
#pragma once

#include "engine/core/result.h"
#include "engine/physics/collision/shape/convex_shape.h"
#include "engine/physics/collision/shape/hull_geometry.h"
#include "engine/physics/collision/shape/mass.h"
#include "engine/physics/shape.h"

#include <btBulletCollisionCommon.h>

#include <memory>
#include <string>
#include <vector>

namespace plumbline::physics {

/// One convex piece. Its own frame is Bullet's for the shape: the middle of a box, cylinder or
/// cone, the mass frame of a hull.
struct ShapePart {
    std::unique_ptr<btConvexShape> shape;
    Pose body_from_part{};
    ConvexShape convex;  ///< without Bullet's margins; a hull's corners are owned by `hull`
    std::shared_ptr<const HullGeometry> hull;
    Pose part_from_convex{};
    SolidMass mass;          ///< in the part's frame
    Real inner_radius_m{0};  ///< radius of the largest ball round the mass centre that stays inside
};

struct ShapeParts {
    std::vector<ShapePart> parts;
    bool static_only{false};
};

Error refused_shape(std::string why);

/// Everything but meshes. Refuses what ShapeDef's comments forbid; notes say what was changed.
Result<ShapeParts> build_parts(const ShapeDef& def, std::vector<std::string>* notes);

}  // namespace plumbline::physics
