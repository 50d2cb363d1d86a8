#include "engine/physics/collision/shape/mesh_geometry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// Two triangles that share the edge along z; the second leans by `rise` over `1`.
MeshGeometry folded(Real rise, const Triangle& second = {1, 2, 3}) {
    const std::vector<Vec3> corners{{-1, 0, 0.5_r}, {0, 0, 1}, {0, 0, 0}, {1, rise, 0.5_r}};
    // The first looks up: counter-clockwise from above.
    return mesh_geometry(corners,
                         std::vector<Triangle>{{0, 1, 2}, {second[0], second[2], second[1]}});
}

EdgeKind shared_edge(const MeshGeometry& mesh, std::size_t triangle) {
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3d from = mesh.corner_m(mesh.triangles[triangle], i);
        const Vec3d to = mesh.corner_m(mesh.triangles[triangle], (i + 1) % 3);
        if (from.x == 0 && to.x == 0) return mesh.triangles[triangle].edges[i];
    }
    return EdgeKind::Rim;
}

int count_of(const MeshGeometry& mesh, EdgeKind kind) {
    int count = 0;
    for (const MeshTriangle& triangle : mesh.triangles)
        count += static_cast<int>(std::ranges::count(triangle.edges, kind));
    return count;
}

TEST(MeshGeometry, AnEdgeIsKnownFromBothOfItsTriangles) {
    for (std::size_t t = 0; t < 2; ++t) {
        EXPECT_EQ(shared_edge(folded(0), t), EdgeKind::Flat);
        EXPECT_EQ(shared_edge(folded(0.0005_r), t), EdgeKind::Flat) << "half a milliradian";
        EXPECT_EQ(shared_edge(folded(0.01_r), t), EdgeKind::Concave);
        EXPECT_EQ(shared_edge(folded(-0.01_r), t), EdgeKind::Convex);
    }
    EXPECT_EQ(count_of(folded(0), EdgeKind::Rim), 4);
}

TEST(MeshGeometry, AFlippedTrianglesEdgesAreSeenFromItsOwnFront) {
    const Triangle flipped{1, 3, 2};
    EXPECT_EQ(shared_edge(folded(0, flipped), 1), EdgeKind::Flat);
    EXPECT_EQ(shared_edge(folded(0.1_r, flipped), 0), EdgeKind::Concave);
    EXPECT_EQ(shared_edge(folded(0.1_r, flipped), 1), EdgeKind::Convex);
}

TEST(MeshGeometry, ATriangleFoldedBackOnItsNeighbourHasARimThere) {
    const std::vector<Vec3> corners{{-1, 0, 0.5_r}, {0, 0, 1}, {0, 0, 0}, {-1, 0, 0.7_r}};
    const MeshGeometry mesh = mesh_geometry(corners, std::vector<Triangle>{{0, 1, 2}, {1, 2, 3}});
    EXPECT_EQ(count_of(mesh, EdgeKind::Rim), 6);
}

TEST(MeshGeometry, EqualPlacesAreOneCorner) {
    const std::vector<Vec3> soup{
        {-1, 0, 0.5_r}, {0, 0, 1}, {-0.0_r, 0, 0}, {0, -0.0_r, 1}, {1, 0, 0.5_r}, {0, 0, 0}};
    const MeshGeometry mesh = mesh_geometry(soup, std::vector<Triangle>{{0, 1, 2}, {3, 4, 5}});
    EXPECT_EQ(mesh.corners_m.size(), 4U);
    EXPECT_EQ(count_of(mesh, EdgeKind::Flat), 2);
}

TEST(MeshGeometry, TrianglesWithoutAreaAndRepeatedOnesAreLeftOut) {
    const std::vector<Vec3> corners{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 1}, {1e-3_r, 0, 1}};
    const MeshGeometry mesh = mesh_geometry(
        corners,
        std::vector<Triangle>{{0, 1, 2}, {0, 0, 1}, {0, 3, 1}, {3, 1, 0}, {0, 3, 4}, {4, 3, 0}});
    ASSERT_EQ(mesh.triangles.size(), 2U) << "a needle of 1:1000 stays";
    EXPECT_EQ(mesh.triangles[0].source, 2U);
    EXPECT_FALSE(mesh.triangles[0].has_two_fronts);
    EXPECT_EQ(mesh.triangles[1].source, 4U);
    EXPECT_TRUE(mesh.triangles[1].has_two_fronts);
}

TEST(MeshGeometry, AnEdgeOfThreeTrianglesIsARimOfEach) {
    const std::vector<Vec3> corners{
        {-1, 0, 0.5_r}, {0, 0, 1}, {0, 0, 0}, {1, 0, 0.5_r}, {0, 1, 0.5_r}};
    const MeshGeometry mesh =
        mesh_geometry(corners, std::vector<Triangle>{{0, 1, 2}, {2, 1, 3}, {2, 1, 4}});
    EXPECT_EQ(count_of(mesh, EdgeKind::Rim), 9);
}

TEST(MeshGeometry, TheTreeKnowsEveryTriangle) {
    const MeshGeometry mesh = folded(1);
    int count = 0;
    mesh.tree.visit({Vec3d{0.5, 0, 0}, Vec3d{2}}, [&count](std::uint32_t t) {
        EXPECT_EQ(t, 1U);
        ++count;
    });
    EXPECT_EQ(count, 1);
}

TEST(MeshGeometry, NothingMakesAnEmptyMesh) {
    const MeshGeometry mesh = mesh_geometry({}, {});
    EXPECT_TRUE(mesh.triangles.empty());
    EXPECT_TRUE(mesh.tree.is_empty());
}

}  // namespace
}  // namespace plumbline::physics
