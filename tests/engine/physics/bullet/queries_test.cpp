#include "engine/physics/query.h"
#include "tests/engine/physics/test_world.h"

#include <utility>

namespace plumbline::physics {
namespace {

TEST(Rays, HitEveryKindOfShapeWhereItIs) {
    TestWorld test;
    HullShape hull{{{-1, -1, -1},
                    {1, -1, -1},
                    {-1, 1, -1},
                    {1, 1, -1},
                    {-1, -1, 1},
                    {1, -1, 1},
                    {-1, 1, 1},
                    {1, 1, 1}}};
    CompoundShape compound;
    compound.children.push_back(
        {.shape = BoxShape{}, .body_from_child = {.position = {0, 0.5_r, 0}}});
    const std::vector<std::pair<ShapeDef, double>> tops{{BoxShape{}, 0.5},
                                                        {SphereShape{}, 0.5},
                                                        {CylinderShape{}, 0.5},
                                                        {CapsuleShape{}, 1.0},
                                                        {PlaneShape{.size_m = {2, 2}}, 0.0},
                                                        {hull, 1.0},
                                                        {flat_mesh(2, 1), 0.0},
                                                        {compound, 1.0}};
    for (std::size_t i = 0; i < tops.size(); ++i) {
        const Real x = 10 * static_cast<Real>(i);
        const BodyId body =
            test.add(tops[i].first, {x, 0, 0}, {.kind = BodyKind::Static, .user = i});
        const auto hit = cast_ray(test.world, {x + 0.01_r, 5, 0.02_r}, {x + 0.01_r, -5, 0.02_r});
        ASSERT_TRUE(hit.has_value()) << "shape " << i;
        EXPECT_EQ(hit->body, body);
        EXPECT_EQ(hit->user, i);
        // The round ones lie a little lower off their middle.
        EXPECT_NEAR(static_cast<double>(hit->point_world.y), tops[i].second, 1e-3) << "shape " << i;
        EXPECT_NEAR(static_cast<double>(hit->distance_m), 5 - tops[i].second, 1e-3);
        EXPECT_NEAR(static_cast<double>(hit->normal_world.y), 1.0, 2e-3) << "shape " << i;
    }
    EXPECT_FALSE(cast_ray(test.world, {5, 5, 0}, {5, -5, 0}).has_value());
}

TEST(Rays, SeeTheNearestThroughTheirFilter) {
    TestWorld test;
    const BodyId upper =
        test.add(BoxShape{}, {0, 4, 0}, {.kind = BodyKind::Static, .filter = {.group = 2}});
    const BodyId lower =
        test.add(BoxShape{}, {0, 2, 0}, {.kind = BodyKind::Static, .filter = {.group = 1}});
    const Vec3 from{0, 9, 0};
    const Vec3 to{0, 0, 0};
    EXPECT_EQ(cast_ray(test.world, from, to)->body, upper);
    EXPECT_EQ(cast_ray(test.world, from, to, {.collides_with = 1})->body, lower);
    EXPECT_EQ(cast_ray(test.world, from, to, {.ignored = upper})->body, lower);
    EXPECT_FALSE(
        cast_ray(test.world, from, to, {.ignored = upper, .also_ignored = lower}).has_value());
}

TEST(Rays, FindBodiesWhereTheyAreNow) {
    TestWorld test(weightless());
    const BodyId fast =
        test.add(BoxShape{}, {0, 0, 0}, {.kind = BodyKind::Dynamic, .velocity_mps = {300, 0, 0}});
    test.run(1.0);
    const auto moved = cast_ray(test.world, {300, 5, 0}, {300, -5, 0});
    ASSERT_TRUE(moved.has_value());
    EXPECT_EQ(moved->body, fast);
    test.world.set_pose(fast, {.position = {0, 0, 50}});
    EXPECT_FALSE(cast_ray(test.world, {300, 5, 0}, {300, -5, 0}).has_value());
    EXPECT_TRUE(cast_ray(test.world, {0, 5, 50}, {0, -5, 50}).has_value());
}

TEST(Overlaps, GiveTheWayOutDeepestFirst) {
    TestWorld test;
    const BodyId floor =
        test.add(BoxShape{.size_m = {10, 2, 10}}, {0, -1, 0}, {.kind = BodyKind::Static});
    const BodyId wall =
        test.add(BoxShape{.size_m = {2, 10, 10}}, {1.35_r, 5, 0}, {.kind = BodyKind::Static});
    const ShapeId capsule = test.shape(CapsuleShape{.radius_m = 0.3_r, .height_m = 1.2_r});
    // 0.05 m into the wall (whose face is at x = 0.35 - 0.1), 0.02 m above the floor.
    const auto hits = overlaps(test.world, capsule, {.position = {0.1_r, 0.92_r, 0}}, 0.03_r);
    ASSERT_EQ(hits.size(), 2U);
    EXPECT_EQ(hits[0].body, wall);
    EXPECT_NEAR(static_cast<double>(hits[0].depth_m), 0.05, 1e-4);
    EXPECT_NEAR(static_cast<double>(hits[0].normal_world.x), -1.0, 1e-3);
    EXPECT_EQ(hits[1].body, floor);
    EXPECT_NEAR(static_cast<double>(hits[1].depth_m), -0.02, 1e-4);
    EXPECT_NEAR(static_cast<double>(hits[1].normal_world.y), 1.0, 1e-3);
    EXPECT_EQ(overlaps(test.world, capsule, {.position = {0.1_r, 0.92_r, 0}}, 0.01_r).size(), 1U);
    EXPECT_TRUE(overlaps(test.world, capsule, {.position = {-3, 5, 0}}, 0.03_r).empty());
}

}  // namespace
}  // namespace plumbline::physics
