#include "tests/engine/physics/collision/mesh/convex_mesh_fixture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace plumbline::physics {
namespace {

/// One patch, its normal `up`; its points on the plane through `foot`, and as far apart as said.
void expect_rests(const Patches& patches,
                  const Vec3& up,
                  const Vec3& foot,
                  std::size_t count,
                  double area_m2,
                  double distance_m) {
    ASSERT_EQ(patches.size(), 1U);
    const MeshPatch& patch = patches[0];
    expect_near(patch.normal, up, 1e-6);
    ASSERT_EQ(patch.count, count);
    Vec3 middle{0, 0, 0};
    for (std::size_t i = 0; i < count; ++i) {
        EXPECT_NEAR(glm::dot(patch.points[i].on_mesh - foot, up), 0, 2 * kNear_m);
        EXPECT_NEAR(patch.points[i].distance_m, distance_m, 2 * kNear_m);
        middle += patch.points[i].on_mesh / static_cast<Real>(count);
    }
    expect_near(middle, foot, 4 * kNear_m);
    if (count == 2) {
        EXPECT_NEAR(glm::distance(patch.points[0].on_mesh, patch.points[1].on_mesh), area_m2, 1e-5);
    }
    if (count < 4) return;
    // Of the polygon that they make round their middle.
    const Vec3 x = glm::normalize(patch.points[0].on_mesh - middle);
    const Vec3 y = glm::cross(up, x);
    std::vector<glm::dvec2> corners;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 away = patch.points[i].on_mesh - middle;
        corners.emplace_back(glm::dot(away, x), glm::dot(away, y));
    }
    std::ranges::sort(
        corners, {}, [](const glm::dvec2& corner) { return std::atan2(corner.y, corner.x); });
    double area = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec2& next = corners[(i + 1) % count];
        area += (corners[i].x * next.y - corners[i].y * next.x) / 2;
    }
    EXPECT_NEAR(area, area_m2, 1e-4 * area_m2);
}

struct MeshRest {
    const ConvexShape& shape;
    Mat3 rotation;  ///< before its yaw
    Real half_m;    ///< its centre's height
    std::size_t count;
    double span;  ///< of four points and more the area, of two the distance
};

/// Whatever a body's place over a flat mesh, it meets a plane.
void expect_a_plane(const MeshGeometry& mesh,
                    const Transform& world_from_mesh,
                    Real extent_m,
                    int trials) {
    const Octagon octagon;
    const Mat3 on_side = turned({1, 0, 0}, kPi / 2);
    const double inscribed = 2 * 0.3 * 0.3;
    const std::vector<MeshRest> all{
        {kBall, Mat3{1}, 0.25_r, 1, 0},
        {kBox, Mat3{1}, 0.2_r, 4, 0.6},
        {kRod, on_side, 0.1_r, 2, 0.8},
        {kRod, Mat3{1}, 0.5_r, 1, 0},
        {kDrum, Mat3{1}, 0.2_r, 4, inscribed},
        {kDrum, on_side, 0.3_r, 2, 0.4},
        {octagon.shape, Mat3{1}, Octagon::kHalf_m, 8, 2 * std::sqrt(2.0) * 0.4 * 0.4}};
    std::mt19937 random(3);
    std::uniform_real_distribution<Real> place(-extent_m, extent_m);
    std::uniform_real_distribution<Real> gap(-0.01_r, 0.01_r);
    std::uniform_real_distribution<Real> angle(0, 6);
    const Vec3 up = world_from_mesh.rotation[1];
    for (int trial = 0; trial < trials; ++trial) {
        for (const MeshRest& body : all) {
            const Real gap_m = gap(random);
            Vec3 foot{place(random), 0, place(random)};
            // Often over a seam or a corner.
            if (trial % 4 == 1) foot.x = std::round(foot.x);
            if (trial % 8 == 1) foot.z = std::round(foot.z);
            const Vec3 center = foot + Vec3{0, body.half_m + gap_m, 0};
            const Transform at{
                world_from_mesh.rotation * turned({0, 1, 0}, angle(random)) * body.rotation,
                world_from_mesh(center)};
            const Patches found = meet(body.shape, at, mesh, world_from_mesh);
            expect_rests(found,
                         up,
                         world_from_mesh(foot),
                         body.count,
                         body.span,
                         static_cast<double>(gap_m));
            if (testing::Test::HasFailure()) {
                ADD_FAILURE() << "kind " << static_cast<int>(body.shape.kind) << " trial " << trial;
                return;
            }
        }
    }
}

