#include "engine/physics/collision/shape/hull_geometry.h"

#include "tests/engine/physics/collision/shape/hull_rig.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace plumbline::physics {
namespace {

using namespace hull_rig;

std::size_t faces_with(const HullGeometry& hull, std::uint32_t corners) {
    return static_cast<std::size_t>(std::ranges::count_if(
        hull.faces, [corners](const HullFace& face) { return face.count == corners; }));
}

/// Of every face: normal out, all corners below, its own on the plane and counter-clockwise.
void expect_faces_whole(const HullGeometry& hull, double near_m) {
    for (const HullFace& face : hull.faces) {
        EXPECT_NEAR(glm::length(face.normal), 1, 1e-12);
        for (const Vec3d& corner : hull.corners_m)
            EXPECT_LE(glm::dot(face.normal, corner), face.offset_m + 1e-12);
        const auto rim = hull.corners_of(face);
        for (std::size_t i = 0; i < rim.size(); ++i) {
            const Vec3d& here = hull.corners_m[rim[i]];
            const Vec3d& next = hull.corners_m[rim[(i + 1) % rim.size()]];
            const Vec3d& after = hull.corners_m[rim[(i + 2) % rim.size()]];
            EXPECT_NEAR(glm::dot(face.normal, here), face.offset_m, near_m);
            EXPECT_GT(glm::dot(glm::cross(next - here, after - next), face.normal), 0);
        }
    }
}

/// Neighbours both ways, none of its own, and a way from each corner to all.
void expect_neighbours_whole(const HullGeometry& hull) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    const auto count = static_cast<std::uint32_t>(hull.corners_m.size());
    ASSERT_EQ(hull.first_neighbour.size(), count + 1U);
    for (std::uint32_t i = 0; i < count; ++i) {
        for (std::uint32_t n = hull.first_neighbour[i]; n < hull.first_neighbour[i + 1]; ++n)
            edges.insert({i, hull.neighbours[n]});
    }
    EXPECT_EQ(edges.size(), hull.neighbours.size()) << "each once";
    for (const auto& [from, to] : edges) {
        EXPECT_NE(from, to);
        EXPECT_TRUE(edges.contains({to, from}));
    }
    std::vector<std::uint32_t> reached{0};
    for (std::size_t next = 0; next < reached.size(); ++next) {
        for (const auto& [from, to] : edges) {
            if (from == reached[next] && !std::ranges::count(reached, to)) reached.push_back(to);
        }
    }
    EXPECT_EQ(reached.size(), count);
}

TEST(HullGeometry, ACubeHasSixFacesOfFourCorners) {
    const HullGeometry cube = hull_round(cube_corners({0.5, 0.5, 0.5}));
    EXPECT_EQ(surface_of(cube.corners_m).size(), 12U);
    EXPECT_EQ(cube.faces.size(), 6U);
    EXPECT_EQ(faces_with(cube, 4), 6U);
    expect_faces_whole(cube, 1e-12);
    expect_neighbours_whole(cube);
    EXPECT_NEAR(cube.width_m, 1, 1e-12);
}

TEST(HullGeometry, AnOctagonalPrismHasTenFaces) {
    const HullGeometry prism = hull_round(prism_corners(8, 0.5, 0.4));
    EXPECT_EQ(prism.faces.size(), 10U);
    EXPECT_EQ(faces_with(prism, 8), 2U);
    EXPECT_EQ(faces_with(prism, 4), 8U);
    expect_faces_whole(prism, 1e-12);
    expect_neighbours_whole(prism);
    EXPECT_NEAR(prism.width_m, 0.8, 1e-12) << "lower than it is wide";
}

TEST(HullGeometry, PointsOnEdgesAreNoCornersOfFaces) {
    std::vector<Vec3d> points = cube_corners({0.5, 0.5, 0.5});
    points.insert(points.end(), {{0.5, 0.5, 0.1}, {0.5, 0.5, -0.3}, {0, 0.5, 0.5}});
    const HullGeometry cube = hull_round(points);
    EXPECT_EQ(cube.faces.size(), 6U);
    EXPECT_EQ(faces_with(cube, 4), 6U);
    expect_faces_whole(cube, 1e-12);
    expect_neighbours_whole(cube);
}

TEST(HullGeometry, FacesThatHardlyBendAreOne) {
    std::vector<Vec3d> points = cube_corners({0.5, 0.5, 0.5});
    points.emplace_back(0, 0.50005, 0);
    const HullGeometry cube = hull_round(points);
    EXPECT_EQ(cube.faces.size(), 6U);
    expect_faces_whole(cube, kFaceSag * 1.1);
    points.back().y = 0.502;
    EXPECT_EQ(hull_round(points).faces.size(), 9U);
}

TEST(HullGeometry, ANeedleKeepsAllItsFaces) {
    const HullGeometry needle = hull_round(prism_corners(3, 0.001, 0.5));
    EXPECT_EQ(needle.faces.size(), 5U);
    EXPECT_EQ(faces_with(needle, 3), 2U);
    EXPECT_EQ(faces_with(needle, 4), 3U);
    expect_faces_whole(needle, 1e-12);
    expect_neighbours_whole(needle);
    EXPECT_NEAR(needle.width_m, 0.0015, 1e-12) << "a triangle's height";
}

TEST(HullGeometry, ManyCornersOnASphereAreTrianglesThatCloseIt) {
    const HullGeometry ball = hull_round(sphere_corners(64, 0.5));
    // Euler: corners - edges + faces is 2.
    EXPECT_EQ(ball.corners_m.size() - ball.neighbours.size() / 2 + ball.faces.size(), 2U);
    EXPECT_EQ(faces_with(ball, 3), ball.faces.size());
    expect_faces_whole(ball, 1e-12);
    expect_neighbours_whole(ball);
    EXPECT_NEAR(ball.width_m, 1, 0.1);
}

}  // namespace
}  // namespace plumbline::physics
