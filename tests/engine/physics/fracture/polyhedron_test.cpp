// Solids of facets against closed forms, whole and cut.
#include "engine/physics/fracture/polyhedron.h"

#include "engine/physics/collision/shape/convex_shape.h"

#include <gtest/gtest.h>

namespace plumbline::physics {
namespace {

using Kind = ConvexShape::Kind;

TEST(Polyhedron, StandsForTheShapeWithNoSmallerMoments) {
    const std::vector<std::pair<ConvexShape, SolidMass>> shapes{
        {{.kind = Kind::Box, .half_m = {1, 2, 3}}, mass_of_box({2, 4, 6})},
        {{.kind = Kind::Sphere, .radius_m = 2}, mass_of_sphere(2)},
        {{.kind = Kind::Capsule, .radius_m = 1, .half_height_m = 2}, mass_of_capsule(1, 4)},
        {{.kind = Kind::Cylinder, .radius_m = 1, .half_height_m = 2}, mass_of_cylinder(1, 4)},
        {{.kind = Kind::Cone, .radius_m = 1, .half_height_m = 2}, mass_of_cone(1, 4)}};
    for (const auto& [shape, asked] : shapes) {
        const SolidMass made = mass_of(polyhedron_of(shape));
        EXPECT_NEAR(made.volume_m3 / asked.volume_m3, 1, 0.04);
        for (int axis = 0; axis < 3; ++axis) {
            const double share = made.inertia[axis][axis] / made.volume_m3 /
                                 (asked.inertia[axis][axis] / asked.volume_m3);
            EXPECT_GE(share, 1 - 1e-9);
            EXPECT_LT(share, 1.03);
        }
    }
    EXPECT_TRUE(polyhedron_of({}).empty());
}

TEST(Polyhedron, IsCutInTwoWithNothingLost) {
    const Polyhedron whole = polyhedron_of({.kind = Kind::Sphere, .radius_m = 1});
    const Vec3d normal = glm::normalize(Vec3d{1, 2, -0.5});
    Polyhedron below = whole;
    Polyhedron above = whole;
    cut(below, normal, 0.3, 7);
    cut(above, -normal, -0.3, 8);
    EXPECT_NEAR(
        mass_of(below).volume_m3 + mass_of(above).volume_m3, mass_of(whole).volume_m3, 1e-12);
    EXPECT_EQ(below.faces.back().beyond, 7);
    EXPECT_EQ(above.faces.back().beyond, 8);
    for (const Vec3d& corner : below.corners_m) EXPECT_LT(glm::dot(normal, corner), 0.3 + 1e-9);
}

TEST(Polyhedron, StaysOrGoesWhereThePlaneMissesIt) {
    const Polyhedron box = polyhedron_of({.kind = Kind::Box, .half_m = {1, 1, 1}});
    for (const double at_m : {1.0, 1.5}) {  // on a face, and outside
        Polyhedron same = box;
        cut(same, {1, 0, 0}, at_m, 0);
        EXPECT_EQ(same.faces.size(), 6U) << at_m;
        Polyhedron gone = box;
        cut(gone, {-1, 0, 0}, -at_m, 0);
        EXPECT_TRUE(gone.empty()) << at_m;
    }
}

// Through two edges: no new corners.
TEST(Polyhedron, IsCutThroughItsOwnCorners) {
    Polyhedron wedge = polyhedron_of({.kind = Kind::Box, .half_m = {1, 1, 1}});
    cut(wedge, glm::normalize(Vec3d{1, 1, 0}), 0, 0);
    EXPECT_EQ(wedge.corners_m.size(), 6U);
    EXPECT_NEAR(mass_of(wedge).volume_m3, 4, 1e-12);
}

}  // namespace
}  // namespace plumbline::physics