TEST(ConvexMesh, AFlatMeshIsAPlane) {
    expect_a_plane(flat_grid(8, 1).mesh(), {}, 3, 300);
}

TEST(ConvexMesh, FineCellsAreAPlaneToo) {
    expect_a_plane(flat_grid(120, 0.05_r).mesh(), {}, 2, 40);
}

TEST(ConvexMesh, ATurnedMeshIsAPlaneToo) {
    const Transform world_from_mesh{turned({1, 2, -1}, 0.8_r), {2, -1, 3}};
    expect_a_plane(flat_grid(8, 1).mesh(), world_from_mesh, 3, 100);
}

/// The distance of a point and a triangle, by trying its corners, edges and face.
double distance_to(const Vec3d& p, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    double least = std::numeric_limits<double>::max();
    const Vec3d normal = glm::normalize(glm::cross(b - a, c - a));
    bool over = true;
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
        const Vec3d along = to - from;
        const double t = std::clamp(glm::dot(p - from, along) / glm::dot(along, along), 0.0, 1.0);
        least = std::min(least, glm::distance(p, from + along * t));
        over = over && glm::dot(glm::cross(normal, along), p - from) >= 0;
    }
    return over ? std::min(least, std::abs(glm::dot(p - a, normal))) : least;
}

TEST(ConvexMesh, ABallIsAsFarAsTheNearestOfAllTriangles) {
    const Soup hills = grid(24, 0.2_r, [](Real x, Real z) {
        return 0.2_r * std::sin(3 * x) * std::cos(2 * z) + 0.05_r * std::sin(11 * x + 7 * z);
    });
    const MeshGeometry mesh = hills.mesh();
    std::mt19937 random(17);
    std::uniform_real_distribution<Real> place(-2, 2);
    std::uniform_real_distribution<Real> height(0.05_r, 0.5_r);
    int touching = 0;
    for (int trial = 0; trial < 1000; ++trial) {
        const Vec3 center{place(random), height(random), place(random)};
        double wanted = std::numeric_limits<double>::max();
        bool above = true;
        for (const auto& [a, b, c] : hills.triangles) {
            const Vec3d from{hills.corners[a]};
            const Vec3d second{hills.corners[b]};
            const Vec3d third{hills.corners[c]};
            const double here = distance_to(Vec3d(center), from, second, third);
            if (here < wanted) {
                wanted = here;
                above = glm::dot(glm::cross(second - from, third - from), Vec3d(center) - from) > 0;
            }
        }
        wanted -= 0.25;
        if (!above) continue;
        const Patches found = meet(kBall, {Mat3{1}, center}, mesh);
        if (wanted > 0.02) {
            EXPECT_TRUE(found.empty());
            continue;
        }
        ++touching;
        ASSERT_FALSE(found.empty()) << wanted;
        EXPECT_NEAR(deepest(found), wanted, 1e-6);
    }
    EXPECT_GT(touching, 100);
}

