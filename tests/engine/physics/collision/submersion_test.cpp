// What lies below a level, against closed forms and against sums over a grid of points.
#include "engine/physics/collision/submersion.h"

#include "engine/core/random.h"
#include "tests/engine/physics/collision/narrow_phase/convex_rig.h"
#include "tests/engine/physics/test_world.h"

#include <gtest/gtest.h>

namespace plumbline::physics {
namespace {

using convex_rig::Solid;

BodyGeometry of(const Solid& solid) {
    BodyGeometry geometry;
    geometry.parts.push_back({.shape = solid.shape});
    return geometry;
}

std::vector<Solid> floats() {
    return {convex_rig::sphere(0.5),
            convex_rig::box({0.3, 0.5, 0.2}),
            convex_rig::hull("stone", convex_rig::random_corners(14, 5)),
            convex_rig::capsule(0.3, 0.4),
            convex_rig::cylinder(0.3, 0.4),
            convex_rig::cone(0.5, 0.6)};
}

/// Whether a point of the shape's frame lies in it.
bool holds(const ConvexShape& shape, const Vec3d& at) {
    const auto r = static_cast<double>(shape.radius_m);
    const auto half = static_cast<double>(shape.half_height_m);
    const double out = std::hypot(at.x, at.z);
    switch (shape.kind) {
        case ConvexShape::Kind::Sphere:
            return glm::length(at) <= r;
        case ConvexShape::Kind::Box:
            return glm::all(glm::lessThanEqual(glm::abs(at), Vec3d(shape.half_m)));
        case ConvexShape::Kind::Capsule:
            return std::hypot(out, std::max(std::abs(at.y) - half, 0.0)) <= r;
        case ConvexShape::Kind::Cylinder:
            return out <= r && std::abs(at.y) <= half;
        case ConvexShape::Kind::Cone:
            return std::abs(at.y) <= half && out <= r * (half - at.y) / (2 * half);
        case ConvexShape::Kind::Hull:
            return std::ranges::all_of(shape.hull->faces, [&](const HullFace& face) {
                return glm::dot(face.normal, at) <= face.offset_m;
            });
        case ConvexShape::Kind::None:
            break;
    }
    return false;
}

struct Counted {
    double volume_m3{0};
    Vec3d center_m{0, 0, 0};
};

Counted counted(const Solid& solid, const Vec3d& center, const Quatd& turn) {
    constexpr int kCells = 80;
    constexpr double kHalf_m = 1;
    Counted sum;
    const double cell = 2 * kHalf_m / kCells;
    for (int i = 0; i < kCells; ++i) {
        for (int j = 0; j < kCells; ++j) {
            for (int k = 0; k < kCells; ++k) {
                // The level lies between two layers.
                const Vec3d at{center.x - kHalf_m + (i + 0.5) * cell,
                               -kHalf_m + (j + 0.5) * cell,
                               center.z - kHalf_m + (k + 0.5) * cell};
                if (at.y > 0 || !holds(solid.shape, glm::conjugate(turn) * (at - center))) continue;
                sum.volume_m3 += cell * cell * cell;
                sum.center_m += at * (cell * cell * cell);
            }
        }
    }
    if (sum.volume_m3 > 0) sum.center_m /= sum.volume_m3;
    return sum;
}

double between(Random& random, double low, double high) {
    return static_cast<double>(random.uniform(static_cast<float>(low), static_cast<float>(high)));
}

Quatd turn_of(Random& random) {
    return glm::normalize(Quatd{between(random, -1, 1),
                                between(random, -1, 1),
                                between(random, -1, 1),
                                between(random, -1, 1) + 1e-3});
}

TEST(Submersion, IsWhatAGridOfPointsCounts) {
    Random random(11);
    for (const Solid& solid : floats()) {
        for (int i = 0; i < 8; ++i) {
            const Vec3d center{between(random, -2, 2), between(random, -0.4, 0.4), 3};
            const Quatd turn = turn_of(random);
            const Counted exact = counted(solid, center, turn);
            const Submersion found = submersion(of(solid), center, turn, 0, {0, 1, 0});
            EXPECT_NEAR(found.volume_m3, exact.volume_m3, 0.004) << solid.name << " " << i;
            if (exact.volume_m3 > 0.05) {
                EXPECT_LT(glm::distance(found.center_m, exact.center_m), 0.008) << solid.name;
            }
        }
    }
}

TEST(Submersion, GrowsByTheWaterlineWithTheLevel) {
    Random random(12);
    constexpr double kRise_m = 1e-4;
    for (const Solid& solid : floats()) {
        for (int i = 0; i < 50; ++i) {
            const Quatd turn = turn_of(random);
            const Vec3d center{0, between(random, -0.3, 0.3), 0};
            const auto at = [&](double level) {
                return submersion(of(solid), center, turn, level, {0, 1, 0});
            };
            const double grown_m2 =
                (at(kRise_m).volume_m3 - at(-kRise_m).volume_m3) / (2 * kRise_m);
            EXPECT_NEAR(at(0).waterline_m2, grown_m2, 0.03 * std::max(grown_m2, 0.2))
                << solid.name << " " << i;
        }
    }
}

/// What is below and what is above, turned upside down, are the whole.
TEST(Submersion, AndItsOppositeAreTheWhole) {
    Random random(13);
    for (const Solid& solid : floats()) {
        const double whole_m3 =
            submersion(of(solid), {0, -5, 0}, {1, 0, 0, 0}, 0, {0, 1, 0}).volume_m3;
        for (int i = 0; i < 200; ++i) {
            const Quatd turn = turn_of(random);
            const double height = between(random, -0.6, 0.6);
            const Quatd upside_down{0, 1, 0, 0};
            const Submersion below = submersion(of(solid), {0, height, 0}, turn, 0, {0, 1, 0});
            const Submersion above =
                submersion(of(solid), {0, -height, 0}, upside_down * turn, 0, {0, 1, 0});
            EXPECT_NEAR(below.volume_m3 + above.volume_m3, whole_m3, 1e-6 * whole_m3)
                << solid.name << " " << i << " at " << height;
            EXPECT_NEAR(below.whole_m3, whole_m3, 1e-6 * whole_m3) << solid.name;
        }
    }
}

TEST(Submersion, UprightShapesAreAsTheBooksSay) {
    const Quatd upright{1, 0, 0, 0};
    const Submersion cap =
        submersion(of(convex_rig::sphere(0.5)), {0, 0.3, 0}, upright, 0, {0, 1, 0});
    EXPECT_NEAR(cap.volume_m3, kPiD * 0.04 * (1.5 - 0.2) / 3, 1e-9);
    EXPECT_NEAR(cap.center_m.y, 0.3 - 3 * 0.64 / (4 * 1.3), 1e-9);
    const Submersion can =
        submersion(of(convex_rig::cylinder(0.3, 0.4)), {7, 0.1, -4}, upright, 0, {0, 1, 0});
    EXPECT_NEAR(can.volume_m3, kPiD * 0.09 * 0.3, 1e-7);
    EXPECT_NEAR(can.center_m.y, -0.15, 1e-7);
    EXPECT_NEAR(can.center_m.x, 7, 1e-7);
    EXPECT_NEAR(can.silhouette_m2, kPiD * 0.09, 1e-4) << "from below";
    const Submersion side =
        submersion(of(convex_rig::box({0.5, 0.2, 0.5})), {0, 0.1, 0}, upright, 0, {1, 0, 0});
    EXPECT_NEAR(side.silhouette_m2, 0.1, 1e-6) << "what is under, from the side";
    EXPECT_NEAR(side.waterline_m2, 1, 1e-6);
    EXPECT_EQ(submersion(of(convex_rig::sphere(0.5)), {0, 2, 0}, upright, 0, {0, 1, 0}).volume_m3,
              0);
}

/// Nearly upright round shapes, where the water cuts all discs within a hair of each other.
TEST(Submersion, DoesNotJumpWhereTheAxisIsNearlyUpright) {
    for (const Solid& solid : {convex_rig::cone(0.5, 0.6),
                               convex_rig::cylinder(0.3, 0.4),
                               convex_rig::capsule(0.3, 0.4)}) {
        const double exact =
            submersion(of(solid), {0, 0.1, 0}, {1, 0, 0, 0}, 0, {0, 1, 0}).volume_m3;
        for (double lean = 1e-10; lean < 1e-4; lean *= 3) {
            const Quatd turn = glm::normalize(Quatd{1, lean, 0, lean / 2});
            EXPECT_NEAR(
                submersion(of(solid), {0, 0.1, 0}, turn, 0, {0, 1, 0}).volume_m3, exact, 1e-6)
                << solid.name << " " << lean;
        }
    }
}

}  // namespace
}  // namespace plumbline::physics
