#include "engine/physics/collision/mesh/triangle_distance.h"

#include "engine/core/random.h"
#include "engine/physics/collision/mesh/face_clip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

Vec3d random_place(Random& random) {
    const auto number = [&random] { return static_cast<double>(random.uniform(-1.0F, 1.0F)); };
    return {number(), number(), number()};
}

std::array<Vec3d, 3> random_triangle(Random& random) {
    return {random_place(random), random_place(random), random_place(random)};
}

Vec3d normal_of(const std::array<Vec3d, 3>& corners) {
    return glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
}

TEST(TriangleDistance, IsThatOfTheNearestOfManyPlaces) {
    Random random(1);
    for (int i = 0; i < 200; ++i) {
        const std::array<Vec3d, 3> corners = random_triangle(random);
        const Vec3d place = random_place(random) * 2.0;
        const NearestPoint found = nearest_to(place, corners, normal_of(corners));
        double least2 = 1e9;
        constexpr int kSteps = 100;
        for (int u = 0; u <= kSteps; ++u) {
            for (int v = 0; u + v <= kSteps; ++v) {
                const Vec3d at = corners[0] + (corners[1] - corners[0]) * (u / 100.0) +
                                 (corners[2] - corners[0]) * (v / 100.0);
                least2 = std::min(least2, glm::dot(at - place, at - place));
            }
        }
        const double own_m = glm::distance(found.at, place);
        EXPECT_LE(own_m, std::sqrt(least2) + 1e-12);
        EXPECT_NEAR(own_m, std::sqrt(least2), 0.04) << "the places are up to 3 cm apart";
        EXPECT_NEAR(own_m * own_m, away_from_triangle2(place, corners), 1e-12);
        const auto [a, b, c] = nearest_shares(place, corners);
        EXPECT_NEAR(a + b + c, 1, 1e-12);
        EXPECT_GE(std::min({a, b, c}), 0);
        EXPECT_NEAR(
            glm::distance(a * corners[0] + b * corners[1] + c * corners[2], found.at), 0, 1e-9);
    }
}

TEST(TriangleDistance, OfALineEndsAtItsEnds) {
    EXPECT_NEAR(away_from_line2({0.5, 2, 0}, {0, 0, 0}, {1, 0, 0}), 4, 1e-12);
    EXPECT_NEAR(away_from_line2({3, 0, 0}, {0, 0, 0}, {1, 0, 0}), 4, 1e-12);
    EXPECT_NEAR(away_from_line2({0, 1, 0}, {0, 0, 0}, {0, 0, 0}), 1, 1e-12);
}

TEST(FaceClip, LeavesTheCommonPartOfASquareAndATriangle) {
    // Half of the unit square lies over the triangle.
    const std::array<Vec3d, 4> square{{{0, 1, 0}, {0, 1, 1}, {1, 1, 1}, {1, 1, 0}}};
    const std::array<Vec3d, 3> triangle{{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}}};
    ClippedPolygon part;
    clip_to_triangle(square, triangle, {0, 1, 0}, 1e-9, part);
    ASSERT_EQ(part.count, 3U);
    double area = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(part.corners[i].y, 1, 1e-12) << "on the square";
        const Vec3d& here = part.corners[i];
        const Vec3d& next = part.corners[(i + 1) % 3];
        area += (here.z * next.x - here.x * next.z) / 2;
    }
    EXPECT_NEAR(std::abs(area), 0.5, 1e-9);
}

TEST(FaceClip, LeavesNothingOfWhatIsBesideTheTriangle) {
    const std::array<Vec3d, 2> line{{{2, 0, 2}, {3, 0, 2}}};
    const std::array<Vec3d, 3> triangle{{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}}};
    ClippedPolygon part;
    clip_to_triangle(line, triangle, {0, 1, 0}, 1e-9, part);
    EXPECT_EQ(part.count, 0U);
}

}  // namespace
}  // namespace plumbline::physics