TEST(ConvexMesh, DoubledAndFlippedTrianglesAreNotFelt) {
    const Soup plain = flat_grid(8, 1);
    Soup doubled = plain;
    doubled.triangles.insert(
        doubled.triangles.end(), plain.triangles.begin(), plain.triangles.end());
    Soup two_fronts = plain;
    for (const auto& [a, b, c] : plain.triangles) two_fronts.triangles.push_back({a, c, b});
    Soup flipped = plain;
    for (std::size_t t = 0; t < flipped.triangles.size(); t += 3)
        std::swap(flipped.triangles[t][1], flipped.triangles[t][2]);
    for (const Soup* soup : {&doubled, &two_fronts, &flipped})
        expect_a_plane(soup->mesh(), {}, 3, 50);
}

TEST(ConvexMesh, ASheetIsTouchedFromBothSides) {
    const MeshGeometry sheet = flat_grid(8, 1).mesh();
    for (const Real sunk_m : {-0.01_r, 0.0_r, 0.001_r, 0.03_r}) {
        for (const Real side : {1.0_r, -1.0_r}) {
            for (const ConvexShape* shape : {&kBall, &kBox}) {
                const Real half_m = shape == &kBall ? 0.25_r : 0.2_r;
                const Patches found =
                    meet(*shape, {Mat3{1}, {0.3_r, side * (half_m - sunk_m), 0.2_r}}, sheet);
                ASSERT_EQ(found.size(), 1U);
                expect_near(found[0].normal, {0, side, 0}, 1e-6);
                EXPECT_NEAR(deepest(found), -sunk_m, kNear_m);
            }
        }
    }
}

TEST(ConvexMesh, WhatHasSunkInPastItsCentreComesOutInFront) {
    const MeshGeometry table = block({1, 0.5_r, 1}).mesh();
    const Patches ball = meet(kBall, {Mat3{1}, {0.2_r, 0.42_r, 0.1_r}}, table);
    ASSERT_EQ(ball.size(), 1U);
    expect_near(ball[0].normal, {0, 1, 0}, 1e-6);
    EXPECT_NEAR(deepest(ball), -0.33, kNear_m);
    const Patches box = meet(kBox, {Mat3{1}, {0.2_r, 0.45_r, 0.1_r}}, table);
    ASSERT_EQ(box.size(), 1U);
    expect_near(box[0].normal, {0, 1, 0}, 1e-6);
    EXPECT_NEAR(deepest(box), -0.25, kNear_m);
}

TEST(ConvexMesh, TrianglesOfTwentyKilometresAreExactNearABody) {
    Soup soup;
    soup.add_quad({-10000, 0, -10000}, {-10000, 0, 10000}, {10000, 0, 10000}, {10000, 0, -10000});
    const MeshGeometry mesh = soup.mesh();
    for (const Mat3& rotation : {Mat3{1}, turned({0, 1, 0}, 0.7_r)}) {
        for (const Real x : {0.0_r, 0.1_r, 3.0_r}) {
            const Transform ground{rotation, {0, 0, 0}};
            const Patches ball = meet(kBall, {Mat3{1}, {x, 0.249_r, 0.05_r}}, mesh, ground);
            expect_rests(ball, {0, 1, 0}, {x, 0, 0.05_r}, 1, 0, -0.001);
            const Patches box = meet(kBox, {Mat3{1}, {x, 0.199_r, 0.05_r}}, mesh, ground);
            expect_rests(box, {0, 1, 0}, {x, 0, 0.05_r}, 4, 0.6, -0.001);
        }
    }
    const Vec3 rim{10000, 0, 5};
    const Patches beside =
        meet(kBox, {turned({0, 0, 1}, kPi / 4), rim + Vec3{0.35_r, 0.34_r, 0}}, mesh);
    ASSERT_EQ(beside.size(), 1U);
    expect_near(beside[0].normal, {std::sqrt(0.5_r), std::sqrt(0.5_r), 0}, 1e-4);
}

