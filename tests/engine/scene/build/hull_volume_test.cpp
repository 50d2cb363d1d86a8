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

}  // namespace
}  // namespace plumbline::scene
