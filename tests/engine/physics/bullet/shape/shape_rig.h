// Shapes weighed, and refused.
#pragma once

#include "tests/engine/physics/test_world.h"

#include <string>
#include <vector>

namespace plumbline::physics {

inline MassProperties weigh(TestWorld& test, const ShapeDef& def, Real mass_kg) {
    const BodyId body = test.add(def, {0, 0, 0}, {.kind = BodyKind::Dynamic, .mass_kg = mass_kg});
    const MassProperties mass = test.world.state(body).mass;
    test.world.destroy_body(body);
    return mass;
}

inline void expect_near(const Vec3& got, const Vec3d& want, double tolerance) {
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(static_cast<double>(got[axis]), want[axis], tolerance) << "axis " << axis;
    }
}

inline std::vector<Vec3> corners_of_box(const Vec3& low, const Vec3& high) {
    std::vector<Vec3> corners;
    for (int i = 0; i < 8; ++i) {
        corners.push_back({(i & 1) != 0 ? high.x : low.x,
                           (i & 2) != 0 ? high.y : low.y,
                           (i & 4) != 0 ? high.z : low.z});
    }
    return corners;
}

/// Empty where it is not refused.
inline std::string refusal(const ShapeDef& def) {
    TestWorld test;
    const auto made = test.world.create_shape(def);
    return made.ok() ? "" : made.error().message;
}

}  // namespace plumbline::physics