TEST(ConvexMesh, AMarbleRollsThroughABowlWithoutSteps) {
    constexpr Real kBowl_m = 0.1_r;
    constexpr int kCells = 24;
    Soup bowl;
    const auto at = [](int ring, int place) {
        const Real down = static_cast<Real>(ring) * kPi / (2 * kCells);
        const Real round = static_cast<Real>(place % kCells) * 2 * kPi / kCells;
        return Vec3{kBowl_m * std::sin(down) * std::cos(round),
                    -kBowl_m * std::cos(down),
                    kBowl_m * std::sin(down) * std::sin(round)};
    };
    for (int ring = 0; ring < kCells; ++ring) {
        for (int place = 0; place < kCells; ++place)
            bowl.add_quad(
                at(ring, place), at(ring, place + 1), at(ring + 1, place + 1), at(ring + 1, place));
    }
    const MeshGeometry mesh = bowl.mesh();
    const ConvexShape marble{.kind = Kind::Sphere, .radius_m = 0.005_r};
    double before = 0;
    for (int step = -1000; step <= 1000; ++step) {
        const Real angle = static_cast<Real>(step) * 1.2_r / 1000;
        const Vec3 out{std::sin(angle) * 0.8_r, -std::cos(angle), std::sin(angle) * 0.6_r};
        const Vec3 center = glm::normalize(out) * 0.0945_r;
        const Patches found = meet(marble, {Mat3{1}, center}, mesh, {}, 0.002_r);
        ASSERT_FALSE(found.empty()) << step;
        const double here = deepest(found);
        // A facet's middle is nearer to the bowl's own centre than its corners.
        EXPECT_LE(here, 0.0006);
        EXPECT_GE(here, -0.0012);
        if (step > -1000) {
            EXPECT_NEAR(here, before, 5e-5) << step;
        }
        before = here;
        for (const MeshPatch& patch : found)
            EXPECT_GT(glm::dot(patch.normal, -glm::normalize(out)), 0.9_r);
    }
}

TEST(ConvexMesh, MovedTurnedAndMirroredWorldsGiveTheSame) {
    Soup hills =
        grid(16, 0.3_r, [](Real x, Real z) { return 0.3_r * std::sin(2 * x) * std::cos(3 * z); });
    const MeshGeometry mesh = hills.mesh();
    Soup other_way = hills;
    for (Vec3& corner : other_way.corners) corner.x = -corner.x;
    for (Triangle& triangle : other_way.triangles) std::swap(triangle[1], triangle[2]);
    const MeshGeometry mirrored = other_way.mesh();
    const Transform moved{turned({1, -1, 2}, 1.1_r), {5, -3, 2}};
    std::mt19937 random(23);
    std::uniform_real_distribution<Real> place(-2, 2);
    int touching = 0;
    for (int trial = 0; trial < 300; ++trial) {
        const ConvexShape& shape = trial % 2 == 0 ? kBall : kBox;
        const Vec3 axis{place(random), place(random), 2.5_r};
        const Real angle = place(random);
        const Transform at{turned(axis, angle),
                           {place(random), 0.5_r + 0.1_r * place(random), place(random)}};
        const Patches here = meet(shape, at, mesh);
        const Patches there =
            meet(shape, {moved.rotation * at.rotation, moved(at.position_m)}, mesh, moved);
        const Transform across{turned({axis.x, -axis.y, -axis.z}, angle),
                               {-at.position_m.x, at.position_m.y, at.position_m.z}};
        const Patches beyond = meet(shape, across, mirrored);
        ASSERT_EQ(here.size(), there.size()) << trial;
        ASSERT_EQ(here.size(), beyond.size()) << trial;
        if (here.empty()) continue;
        ++touching;
        EXPECT_NEAR(deepest(here), deepest(there), 1e-5);
        EXPECT_NEAR(deepest(here), deepest(beyond), 1e-5);
    }
    EXPECT_GT(touching, 50);
}

