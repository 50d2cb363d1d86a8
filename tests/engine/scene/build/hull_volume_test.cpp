// The volume of a convex hull.
#include "engine/scene/build/shape_factory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace plumbline::scene {
namespace {

TEST(HullVolume, OfACubeIgnoresPointsInside) {
    std::vector<Vec3> points = points_of(physics::ShapeDef{physics::BoxShape{.size_m = {1, 1, 1}}});
    points.push_back({0.1_r, 0.2_r, -0.1_r});
    points.push_back({0.5_r, 0, 0});  // on a face
    EXPECT_NEAR(static_cast<double>(hull_volume_m3(points)), 1.0, 1e-6);
}

TEST(HullVolume, OfATetrahedronIsASixth) {
    const std::vector<Vec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    EXPECT_NEAR(static_cast<double>(hull_volume_m3(corners)), 1.0 / 6.0, 1e-6);
}

TEST(HullVolume, OfFlatPointsIsNone) {
    EXPECT_EQ(hull_volume_m3({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 3, 0}}), Real{0});
    EXPECT_EQ(hull_volume_m3({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}), Real{0});
    EXPECT_EQ(hull_volume_m3({{1, 1, 1}}), Real{0});
}

// A prism over a regular polygon of n corners: n / 2 sin(2 pi / n) wide; in any order, anywhere.
TEST(HullVolume, OfAPrismIsBaseTimesHeightWhereverItStands) {
    constexpr int kCorners = 9;
    std::vector<Vec3> points;
    for (int i = 0; i < kCorners; ++i) {
        const Real angle = 2 * kPi * static_cast<Real>(i) / Real{kCorners};
        for (const Real z : {Real{0}, Real{4}})
            points.push_back({50 + std::cos(angle), std::sin(angle) - 7, z});
    }
    const double base_m2 = kCorners / 2.0 * std::sin(2 * glm::pi<double>() / kCorners);
    EXPECT_NEAR(static_cast<double>(hull_volume_m3(points)), 4 * base_m2, 1e-4);
    std::reverse(points.begin(), points.end());
    const std::vector<Vec3> twice = [&] {
        std::vector<Vec3> all = points;
        all.insert(all.end(), points.begin(), points.end());
        return all;
    }();
    EXPECT_NEAR(static_cast<double>(hull_volume_m3(twice)), 4 * base_m2, 1e-4);
}

/// Points spread evenly over the unit sphere, along a spiral.
std::vector<Vec3> sphere_points(int count) {
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) {
        const double y = 1.0 - (2.0 * i + 1.0) / count;
        const double angle = 2.39996322972865332 * i;
        const double ring = std::sqrt(1.0 - y * y);
        points.push_back(Vec3(Vec3d{ring * std::cos(angle), y, ring * std::sin(angle)}));
    }
    return points;
}

// The largest hull that a scene may name. Flat triangles cut off a share of the ball's volume: with n
// points sqrt(3) pi / n where all are equilateral, 2 pi / n where they halve squares; a spiral's lie between.
TEST(HullVolume, OfTenThousandPointsOnASphereIsNearlyTheSpheres) {
    constexpr int kPoints = 10'000;
    const double volume_m3 = static_cast<double>(hull_volume_m3(sphere_points(kPoints)));
    const double cut_off = 1.0 - volume_m3 / (4.0 / 3.0 * glm::pi<double>());
    EXPECT_GT(cut_off * kPoints, std::sqrt(3.0) * glm::pi<double>() * 0.99);
    EXPECT_LT(cut_off * kPoints, 2.0 * glm::pi<double>() * 1.01);
}

// Ten thousand points of a grid on a cube's faces: nearly all lie on faces and edges that others make.
TEST(HullVolume, OfAGridOnACubeIsTheCubes) {
    std::vector<Vec3> points;
    constexpr int kSide = 41;
    for (int i = 0; i < kSide; ++i) {
        for (int j = 0; j < kSide; ++j) {
            const Real u = static_cast<Real>(i) / (kSide - 1);
            const Real v = static_cast<Real>(j) / (kSide - 1);
            for (const Real w : {Real{0}, Real{1}})
                for (const Vec3& p : {Vec3{u, v, w}, Vec3{w, u, v}, Vec3{v, w, u}})
                    points.push_back(p * Real{3} + Vec3{10, -20, 30});
        }
    }
    EXPECT_NEAR(static_cast<double>(hull_volume_m3(points)), 27.0, 1e-3);
}

}  // namespace
}  // namespace plumbline::scene
