// Convex pieces: what is refused, and how they stand.
#include "engine/core/limits.h"
#include "tests/engine/physics/bullet/shape/shape_rig.h"

#include <limits>

namespace plumbline::physics {
namespace {

TEST(ShapeRefusals, SayWhatIsWrong) {
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    EXPECT_EQ(refusal(BoxShape{.size_m = {1, 0, 1}}),
              "shape: box: height is 0 m; it must lie between 0.001 and 10000 m");
    EXPECT_EQ(refusal(SphereShape{.radius_m = nan}),
              "shape: sphere: radius is nan m; it must lie between 0.001 and 10000 m");
    EXPECT_EQ(refusal(CylinderShape{.radius_m = 1, .height_m = -2}),
              "shape: cylinder: height is -2 m; it must lie between 0.001 and 10000 m");
    EXPECT_EQ(refusal(HullShape{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}),
              "shape: hull: 3 points; a hull needs at least 4");
    EXPECT_EQ(refusal(HullShape{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, nan}}}),
              "shape: hull: a point is not finite");
    EXPECT_EQ(refusal(CompoundShape{}), "shape: compound: it has no children");
    EXPECT_EQ(refusal(MeshShape{}), "shape: mesh: it has no triangles");
    MeshShape bad = flat_mesh(1, 1);
    bad.triangles[1][2] = 9;
    EXPECT_EQ(refusal(bad), "shape: mesh: triangle 1 names vertex 9 of 4");
    CompoundShape nested;
    nested.children.push_back({.shape = flat_mesh(1, 1), .body_from_child = {}});
    EXPECT_EQ(refusal(nested), "shape: compound: a mesh may not be part of a compound; use hulls");
}

TEST(ShapeRefusals, LimitsThemselvesAreAllowed) {
    EXPECT_EQ(refusal(SphereShape{.radius_m = static_cast<Real>(limits::kSizeMin_m)}), "");
    EXPECT_EQ(refusal(SphereShape{.radius_m = static_cast<Real>(limits::kSizeMax_m)}), "");
    EXPECT_NE(refusal(SphereShape{.radius_m = static_cast<Real>(limits::kSizeMax_m) * 1.01_r}), "");
    EXPECT_NE(refusal(SphereShape{.radius_m = static_cast<Real>(limits::kSizeMin_m) * 0.99_r}), "");
}

TEST(ShapeContact, ConeStandsOnItsBaseWithoutGap) {
    TestWorld test;
    test.ground();
    const BodyId cone = test.add(ConeShape{.radius_m = 0.5_r, .height_m = 1}, {0, 0.55_r, 0});
    test.run(3.0);
    EXPECT_NEAR(test.at(cone).y, 0.5, 0.01);
}

}  // namespace
}  // namespace plumbline::physics
