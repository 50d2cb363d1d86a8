#include "engine/physics/collision/mesh/triangle_contact.h"

#include "engine/physics/collision/mesh/mesh_patches.h"

#include <gtest/gtest.h>

namespace plumbline::physics {
namespace {

/// A roof along z, its ridge at x = 0 and y = 0, both slopes 45 degrees down.
MeshGeometry roof() {
    const std::vector<Vec3> corners{
        {-1, -1, -1}, {-1, -1, 1}, {0, 0, -1}, {0, 0, 1}, {1, -1, -1}, {1, -1, 1}};
    const std::vector<std::array<std::uint32_t, 3>> triangles{
        {0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {4, 3, 5}};
    return mesh_geometry(corners, triangles);
}

std::vector<MeshPoint> points_of(const ConvexShape& shape, const Transform& at, double reach_m) {
    const MeshGeometry mesh = roof();
    const Vec3d origin{at.position_m};
    const PlacedConvex convex = placed_convex({shape, at}, origin);
    const PlacedMesh placed(mesh, Transform{}, origin);
    TriangleContacts contacts(convex, placed, reach_m);
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) contacts.add(i);
    return contacts.points();
}

TEST(TriangleContacts, OfAPlateOnOneSlopeAreAllOnItsFront) {
    // It lies on the left slope and reaches over the ridge: its centre is behind the plane of the right slope.
    const ConvexShape plate{.kind = ConvexShape::Kind::Box, .half_m = {0.3_r, 0.01_r, 0.05_r}};
    const Real half_root = 0.70710678118654752_r;
    const Transform at{
        .rotation = Mat3{half_root, half_root, 0, -half_root, half_root, 0, 0, 0, 1},
        .position_m = Vec3{-0.2_r, -0.2_r, 0} + Vec3{-1, 1, 0} * (0.0095_r * half_root)};
    const std::vector<MeshPoint> points = points_of(plate, at, 0.02);
    ASSERT_FALSE(points.empty());
    for (const MeshPoint& point : points) {
        EXPECT_NEAR(point.normal.x, static_cast<double>(-half_root), 1e-5);
        EXPECT_NEAR(point.normal.y, static_cast<double>(half_root), 1e-5);
        EXPECT_NEAR(point.distance_m, -0.0005, 1e-5);
        EXPECT_FALSE(point.is_behind);
    }
}

TEST(TriangleContacts, OfABallOverTheRidgeIsTheRidge) {
    const ConvexShape ball{.kind = ConvexShape::Kind::Sphere, .radius_m = 0.1_r};
    const Transform at{.position_m = {0, 0.12_r, 0.3_r}};
    const MeshGeometry mesh = roof();
    const Vec3d origin{at.position_m};
    const PlacedConvex convex = placed_convex({ball, at}, origin);
    const PlacedMesh placed(mesh, Transform{}, origin);
    const std::vector<MeshPoint> points = points_of(ball, at, 0.05);
    const std::vector<PointGroup> groups = group_points(convex, placed, points, 4);
    ASSERT_EQ(groups.size(), 1U);
    EXPECT_EQ(groups[0].count, 1U);
    EXPECT_NEAR(groups[0].normal.y, 1, 1e-6);
    EXPECT_NEAR(groups[0].points[0].distance_m, 0.02, 1e-6);
}

}  // namespace
}  // namespace plumbline::physics
