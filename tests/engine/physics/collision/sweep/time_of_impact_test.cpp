#include "engine/physics/collision/sweep/time_of_impact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace plumbline::physics {
namespace {

constexpr double kRigid = std::numeric_limits<double>::infinity();

BodyGeometry of(const ConvexShape& shape) {
    GeometryPart part{.shape = shape};
    part.bounds = bounds_of(shape, Transform{});
    return {.parts = {part}, .mesh = nullptr};
}

BodyGeometry box(Real x, Real y, Real z) {
    return of({.kind = ConvexShape::Kind::Box, .half_m = {x / 2, y / 2, z / 2}});
}

BodyPath path(const Vec3& from, const Vec3d& displacement_m, const Vec3d& turn_rad = {0, 0, 0}) {
    return {.from = {.position_m = from}, .displacement_m = displacement_m, .turn_rad = turn_rad};
}

TEST(TimeOfImpact, OfBallsIsWhereTheirSurfacesMeet) {
    const BodyGeometry ball = of({.kind = ConvexShape::Kind::Sphere, .radius_m = 0.1_r});
    const BodyPath left = path({-5, 0, 0}, {5, 0, 0});
    const BodyPath right = path({5, 0, 0}, {-5, 0, 0});
    // 10 m apart, closing by 10: 9.8 of it until they touch.
    const auto impact = time_of_impact({ball, left, 0.05}, {ball, right, 0.05}, Known::Nothing, 1);
    ASSERT_TRUE(impact);
    EXPECT_NEAR(impact->share, 0.98, 1e-3);
    EXPECT_NEAR(impact->normal.x, -1, 1e-6) << "from b to a";
    const auto other = time_of_impact({ball, right, 0.05}, {ball, left, 0.05}, Known::Nothing, 1);
    ASSERT_TRUE(other);
    EXPECT_NEAR(other->share, impact->share, 1e-9);
    EXPECT_NEAR(other->normal.x, 1, 1e-6);
}

TEST(TimeOfImpact, IsNoneWhereBodiesPass) {
    const BodyGeometry ball = of({.kind = ConvexShape::Kind::Sphere, .radius_m = 0.1_r});
    const BodyPath still = path({0, 0, 0}, {0, 0, 0});
    const BodyPath by = path({-1, 0.21_r, 0}, {2, 0, 0});
    EXPECT_FALSE(time_of_impact({ball, by, 0.05}, {ball, still, 0.05}, Known::Nothing, 1));
    EXPECT_FALSE(time_of_impact({ball, still, 0.05}, {ball, still, 0.05}, Known::Nothing, 1))
        << "contacts part what is at one place";
}

TEST(TimeOfImpact, OfWhatIsApartIsAlsoWhereTheyGraze) {
    const BodyGeometry ball = of({.kind = ConvexShape::Kind::Sphere, .radius_m = 0.1_r});
    const BodyPath still = path({0, 0, 0}, {0, 0, 0});
    // Overlaps by 2 mm on the way: 4 % of what counts as crossing.
    const BodyPath grazing = path({-1, 0.198_r, 0}, {2, 0, 0});
    EXPECT_FALSE(time_of_impact({ball, grazing, 0.05}, {ball, still, 0.05}, Known::Nothing, 1));
    const auto impact = time_of_impact({ball, grazing, 0.05}, {ball, still, 0.05}, Known::Apart, 1);
    ASSERT_TRUE(impact);
    const double before_m = std::sqrt(0.2 * 0.2 - 0.198 * 0.198);
    EXPECT_NEAR(impact->share, (1 - before_m) / 2, 5e-3);
    const BodyPath by = path({-1, 0.2005_r, 0}, {2, 0, 0});
    EXPECT_FALSE(time_of_impact({ball, by, 0.05}, {ball, still, 0.05}, Known::Apart, 1));
}

TEST(TimeOfImpact, OfARodIsWhereItsTipMeetsThePost) {
    const BodyGeometry rod = box(4, 0.04_r, 0.04_r);
    const BodyGeometry post = box(0.1_r, 4, 0.1_r);
    // It turns by 0.8 rad about y, towards -z on the side of +x.
    const BodyPath turning = path({0, 0, 0}, {0, 0, 0}, {0, 0.8, 0});
    const BodyPath still = path({1.5_r, 0, -0.8_r}, {0, 0, 0});
    const auto impact =
        time_of_impact({rod, turning, 0.01}, {post, still, 0.025}, Known::Nothing, 1);
    ASSERT_TRUE(impact);
    // The corner of the post that the rod meets, and the rod's side 2 cm beside its axis.
    const double away = std::hypot(1.55, 0.75);
    const double angle = std::atan2(0.75, 1.55) - std::asin(0.02 / away);
    EXPECT_NEAR(impact->share, angle / 0.8, 2e-3);
}

TEST(TimeOfImpact, OfWhatSlidesAndRestsIsNone) {
    const BodyGeometry plate = box(0.2_r, 0.02_r, 0.2_r);
    const BodyGeometry floor = box(20, 1, 20);
    const BodyPath still = path({0, -0.5_r, 0}, {0, 0, 0});
    const BodyPath sliding = path({0, 0.0099_r, 0}, {3, 0, 0});
    EXPECT_FALSE(time_of_impact({plate, sliding, 0.005}, {floor, still, kRigid}, Known::Held, 1));
    const BodyPath falling = path({0, 0.0099_r, 0}, {0, -1, 0});
    const auto impact =
        time_of_impact({plate, falling, 0.005}, {floor, still, kRigid}, Known::Held, 1);
    ASSERT_TRUE(impact) << "it would go through";
    EXPECT_LT(impact->share, 0.002);
}

TEST(TimeOfImpact, AWheelThatTurnsOnTheSpotMeetsNothing) {
    const BodyGeometry wheel =
        of({.kind = ConvexShape::Kind::Cylinder, .radius_m = 0.3_r, .half_height_m = 0.1_r});
    const BodyGeometry wall = box(1, 4, 4);
    const BodyPath still = path({0.801_r, 0, 0}, {0, 0, 0});
    EXPECT_FALSE(time_of_impact({wheel, path({0, 0, 0}, {0, 0, 0}, {0, 2, 0}), 0.05},
                                {wall, still, 0.25},
                                Known::Nothing,
                                1));
}

TEST(TimeOfImpact, StopsAtWhatWasStoppedBefore) {
    const BodyGeometry ball = of({.kind = ConvexShape::Kind::Sphere, .radius_m = 0.1_r});
    BodyPath fleeing = path({1, 0, 0}, {10, 0, 0});
    const BodyPath chasing = path({0, 0, 0}, {10, 0, 0});
    EXPECT_FALSE(time_of_impact({ball, chasing, 0.05}, {ball, fleeing, 0.05}, Known::Nothing, 1));
    fleeing.until = 0.1;  // at x = 2
    const auto impact =
        time_of_impact({ball, chasing, 0.05}, {ball, fleeing, 0.05}, Known::Nothing, 1);
    ASSERT_TRUE(impact);
    EXPECT_NEAR(impact->share, 0.18, 1e-3);
}

TEST(TimeOfImpact, SweptBoundsHoldTheWholePath) {
    const BodyGeometry rod = box(4, 0.04_r, 0.04_r);
    const Bounds bounds = swept_bounds(rod, path({0, 0, 0}, {0, 1, 0}, {0, 0, 1.5}));
    EXPECT_GE(bounds.high.x, 2);
    EXPECT_GE(bounds.high.y, 1 + 2 * std::sin(1.5));
    EXPECT_LE(bounds.low.y, -2 * std::sin(1.5) + 1)
        << "the other end goes down while the middle rises";
}

}  // namespace
}  // namespace plumbline::physics
