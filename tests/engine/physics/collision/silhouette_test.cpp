// Silhouettes against rasters of rays, and against sums over directions (Cauchy: a convex body's mean silhouette is a quarter
// of its surface).
#include "engine/physics/collision/silhouette.h"

#include "engine/core/random.h"
#include "tests/engine/physics/collision/narrow_phase/convex_rig.h"
#include "tests/engine/physics/test_world.h"

#include <gtest/gtest.h>

namespace plumbline::physics {
namespace {

using convex_rig::Solid;

struct WithSurface {
    Solid solid;
    double surface_m2;
};

std::vector<WithSurface> solids() {
    const double slant = std::hypot(0.5, 1.2);
    std::vector<Vec3d> corners;
    for (int i = 0; i < 8; ++i)
        corners.emplace_back(i & 1 ? 0.3 : -0.3, i & 2 ? 0.5 : -0.5, i & 4 ? 0.2 : -0.2);
    return {{convex_rig::sphere(0.5), kPiD},
            {convex_rig::box({0.3, 0.5, 0.2}), 8 * (0.15 + 0.1 + 0.06)},
            {convex_rig::hull("box hull", corners), 8 * (0.15 + 0.1 + 0.06)},
            {convex_rig::capsule(0.3, 0.4), kPiD * 0.6 * 0.8 + 4 * kPiD * 0.09},
            {convex_rig::cylinder(0.3, 0.4), kPiD * 0.6 * 0.8 + 2 * kPiD * 0.09},
            {convex_rig::cone(0.5, 0.6), kPiD * 0.25 + kPiD * 0.5 * slant}};
}

Vec3d direction_of(Random& random) {
    Vec3d at{0, 0, 0};
    do {
        at = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    } while (glm::length(at) > 1 || glm::length(at) < 0.1);
    return glm::normalize(at);
}

TEST(Silhouette, IsAQuarterOfTheSurfaceOnAverage) {
    for (const WithSurface& of : solids()) {
        Random random(7);
        double sum = 0;
        constexpr int kDirections = 20'000;
        for (int i = 0; i < kDirections; ++i)
            sum += silhouette_m2(of.solid.shape, direction_of(random)) / kDirections;
        EXPECT_NEAR(sum / (of.surface_m2 / 4), 1, 0.01) << of.solid.name;
    }
}

TEST(Silhouette, AlongAndAcrossTheAxisAreWhatTheyLookLike) {
    const Solid cone = convex_rig::cone(0.5, 0.6);
    EXPECT_NEAR(silhouette_m2(cone.shape, {0, 1, 0}), kPiD * 0.25, 1e-6);
    EXPECT_NEAR(silhouette_m2(cone.shape, {1, 0, 0}), 0.5 * 1.2, 1e-6);
    const Solid can = convex_rig::cylinder(0.3, 0.4);
    EXPECT_NEAR(silhouette_m2(can.shape, {0, -1, 0}), kPiD * 0.09, 1e-6);
    EXPECT_NEAR(silhouette_m2(can.shape, {0, 0, 1}), 0.6 * 0.8, 1e-6);
}

/// The same solid as one part and as two that make it up, whose shadows overlap and join.
TEST(Silhouette, OfPartsCountsWhatLiesBehindAnotherOnce) {
    const Solid whole = convex_rig::box({0.5, 0.2, 0.3});
    const Solid half = convex_rig::box({0.3, 0.2, 0.3});
    BodyGeometry parts;
    for (const double side : {-0.2, 0.2}) {
        GeometryPart part{.shape = half.shape};
        part.mass_from_part.position_m = {static_cast<Real>(side), 0, 0};
        parts.parts.push_back(part);
    }
    Random random(3);
    for (int i = 0; i < 50; ++i) {
        const Vec3d direction = direction_of(random);
        const double exact_m2 = silhouette_m2(whole.shape, direction);
        EXPECT_NEAR(silhouette_m2(parts, direction) / exact_m2, 1, 5e-3)
            << direction.x << " " << direction.y << " " << direction.z;
    }
}

TEST(Silhouette, OfPartsApartIsTheirSum) {
    const Solid ball = convex_rig::sphere(0.25);
    BodyGeometry parts;
    for (const double side : {-1.0, 1.0}) {
        GeometryPart part{.shape = ball.shape};
        part.mass_from_part.position_m = {static_cast<Real>(side), 0, 0};
        parts.parts.push_back(part);
    }
    EXPECT_NEAR(silhouette_m2(parts, {0, 1, 0}), 2 * kPiD / 16, 2e-3);
    EXPECT_NEAR(silhouette_m2(parts, {1, 0, 0}), kPiD / 16, 1e-3) << "one hides the other";
    EXPECT_EQ(silhouette_m2(BodyGeometry{}, {1, 0, 0}), 0);
}

}  // namespace
}  // namespace plumbline::physics
