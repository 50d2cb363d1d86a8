#include "engine/physics/collision/narrow_phase/placed_convex.h"

#include "engine/core/random.h"
#include "engine/physics/collision/body_geometry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plumbline::physics {
namespace {

using Kind = ConvexShape::Kind;

Vec3d random_direction(Random& random) {
    const auto number = [&random] { return static_cast<double>(random.uniform(-1.0F, 1.0F)); };
    return {number(), number(), number()};
}

/// Places on the surface of a cylinder or a cone.
std::vector<Vec3d> places_on(const ConvexShape& shape) {
    std::vector<Vec3d> places;
    const auto radius = static_cast<double>(shape.radius_m);
    const auto half = static_cast<double>(shape.half_height_m);
    for (int i = 0; i < 720; ++i) {
        const double angle = 2 * std::numbers::pi * i / 720;
        const Vec3d out{radius * std::cos(angle), 0, radius * std::sin(angle)};
        places.push_back(out - Vec3d{0, half, 0});
        places.push_back(shape.kind == Kind::Cone ? Vec3d{0, half, 0} : out + Vec3d{0, half, 0});
    }
    return places;
}

TEST(PlacedConvex, SupportsAreTheFarthestOfAllPlaces) {
    Random random(1);
    const Transform at{.position_m = {1, -2, 3}};
    for (const Kind kind : {Kind::Cylinder, Kind::Cone}) {
        const ConvexShape shape{.kind = kind, .radius_m = 0.3_r, .half_height_m = 0.5_r};
        const PlacedConvex convex = placed_convex({shape, at}, Vec3d{at.position_m});
        const std::vector<Vec3d> places = places_on(shape);
        for (int i = 0; i < 100; ++i) {
            const Vec3d direction = glm::normalize(random_direction(random));
            double most = -1e9;
            for (const Vec3d& place : places) most = std::max(most, glm::dot(place, direction));
            const double own = glm::dot(support(convex, direction), direction);
            EXPECT_GE(own, most - 1e-6);
            EXPECT_NEAR(own, most, 2e-5) << "the places are half a degree apart";
        }
    }
}

TEST(PlacedConvex, FeaturesLookAlongTheDirection) {
    const ConvexShape cylinder{.kind = Kind::Cylinder, .radius_m = 0.3_r, .half_height_m = 0.5_r};
    const PlacedConvex convex = placed_convex({cylinder, Transform{}}, Vec3d{0, 0, 0});
    Feature feature;
    find_feature(convex, {0, -1, 0}, feature);
    EXPECT_EQ(feature.kind, Feature::Kind::Disc);
    EXPECT_NEAR(feature.center_m.y, -0.5, 1e-6);
    find_feature(convex, {1, 0, 0}, feature);
    ASSERT_EQ(feature.kind, Feature::Kind::Segment);
    for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(feature.corners[i].x, 0.3, 1e-6);
    EXPECT_TRUE(face_along(convex, {0, 1, 0}).exists);
    EXPECT_FALSE(face_along(convex, {1, 0, 0}).exists) << "its side is not flat";
}

TEST(BodyGeometry, BoundsHoldTheShapeAndAreTight) {
    const Real half_root = 0.70710678118654752_r;
    const Transform turned{
        .rotation = Mat3{half_root, half_root, 0, -half_root, half_root, 0, 0, 0, 1},
        .position_m = {2, 0, 0}};
    const ConvexShape cube{.kind = Kind::Box, .half_m = {0.5_r, 0.5_r, 0.5_r}};
    const Bounds bounds = bounds_of(cube, turned);
    EXPECT_NEAR(bounds.high.x - bounds.low.x, std::sqrt(2.0), 1e-6);
    EXPECT_NEAR(bounds.high.z - bounds.low.z, 1, 1e-6);
    EXPECT_NEAR((bounds.low.x + bounds.high.x) / 2, 2, 1e-6);
    const Bounds round = moved(Bounds{{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}}, turned);
    EXPECT_NEAR(round.high.x, bounds.high.x, 1e-6);
}

}  // namespace
}  // namespace plumbline::physics
