// How bodies of every kind lie in a medium, by their ids.
#include "engine/physics/medium.h"

#include "tests/engine/physics/test_world.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::physics {
namespace {

TEST(Medium, RadiiHoldTheBody) {
    TestWorld test;
    const auto radius_of = [&test](const ShapeDef& shape) {
        return radius_m(test.world, test.add(shape, {0, 0, 0}));
    };
    EXPECT_NEAR(radius_of(SphereShape{0.5_r}), 0.5, 1e-6);
    EXPECT_NEAR(radius_of(BoxShape{{2, 1, 2}}), 1.5, 1e-6);
    EXPECT_NEAR(radius_of(CapsuleShape{.radius_m = 0.5_r, .height_m = 2}), 1.5, 1e-6);
    EXPECT_NEAR(radius_of(CylinderShape{.radius_m = 0.6_r, .height_m = 1.6_r}), 1, 1e-6);
    HullShape hull;
    for (int i = 0; i < 8; ++i)
        hull.points_m.emplace_back(
            Real(i & 1 ? 1 : -1), Real(i & 2 ? 0.5 : -0.5), Real(i & 4 ? 1 : -1));
    EXPECT_NEAR(radius_of(hull), 1.5, 1e-4);
}

TEST(Medium, SilhouettesAndExtentsAreOfThePrincipalAxes) {
    TestWorld test;
    const BodyId box = test.add(BoxShape{{0.2_r, 0.4_r, 0.6_r}}, {3, 2, 1});
    EXPECT_NEAR(silhouette_m2(test.world, box, {0, 1, 0}), 0.12, 1e-6);
    const Vec3d half = half_extent_m(test.world, box);
    EXPECT_NEAR(half.x, 0.1, 1e-3);
    EXPECT_NEAR(half.y, 0.2, 1e-3);
    EXPECT_NEAR(half.z, 0.3, 1e-3);
    EXPECT_NEAR(std::abs(mass_from_body(test.world, box).w), 1, 1e-6);
    const Submersion below = submersion(test.world, box, {{3, 2, 1}, {1, 0, 0, 0}}, 2, {0, 1, 0});
    EXPECT_NEAR(below.volume_m3, 0.024, 1e-6);
    EXPECT_NEAR(below.center_m.x, 3, 1e-6);
}

TEST(Medium, TurnedMassFramesAreTurnedBack) {
    TestWorld test;
    // Two bars across each other at 30 degrees: the principal axes are not the body's.
    CompoundShape cross;
    for (const double angle_deg : {0.0, 30.0}) {
        CompoundChild part{.shape = BoxShape{{2, 0.1_r, 0.1_r}}};
        part.body_from_child.orientation =
            quat_from_euler_deg({0, static_cast<Real>(angle_deg), 0});
        cross.children.push_back(part);
    }
    const BodyId body = test.add(cross, {0, 0, 0});
    const Quatd turn = mass_from_body(test.world, body);
    // Halfway between them the cross is longest: along a principal axis.
    const Vec3d along = turn * Vec3d{std::cos(kPiD / 12), 0, -std::sin(kPiD / 12)};
    EXPECT_NEAR(std::max({std::abs(along.x), std::abs(along.y), std::abs(along.z)}), 1, 1e-3);
}

// Parts of a body and triangles of a mesh, from outside and within.
TEST(Medium, BallsFindTheNearestPlaceOfABody) {
    TestWorld test;
    const auto search = [&](BodyId body, const Vec3d& center_m) {
        return BallSearch(
            test.world, body, {center_m, {1, 0, 0, 0}}, center_m - Vec3d{3}, center_m + Vec3d{3});
    };
    const BodyId box = test.add(BoxShape{{2, 1, 2}}, {0, 5, 0}, {.kind = BodyKind::Static});
    const BallSearch of_box = search(box, {0, 5, 0});
    const auto above = of_box.nearest({0.5, 5.8, 0}, 0.1, 0.5);
    ASSERT_TRUE(above);
    EXPECT_NEAR(above->distance_m, 0.2, 1e-6);
    EXPECT_NEAR(above->normal.y, 1, 1e-6);
    EXPECT_NEAR(above->on_body_m.y, 5.5, 1e-6);
    EXPECT_FALSE(of_box.nearest({0.5, 6.3, 0}, 0.1, 0.5));
    const auto within = of_box.nearest({0.5, 5.4, 0}, 0.1, 0.5);
    ASSERT_TRUE(within);
    EXPECT_NEAR(within->distance_m, -0.2, 1e-5);
    EXPECT_NEAR(within->normal.y, 1, 1e-6);
    const BodyId mesh =
        test.add(MeshShape{.vertices_m = {{-2, 0, -2}, {2, 0, -2}, {2, 0, 2}, {-2, 0, 2}},
                           .triangles = {{0, 2, 1}, {0, 3, 2}}},
                 {0, 1, 0},
                 {.kind = BodyKind::Static});
    const BallSearch of_mesh = search(mesh, {0, 1, 0});
    const auto over = of_mesh.nearest({0.5, 1.3, 0}, 0.1, 0.5);
    ASSERT_TRUE(over);
    EXPECT_NEAR(over->distance_m, 0.2, 1e-6);
    EXPECT_NEAR(over->normal.y, 1, 1e-6);
    const auto under = of_mesh.nearest({0.5, 0.9, 0}, 0.1, 0.5);
    ASSERT_TRUE(under);
    EXPECT_NEAR(under->distance_m, -0.2, 1e-6);
    EXPECT_NEAR(under->normal.y, 1, 1e-6);
    EXPECT_NEAR(friction_of(test.world, box), 0.5, 1e-6);
    EXPECT_NEAR(thinnest_half_m(test.world, box), 0.5, 1e-3);
}

TEST(Medium, BallsMeetThePartsWithinTheirBoxOnly) {
    TestWorld test;
    CompoundShape two;
    for (const Real x : {Real{-3}, Real{3}})
        two.children.push_back(
            {.shape = BoxShape{{1, 1, 1}}, .body_from_child = {.position = {x, 0, 0}}});
    const BodyId body = test.add(two, {0, 5, 0}, {.kind = BodyKind::Static});
    const auto search = [&](const Vec3d& low_m, const Vec3d& high_m) {
        return BallSearch(test.world, body, {{0, 5, 0}, {1, 0, 0, 0}}, low_m, high_m);
    };
    const BallSearch left = search({-4, 4, -1}, {-2, 7, 1});
    EXPECT_TRUE(left.nearest({-3, 5.8, 0}, 0.1, 0.5));
    EXPECT_FALSE(left.nearest({3, 5.8, 0}, 0.1, 0.5));
    EXPECT_FALSE(left.finds_nothing());
    EXPECT_TRUE(search({-1, 4, -1}, {1, 6, 1}).finds_nothing());
}

TEST(Medium, SurfacesOfBeltsMoveAlongAndAboutTheCentreOfMass) {
    TestWorld test;
    const BodyId belt = test.add(BoxShape{{1, 1, 1}},
                                 {0, 2, 0},
                                 {.kind = BodyKind::Static,
                                  .surface_velocity_mps = {1, 0, 0},
                                  .surface_spin_radps = {0, 3, 0}});
    EXPECT_EQ(surface_motion(test.world, belt).velocity_mps, (Vec3{1, 0, 0}));
    EXPECT_EQ(surface_motion(test.world, belt).spin_radps, (Vec3{0, 3, 0}));
    test.world.set_features({.belts = false});
    EXPECT_EQ(surface_motion(test.world, belt).spin_radps, (Vec3{0, 0, 0}));
}

}  // namespace
}  // namespace plumbline::physics