TEST(ConvexMesh, ABoxWithACornerInTheGroundIsNeverMissed) {
    constexpr Real kCell_m = 0.15_r;
    const MeshGeometry mesh =
        grid(30, kCell_m, [](Real x, Real z) {
            return 0.15_r * std::sin(4 * x) * std::cos(3 * z) + 0.05_r * std::sin(9 * x + 7 * z);
        }).mesh();
    const ConvexShape die{.kind = Kind::Box, .half_m = {0.2_r, 0.1_r, 0.15_r}};
    // Straight down onto the ground.
    const auto ground_m = [&mesh](const Vec3& above) {
        double height_m = -1;
        for (const MeshTriangle& triangle : mesh.triangles) {
            const Vec3d a = mesh.corner_m(triangle, 0);
            const Vec3d normal =
                glm::cross(mesh.corner_m(triangle, 1) - a, mesh.corner_m(triangle, 2) - a);
            const Vec3d p(above);
            const double y = a.y - (normal.x * (p.x - a.x) + normal.z * (p.z - a.z)) / normal.y;
            bool inside = true;
            for (std::size_t i = 0; i < 3; ++i) {
                const Vec3d from = mesh.corner_m(triangle, i);
                const Vec3d along = mesh.corner_m(triangle, (i + 1) % 3) - from;
                inside = inside && along.z * (p.x - from.x) - along.x * (p.z - from.z) >= 0;
            }
            if (inside) height_m = y;
        }
        return height_m;
    };
    std::mt19937 random(31);
    std::uniform_real_distribution<Real> along(-1, 1);
    for (int trial = 0; trial < 400; ++trial) {
        const Mat3 rotation =
            turned({along(random), along(random), along(random) + 1.1_r}, 3 * along(random));
        Transform at{rotation, {1.5_r * along(random), 0, 1.5_r * along(random)}};
        double sunk_m = -10;
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3 place = at(die.half_m * Vec3{(corner & 1) != 0 ? 1 : -1,
                                                    (corner & 2) != 0 ? 1 : -1,
                                                    (corner & 4) != 0 ? 1 : -1});
            sunk_m = std::max(sunk_m, ground_m(place) - static_cast<double>(place.y));
        }
        const Real wanted_m = 0.001_r + 0.02_r * std::abs(along(random));
        at.position_m.y += static_cast<Real>(sunk_m) - wanted_m;
        const Patches found = meet(die, at, mesh);
        ASSERT_FALSE(found.empty()) << trial;
        EXPECT_LT(deepest(found), -0.2 * static_cast<double>(wanted_m)) << trial << text_of(found);
        double most_up = -1;
        for (const MeshPatch& patch : found)
            most_up = std::max(most_up, static_cast<double>(patch.normal.y));
        EXPECT_GT(most_up, 0.3) << trial << text_of(found);
    }
}

TEST(ConvexMesh, NeedlesAndGrainsGiveNoNonsense) {
    std::mt19937 random(29);
    std::uniform_real_distribution<Real> along(-1, 1);
    const Octagon octagon;
    for (int trial = 0; trial < 300; ++trial) {
        Soup soup;
        for (int i = 0; i < 30; ++i) {
            const Vec3 a{along(random), 0.1_r * along(random), along(random)};
            const Vec3 b = a + Vec3{along(random), along(random), along(random)};
            const Vec3 out{along(random), along(random), along(random)};
            soup.add(a, b, a + out * 1e-3_r);
            soup.add(a, a + out * 1e-3_r, a + Vec3{out.y, out.z, out.x} * 1e-3_r);
        }
        const MeshGeometry mesh = soup.mesh();
        for (const ConvexShape* shape : {&kBall, &kBox, &kRod, &kDrum, &octagon.shape}) {
            const Mat3 rotation = turned({along(random), along(random), 1.5_r}, 3 * along(random));
            meet(*shape, {rotation, {along(random), 0.3_r * along(random), along(random)}}, mesh);
        }
    }
}

}  // namespace
}  // namespace plumbline::physics
