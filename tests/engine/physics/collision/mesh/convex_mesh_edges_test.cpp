#include "tests/engine/physics/collision/mesh/convex_mesh_fixture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace plumbline::physics {
namespace {

TEST(ConvexMeshEdges, SeamsAreNeverFelt) {
    const MeshGeometry mesh = flat_grid(64, 0.25_r).mesh();
    const Octagon octagon;
    std::mt19937 random(5);
    std::uniform_real_distribution<Real> place(-7, 7);
    std::uniform_real_distribution<Real> share(0, 1);
    for (const Transform& world_from_mesh :
         {Transform{}, Transform{turned({3, 1, 2}, 2.1_r), {-4, 0.5_r, 1}}}) {
        for (int trial = 0; trial < 2000; ++trial) {
            for (const ConvexShape* shape : {&kBall, &kBox, &kRod, &kDrum, &octagon.shape}) {
                // At any angle, sunk in by up to 3 cm.
                const Mat3 rotation = turned({share(random), share(random), share(random) - 0.5_r},
                                             6 * share(random));
                const Transform probe{rotation, {0, 0, 0}};
                const MeshGeometry plane = flat_grid(1, 1000).mesh();
                Transform at = probe;
                at.position_m = {0, 0.1_r, 0};
                const Patches deep = meet(*shape, at, plane, {}, 1);
                ASSERT_EQ(deep.size(), 1U);
                const Real low_m = static_cast<Real>(deepest(deep));
                at.position_m = {
                    place(random), 0.1_r - low_m - 0.03_r * share(random), place(random)};
                const Transform world{world_from_mesh.rotation * at.rotation,
                                      world_from_mesh(at.position_m)};
                const Patches found = meet(*shape, world, mesh, world_from_mesh);
                ASSERT_EQ(found.size(), 1U) << "kind " << static_cast<int>(shape->kind);
                expect_near(found[0].normal, world_from_mesh.rotation[1], 1e-6);
                EXPECT_NEAR(
                    deepest(found), static_cast<double>(at.position_m.y - 0.1_r + low_m), 1e-4);
            }
        }
    }
}

TEST(ConvexMeshEdges, AnEdgeThatCountsAsFlatLosesNoBody) {
    // The slope changes by 0.8 mrad from cell to cell.
    constexpr Real kCell_m = 0.25_r;
    const Real curve = 0.0008_r / kCell_m / 2;
    const MeshGeometry dome =
        grid(16, kCell_m, [curve](Real x, Real) { return -curve * x * x; }).mesh();
    const Mat3 lying = turned({1, 0, 0}, kPi / 2);
    for (int step = -300; step <= 300; ++step) {
        // Straight over the seam at 0.5 m and just beside it.
        const Real lean = 2 * curve * 0.5_r + static_cast<Real>(step) * 5e-6_r;
        const Vec3 seam{0.5_r, -curve * 0.25_r, 0.1_r};
        const Vec3 out{std::sin(lean), std::cos(lean), 0};
        for (const ConvexShape* shape : {&kBall, &kRod}) {
            const Vec3 center = seam + out * shape->radius_m;
            const Patches found = meet(*shape, {lying, center}, dome);
            ASSERT_EQ(found.size(), 1U) << step;
            EXPECT_NEAR(deepest(found), 0, 1e-6);
        }
    }
}

TEST(ConvexMeshEdges, ABallOnARidgeTouchesItOnce) {
    const MeshGeometry roof = fold(-0.5_r).mesh();
    for (const Real x : {0.0_r, 0.01_r, -0.05_r, 0.08_r}) {
        const Vec3 center{x, 0.25_r, 0.3_r};
        const Patches found = meet(kBall, {Mat3{1}, center}, roof);
        ASSERT_EQ(found.size(), 1U) << x << text_of(found);
        ASSERT_EQ(found[0].count, 1U);
        const Vec3 ridge{0, 0, 0.3_r};
        expect_near(found[0].points[0].on_mesh, ridge, kNear_m);
        expect_near(found[0].normal, glm::normalize(center - ridge), 1e-6);
        EXPECT_NEAR(found[0].points[0].distance_m, glm::distance(center, ridge) - 0.25_r, kNear_m);
    }
}

TEST(ConvexMeshEdges, ABallInAGutterTouchesBothFaces) {
    const MeshGeometry gutter = fold(0.75_r).mesh();
    // The faces lean by 3:4:5; a centre this high is 0.248 m from both.
    const Patches found = meet(kBall, {Mat3{1}, {0, 0.31_r, 0.3_r}}, gutter);
    ASSERT_EQ(found.size(), 2U);
    for (const MeshPatch& patch : found) {
        ASSERT_EQ(patch.count, 1U);
        const Real side = patch.normal.x > 0 ? -1 : 1;
        expect_near(patch.normal, {-side * 0.6_r, 0.8_r, 0}, 1e-6);
        EXPECT_NEAR(patch.points[0].distance_m, -0.002, kNear_m);
        expect_near(
            patch.points[0].on_mesh, Vec3{0, 0.31_r, 0.3_r} - patch.normal * 0.248_r, kNear_m);
    }
    EXPECT_LT(found[0].normal.x * found[1].normal.x, 0);
}

TEST(ConvexMeshEdges, ABallBesideARimIsPushedOutward) {
    const MeshGeometry sheet = flat_grid(4, 1).mesh();
    const Vec3 center{2.1_r, 0.2_r, 0.35_r};
    const Vec3 rim{2, 0, 0.35_r};
    for (const Real side : {1.0_r, -1.0_r}) {
        const Vec3 there{center.x, center.y * side, center.z};
        const Patches found = meet(kBall, {Mat3{1}, there}, sheet);
        ASSERT_EQ(found.size(), 1U);
        ASSERT_EQ(found[0].count, 1U);
        expect_near(found[0].normal, glm::normalize(there - rim), 1e-6);
        expect_near(found[0].points[0].on_mesh, rim, kNear_m);
    }
    const Vec3 corner{2, 0, 2};
    const Patches found = meet(kBall, {Mat3{1}, corner + Vec3{0.1_r, 0.2_r, 0.1_r}}, sheet);
    ASSERT_EQ(found.size(), 1U);
    expect_near(found[0].normal, glm::normalize(Vec3{0.1_r, 0.2_r, 0.1_r}), 1e-6);
}

TEST(ConvexMeshEdges, ABoxOverATablesEdgeRestsOnItsTop) {
    for (const Real overhang_m : {0.2_r, 0.49_r, 0.51_r, 0.8_r}) {
        for (const Real sunk_m : {-0.005_r, 0.0001_r, 0.003_r, 0.03_r}) {
            const MeshGeometry table = block({1, 0.4_r, 1}).mesh();
            const Vec3 center{0.5_r + overhang_m, 0.6_r - sunk_m, 0.1_r};
            const Patches found = meet(kBox, {Mat3{1}, center}, table);
            ASSERT_EQ(found.size(), 1U) << overhang_m << ' ' << sunk_m << text_of(found);
            expect_near(found[0].normal, {0, 1, 0}, 1e-6);
            ASSERT_EQ(found[0].count, 4U);
            for (std::size_t i = 0; i < 4; ++i) {
                const MeshPatchPoint& point = found[0].points[i];
                EXPECT_NEAR(point.distance_m, -sunk_m, kNear_m);
                EXPECT_NEAR(point.on_mesh.y, 0.4, kNear_m);
                EXPECT_NEAR(std::abs(point.on_mesh.z - 0.1_r), 0.3, kNear_m);
                const Real x = point.on_mesh.x;
                EXPECT_NEAR(std::min(std::abs(x - 1), std::abs(x - overhang_m)), 0, kNear_m);
            }
        }
    }
}

TEST(ConvexMeshEdges, AFinelyDividedTablesSideDoesNotPushWhatIsOnItsTop) {
    // Steps down in x = 0 by 1 m, in cells of 1 cm.
    Soup soup;
    for (int row = 0; row < 40; ++row) {
        const Real z = static_cast<Real>(row) * 0.05_r - 1;
        for (int i = 0; i < 100; ++i) {
            const Real a = static_cast<Real>(i) * 0.01_r;
            const Real b = a + 0.01_r;
            soup.add_quad({-b, 0, z}, {-b, 0, z + 0.05_r}, {-a, 0, z + 0.05_r}, {-a, 0, z});
            soup.add_quad({0, -a, z}, {0, -a, z + 0.05_r}, {0, -b, z + 0.05_r}, {0, -b, z});
        }
    }
    const MeshGeometry step = soup.mesh();
    for (const Real x : {-0.2_r, 0.1_r, 0.3_r}) {
        const Patches found = meet(kBox, {Mat3{1}, {x, 0.2_r - 0.035_r, 0.01_r}}, step);
        ASSERT_EQ(found.size(), 1U) << x << text_of(found);
        expect_near(found[0].normal, {0, 1, 0}, 1e-6);
        EXPECT_NEAR(deepest(found), -0.035, kNear_m);
    }
}

TEST(ConvexMeshEdges, ABoxOnARidgeTouchesItAlongALine) {
    const MeshGeometry roof = fold(-0.3_r).mesh();
    for (const Real lean : {0.0_r, 0.1_r, -0.2_r}) {
        for (const Real sunk_m : {-0.002_r, 0.004_r}) {
            const Mat3 rotation = turned({0, 0, 1}, lean);
            const Vec3 up = rotation[1];
            const Vec3 center = up * (0.2_r - sunk_m) + Vec3{0, 0, 0.1_r};
            const Patches found = meet(kBox, {rotation, center}, roof, {}, 0.003_r);
            ASSERT_EQ(found.size(), 1U) << lean << ' ' << sunk_m << text_of(found);
            expect_near(found[0].normal, up, 1e-6);
            Real low_z = 1;
            Real high_z = -1;
            for (std::size_t i = 0; i < found[0].count; ++i) {
                const MeshPatchPoint& point = found[0].points[i];
                EXPECT_NEAR(point.on_mesh.x, 0, 1e-5);
                EXPECT_NEAR(point.distance_m, -sunk_m, 1e-5);
                low_z = std::min(low_z, point.on_mesh.z);
                high_z = std::max(high_z, point.on_mesh.z);
            }
            EXPECT_NEAR(low_z, -0.2, 1e-5);
            EXPECT_NEAR(high_z, 0.4, 1e-5);
        }
    }
}

TEST(ConvexMeshEdges, ARodAcrossARidgeTouchesItOnce) {
    const MeshGeometry roof = fold(-0.3_r).mesh();
    const Mat3 across = turned({0, 0, 1}, kPi / 2 + 0.05_r);
    const Vec3 up = glm::normalize(Vec3{-across[1].y, across[1].x, 0});
    for (const Real sunk_m : {-0.002_r, 0.004_r}) {
        const Vec3 center = (up.y < 0 ? -up : up) * (0.1_r - sunk_m) + Vec3{0, 0, 0.1_r};
        const Patches found = meet(kRod, {across, center}, roof);
        ASSERT_EQ(found.size(), 1U);
        ASSERT_EQ(found[0].count, 1U);
        EXPECT_NEAR(found[0].points[0].distance_m, -sunk_m, 1e-5);
        expect_near(found[0].points[0].on_mesh, {0, 0, 0.1_r}, 1e-5);
    }
}

TEST(ConvexMeshEdges, ABoxInACornerOfARoomHasThreePatches) {
    const MeshGeometry room = block({2, 1, 2}).mesh();
    const Vec3 center{2 - 0.499_r, -1 + 0.198_r, 2 - 0.305_r};
    const Patches found = meet(kBox, {Mat3{1}, center}, room);
    ASSERT_EQ(found.size(), 3U);
    expect_near(found[0].normal, {0, 1, 0}, 1e-6);
    expect_near(found[1].normal, {-1, 0, 0}, 1e-6);
    expect_near(found[2].normal, {0, 0, -1}, 1e-6);
    for (const MeshPatch& patch : found) EXPECT_EQ(patch.count, 4U);
}

}  // namespace
}  // namespace plumbline::physics
