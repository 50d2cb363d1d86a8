// Which points of a contact stay.
#include "engine/physics/collision/narrow_phase/point_choice.h"

#include "engine/core/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <vector>

namespace plumbline::physics {
namespace {

constexpr double kLevel_m = 1e-4;

/// The corners of a regular polygon of radius 1 m, all 1 mm deep.
std::vector<FlatPoint> polygon(int corners) {
    std::vector<FlatPoint> points;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * i / corners;
        points.push_back({{std::cos(angle), std::sin(angle)}, -1e-3});
    }
    return points;
}

std::set<std::size_t> chosen(const std::vector<FlatPoint>& points) {
    const PointChoice choice = choose_points(points, kLevel_m);
    const auto kept = choice.points();
    return {kept.begin(), kept.end()};
}

TEST(PointChoice, KeepsAllCornersThatABodyMayStandOn) {
    for (const int corners : {1, 2, 3, 4, 5, 6, 7, 8})
        EXPECT_EQ(chosen(polygon(corners)).size(), static_cast<std::size_t>(corners)) << corners;
}

TEST(PointChoice, LeavesOutOfManyCornersWhatLiesWithinTheRest) {
    for (const int corners : {9, 12, 24, 60}) {
        const std::vector<FlatPoint> points = polygon(corners);
        std::vector<double> angles;
        for (const std::size_t i : chosen(points))
            angles.push_back(std::atan2(points[i].place.y, points[i].place.x));
        ASSERT_EQ(angles.size(), 8U) << corners;
        std::ranges::sort(angles);
        double widest = 2 * std::numbers::pi + angles.front() - angles.back();
        for (std::size_t i = 1; i < angles.size(); ++i)
            widest = std::max(widest, angles[i] - angles[i - 1]);
        EXPECT_LT(widest, 2 * std::numbers::pi / 4) << corners;
    }
    std::vector<FlatPoint> crowd = polygon(4);
    for (int i = 0; i < 20; ++i) crowd.push_back({{0.02 * i - 0.2, 0.01 * i}, -1e-3});
    EXPECT_EQ(chosen(crowd), (std::set<std::size_t>{0, 1, 2, 3})) << "inside";
}

TEST(PointChoice, DoesNotChangeWithTheLoadOfABodyAtRest) {
    Random random(3);
    for (const int corners : {5, 6, 8, 9, 24}) {
        const std::set<std::size_t> before = chosen(polygon(corners));
        for (int i = 0; i < 100; ++i) {
            // Contacts give way by up to 0.3 % of the extent, to any side.
            std::vector<FlatPoint> points = polygon(corners);
            const glm::dvec2 lean{random.uniform(-1e-3F, 1e-3F), random.uniform(-1e-3F, 1e-3F)};
            for (FlatPoint& point : points) point.distance_m += glm::dot(lean, point.place);
            const std::set<std::size_t> now = chosen(points);
            if (corners <= 8) {
                EXPECT_EQ(now, before) << corners;
            }
            // What is deeper than all that is kept may take the place of one.
            std::size_t same = 0;
            for (const std::size_t kept : before) same += now.contains(kept) ? 1U : 0U;
            EXPECT_GE(same + 1, before.size()) << corners;
        }
    }
}

/// A coin far down a stack is pressed in by several times what its extent lets pass as level: without the shallow side it would tip.
TEST(PointChoice, KeepsBothSidesOfWhatIsPressedInDeeply) {
    std::vector<FlatPoint> points = polygon(8);
    for (FlatPoint& point : points) point.distance_m = -0.02 - 0.005 * point.place.x;
    double least = 0;
    double most = 0;
    for (const std::size_t kept : chosen(points)) {
        least = std::min(least, points[kept].place.x);
        most = std::max(most, points[kept].place.x);
    }
    EXPECT_LT(least, -0.9);
    EXPECT_GT(most, 0.9);
}

TEST(PointChoice, KeepsTheDeepest) {
    Random random(5);
    for (int i = 0; i < 1000; ++i) {
        std::vector<FlatPoint> points;
        const std::uint32_t count = 5 + random.below(30);
        for (std::uint32_t k = 0; k < count; ++k)
            points.push_back(
                {{random.uniform(-1, 1), random.uniform(-1, 1)}, random.uniform(-0.02F, 0.02F)});
        const auto depth = [&](std::size_t k) { return points[k].distance_m; };
        const std::set<std::size_t> kept = chosen(points);
        ASSERT_LE(kept.size(), PointChoice::kMost);
        const double deepest_m = std::ranges::min(points, {}, &FlatPoint::distance_m).distance_m;
        double kept_m = 1;
        for (const std::size_t k : kept) kept_m = std::min(kept_m, depth(k));
        ASSERT_LE(kept_m, deepest_m + kLevel_m);
    }
}

/// A plate across a ridge that leans to one side: it lies on the ridge and the corners there.
TEST(PointChoice, KeepsTheRidgeAPlateLiesOn) {
    const std::vector<FlatPoint> points{{{-1, -0.5}, -1e-3},
                                        {{-1, 0.5}, -1e-3},
                                        {{0, -0.5}, -1e-3},
                                        {{0, 0.5}, -1e-3},
                                        {{1, -0.5}, 0.02},
                                        {{1, 0.5}, 0.02}};
    const std::set<std::size_t> kept = chosen(points);
    for (const std::size_t i : {0U, 1U, 2U, 3U}) EXPECT_TRUE(kept.contains(i)) << i;
}

TEST(PointChoice, TakesPointsInALineOrInOnePlace) {
    const std::vector<FlatPoint> line{
        {{0, 0}, 0}, {{1, 0}, 0}, {{2, 0}, 0}, {{3, 0}, 0}, {{5, 0}, 0}};
    EXPECT_EQ(chosen(line), (std::set<std::size_t>{0, 4}));
    EXPECT_EQ(chosen(std::vector<FlatPoint>(6, FlatPoint{{1, 2}, 0})).size(), 1U);
}

}  // namespace
}  // namespace plumbline::physics
