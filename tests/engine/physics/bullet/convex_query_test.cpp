#include "engine/physics/query.h"
#include "tests/engine/physics/test_world.h"

#include <cmath>

namespace plumbline::physics {
namespace {

/// What casts may be short by; a character's skin is a hundred times thicker.
constexpr double kTight_m = 1e-4;

TEST(Sweeps, StopWhereShapesTouch) {
    TestWorld test;
    test.ground();
    const BodyId wall =
        test.add(BoxShape{.size_m = {1, 4, 20}}, {5, 2, 0}, {.kind = BodyKind::Static});
    const ShapeId capsule = test.shape(CapsuleShape{.radius_m = 0.3_r, .height_m = 1.2_r});
    const auto hit = sweep(test.world, capsule, {.position = {0, 1, 0}}, {10, 1, 0});
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->body, wall);
    EXPECT_NEAR(static_cast<double>(hit->fraction) * 10.0, 4.5 - 0.3, kTight_m);
    EXPECT_NEAR(static_cast<double>(hit->normal_world.x), -1.0, 1e-4);
    const auto down = sweep(test.world, capsule, {.position = {0, 3, 0}}, {0, 0, 0});
    ASSERT_TRUE(down.has_value());
    EXPECT_NEAR(3.0 * (1 - static_cast<double>(down->fraction)), 0.9, kTight_m);
    EXPECT_NEAR(static_cast<double>(down->normal_world.y), 1.0, 1e-4);
}

TEST(Sweeps, BallOnASlopeTouchesAtTheSlopesNormal) {
    TestWorld test;
    const Quat tilt = glm::angleAxis(radians_from_degrees(30.0_r), Vec3{0, 0, 1});
    const ShapeId slab = test.shape(BoxShape{.size_m = {20, 2, 20}});
    test.world.create_body({.shape = slab, .world_from_body = {.orientation = tilt}});
    const ShapeId ball = test.shape(SphereShape{.radius_m = 0.5_r});
    const auto hit = sweep(test.world, ball, {.position = {0, 5, 0}}, {0, -5, 0});
    ASSERT_TRUE(hit.has_value());
    // The middle ends 1.5 m from the slab's middle plane, measured along the normal.
    const double height = 5 - 10 * static_cast<double>(hit->fraction);
    EXPECT_NEAR(height, 1.5 / std::cos(static_cast<double>(kPi) / 6), 2 * kTight_m);
    EXPECT_NEAR(static_cast<double>(hit->normal_world.x), -0.5, 1e-3);
}

TEST(Sweeps, MeshSeamsDoNotTripAGrazingCapsule) {
    TestWorld test;
    test.add(flat_mesh(20, 1), {0, 0, 0}, {.kind = BodyKind::Static});
    const ShapeId capsule = test.shape(CapsuleShape{.radius_m = 0.3_r, .height_m = 1.2_r});
    const Real above = 0.9_r + 0.01_r;
    EXPECT_FALSE(sweep(test.world, capsule, {.position = {-8, above, 0.3_r}}, {8, above, -2.2_r})
                     .has_value());
    const auto down =
        sweep(test.world, capsule, {.position = {0.5_r, 2, 0.5_r}}, {0.5_r, 0, 0.5_r});
    ASSERT_TRUE(down.has_value());
    EXPECT_NEAR(2.0 - 2.0 * static_cast<double>(down->fraction), 0.9, kTight_m);
}

TEST(Sweeps, OverlapAtTheStartBlocksOnlyTheWayIn) {
    TestWorld test;
    test.add(BoxShape{.size_m = {2, 2, 2}}, {0, 0, 0}, {.kind = BodyKind::Static});
    const ShapeId ball = test.shape(SphereShape{.radius_m = 0.5_r});
    const Pose inside{.position = {0, 1.45_r, 0}};
    const auto deeper = sweep(test.world, ball, inside, {0, 0, 0});
    ASSERT_TRUE(deeper.has_value());
    EXPECT_EQ(deeper->fraction, 0);
    EXPECT_NEAR(static_cast<double>(deeper->normal_world.y), 1.0, 1e-3);
    EXPECT_FALSE(sweep(test.world, ball, inside, {0, 3, 0}).has_value());
}

}  // namespace
}  // namespace plumbline::physics
