// Contacts of whole faces, caps and lines, as closed forms have them.
#include "engine/physics/collision/narrow_phase/contact_region.h"

#include "tests/engine/physics/collision/narrow_phase/convex_rig.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::physics {
namespace {

using namespace convex_rig;

const glm::dmat3 kUpright{1.0};
/// Its axis along x.
const glm::dmat3 kLying{0, 1, 0, -1, 0, 0, 0, 0, 1};
/// Its axis along z.
const glm::dmat3 kLyingAcross{1, 0, 0, 0, 0, 1, 0, -1, 0};
constexpr double kReach_m = 0.02;

glm::dmat3 about_y(double angle_rad) {
    const double c = std::cos(angle_rad);
    const double s = std::sin(angle_rad);
    return {c, 0, -s, 0, 1, 0, s, 0, c};
}

SurfaceContact contact_of(const PlacedConvex& a, const PlacedConvex& b) {
    const auto found = physics::contact_of(a, b, kReach_m);
    if (!found) return {};
    // The longer way has the same contact.
    const auto separation = separation_of(a, b, kReach_m);
    EXPECT_NEAR(separation->distance_m, found->separation.distance_m, 1e-6);
    return found->contact;
}

bool has_point(const SurfaceContact& contact, const Vec3d& on_b, double near_m = 2e-4) {
    for (std::size_t i = 0; i < contact.count; ++i) {
        if (glm::distance(contact.points[i].on_b, on_b) < near_m) return true;
    }
    return false;
}

/// Across y.
double area_of(std::span<const RegionPoint> points) {
    double most = 0;
    for (const RegionPoint& a : points) {
        for (const RegionPoint& b : points) {
            double above = 0;
            double below = 0;
            const Vec3d along = b.on_a - a.on_a;
            for (const RegionPoint& c : points) {
                const double side = glm::cross(along, c.on_a - a.on_a).y;
                above = std::max(above, side);
                below = std::max(below, -side);
            }
            most = std::max(most, (above + below) / 2);
        }
    }
    return most;
}

TEST(ContactRegion, AnUprightCylinderStandsOnFourPointsOfItsRim) {
    const Solid drum = cylinder(0.25, 0.5);
    const Solid table = box({1, 0.5, 1});
    const PlacedConvex below = placed(table, kUpright, {0, -0.5, 0});
    const SurfaceContact contact = contact_of(placed(drum, kUpright, {0.5, 0.499, 0.25}), below);
    ASSERT_EQ(contact.count, 4U);
    for (const Vec3d& out : {Vec3d{0.25, 0, 0}, {-0.25, 0, 0}, {0, 0, 0.25}, {0, 0, -0.25}})
        EXPECT_TRUE(has_point(contact, Vec3d{0.5, 0, 0.25} + out));
    EXPECT_NEAR(contact.points[0].distance_m, -0.001, 1e-7);
}

TEST(ContactRegion, ACylinderThatLeansALittleStandsOnTheSamePoints) {
    const Solid coin = cylinder(0.12, 0.02);
    const Solid table = box({1, 0.5, 1});
    const PlacedConvex below = placed(table, kUpright, {0, -0.5, 0});
    for (int heading = 0; heading < 12; ++heading) {
        const glm::dmat3 there = about_y(0.5236 * heading);
        const double lean_rad = 2e-3;
        const glm::dmat3 leaning{std::cos(lean_rad),
                                 std::sin(lean_rad),
                                 0,
                                 -std::sin(lean_rad),
                                 std::cos(lean_rad),
                                 0,
                                 0,
                                 0,
                                 1};
        const glm::dmat3 axes = there * leaning * glm::transpose(there);
        const SurfaceContact contact = contact_of(placed(coin, axes, {0, 0.0098, 0}), below);
        ASSERT_EQ(contact.count, 4U) << heading;
        for (const Vec3d& out : {Vec3d{0.12, 0, 0}, {-0.12, 0, 0}, {0, 0, 0.12}, {0, 0, -0.12}})
            EXPECT_TRUE(has_point(contact, out)) << heading;
    }
}

TEST(ContactRegion, ACylinderOverAnEdgeHasThePointsWhereItsRimCrosses) {
    const Solid drum = cylinder(0.25, 0.5);
    const Solid table = box({1, 0.5, 1});
    const PlacedConvex below = placed(table, kUpright, {0, -0.5, 0});
    const SurfaceContact contact = contact_of(placed(drum, kUpright, {0.9, 0.5, 0}), below);
    ASSERT_EQ(contact.count, 5U);
    const double across_m = std::sqrt(0.25 * 0.25 - 0.01);
    EXPECT_TRUE(has_point(contact, {1, 0, across_m}));
    EXPECT_TRUE(has_point(contact, {1, 0, -across_m}));
    EXPECT_TRUE(has_point(contact, {0.65, 0, 0}));
    for (std::size_t i = 0; i < contact.count; ++i) EXPECT_LE(contact.points[i].on_b.x, 1 + 1e-4);
}

TEST(ContactRegion, ADiscOnADiscHasTheTipsOfTheLens) {
    const Solid drum = cylinder(0.5, 0.5);
    const SurfaceContact contact =
        contact_of(placed(drum, kUpright, {0.6, 1, 0}), placed(drum, kUpright, {0, 0, 0}));
    ASSERT_EQ(contact.count, 4U);
    EXPECT_TRUE(has_point(contact, {0.3, 0.5, 0.4}));
    EXPECT_TRUE(has_point(contact, {0.3, 0.5, -0.4}));
    EXPECT_TRUE(has_point(contact, {0.1, 0.5, 0}));
    EXPECT_TRUE(has_point(contact, {0.5, 0.5, 0}));
}

TEST(ContactRegion, ALyingCylinderTouchesAlongALine) {
    const Solid drum = cylinder(0.25, 0.5);
    const Solid table = box({1, 0.5, 1});
    const SurfaceContact on_box =
        contact_of(placed(drum, kLying, {0, 0.25, 0.1}), placed(table, kUpright, {0, -0.5, 0}));
    ASSERT_EQ(on_box.count, 2U);
    EXPECT_TRUE(has_point(on_box, {0.5, 0, 0.1}));
    EXPECT_TRUE(has_point(on_box, {-0.5, 0, 0.1}));

    const PlacedConvex lower = placed(drum, kLying, {0, 0, 0});
    const SurfaceContact along = contact_of(placed(drum, kLying, {0.2, 0.5, 0}), lower);
    ASSERT_EQ(along.count, 2U);
    EXPECT_TRUE(has_point(along, {0.5, 0.25, 0}));
    EXPECT_TRUE(has_point(along, {-0.3, 0.25, 0}));

    const SurfaceContact across = contact_of(placed(drum, kLyingAcross, {0.2, 0.5, 0.1}), lower);
    ASSERT_EQ(across.count, 1U);
    EXPECT_TRUE(has_point(across, {0.2, 0.25, 0}));
}

TEST(ContactRegion, CapsulesTouchAlongALineOrInAPoint) {
    const Solid rod = capsule(0.1, 0.5);
    const PlacedConvex lower = placed(rod, kLying, {0, 0, 0});
    const SurfaceContact along = contact_of(placed(rod, kLying, {0.2, 0.2, 0}), lower);
    ASSERT_EQ(along.count, 2U);
    EXPECT_TRUE(has_point(along, {0.5, 0.1, 0}));
    EXPECT_TRUE(has_point(along, {-0.3, 0.1, 0}));
    const SurfaceContact across = contact_of(placed(rod, kLyingAcross, {0.2, 0.2, 0.1}), lower);
    ASSERT_EQ(across.count, 1U);
    EXPECT_TRUE(has_point(across, {0.2, 0.1, 0}));
    const SurfaceContact ends = contact_of(placed(rod, kLying, {1.2, 0, 0}), lower);
    ASSERT_EQ(ends.count, 1U);
    EXPECT_TRUE(has_point(ends, {0.6, 0, 0}));
    const SurfaceContact upright = contact_of(placed(rod, kUpright, {0.1, 0.7, 0}), lower);
    ASSERT_EQ(upright.count, 1U);
    EXPECT_TRUE(has_point(upright, {0.1, 0.1, 0}));
}

TEST(ContactRegion, AConeStandsOnItsBaseAndOnItsTip) {
    const Solid hat = cone(0.3, 0.4);
    const Solid table = box({1, 0.5, 1});
    const PlacedConvex below = placed(table, kUpright, {0, -0.5, 0});
    const SurfaceContact base = contact_of(placed(hat, kUpright, {0.1, 0.4, 0}), below);
    ASSERT_EQ(base.count, 4U);
    EXPECT_TRUE(has_point(base, {0.4, 0, 0}));
    EXPECT_TRUE(has_point(base, {0.1, 0, -0.3}));
    const glm::dmat3 over{1, 0, 0, 0, -1, 0, 0, 0, -1};
    const SurfaceContact tip = contact_of(placed(hat, over, {0.1, 0.4, 0}), below);
    ASSERT_EQ(tip.count, 1U);
    EXPECT_TRUE(has_point(tip, {0.1, 0, 0}));
}

TEST(ContactRegion, PrismsOffsetOverlapInTheirCommonPolygon) {
    const Solid block = hull("block", hull_rig::cube_corners({0.5, 0.5, 0.5}));
    const PlacedConvex lower = placed(block, kUpright, {0, 0, 0});
    const SurfaceContact contact = contact_of(placed(block, kUpright, {0.6, 1.001, -0.3}), lower);
    ASSERT_EQ(contact.count, 4U);
    for (const Vec3d& corner :
         {Vec3d{0.1, 0.5, 0.2}, {0.5, 0.5, 0.2}, {0.1, 0.5, -0.5}, {0.5, 0.5, -0.5}})
        EXPECT_TRUE(has_point(contact, corner));
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(contact.points[i].distance_m, 0.001, 1e-9);
}

using Polygon = std::vector<glm::dvec2>;

/// What of the polygon lies on the left of the line.
Polygon cut(const Polygon& polygon, const glm::dvec2& from, const glm::dvec2& to) {
    const auto side = [&](const glm::dvec2& p) {
        return (to.x - from.x) * (p.y - from.y) - (to.y - from.y) * (p.x - from.x);
    };
    Polygon left;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2& here = polygon[i];
        const glm::dvec2& next = polygon[(i + 1) % polygon.size()];
        if (side(here) >= 0) left.push_back(here);
        if (side(here) * side(next) < 0)
            left.push_back(here + (next - here) * (side(here) / (side(here) - side(next))));
    }
    return left;
}

double area_of(const Polygon& polygon) {
    double area = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2& next = polygon[(i + 1) % polygon.size()];
        area += polygon[i].x * next.y - polygon[i].y * next.x;
    }
    return std::abs(area) / 2;
}

/// Of points in any order that are corners of a convex polygon.
double area_of_hull(std::span<const RegionPoint> points) {
    Vec3d middle{0, 0, 0};
    for (const RegionPoint& p : points) middle += p.on_a / static_cast<double>(points.size());
    Polygon corners;
    for (const RegionPoint& p : points)
        corners.emplace_back(p.on_a.x - middle.x, p.on_a.z - middle.z);
    std::ranges::sort(corners, [](const glm::dvec2& a, const glm::dvec2& b) {
        return std::atan2(a.y, a.x) < std::atan2(b.y, b.x);
    });
    return area_of(corners);
}

Polygon seen_from_above(const Feature& feature) {
    Polygon polygon;
    for (std::size_t i = 0; i < feature.count; ++i)
        polygon.emplace_back(feature.corners[i].x, feature.corners[i].z);
    // Counter-clockwise as x and z go.
    double area = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2& next = polygon[(i + 1) % polygon.size()];
        area += polygon[i].x * next.y - polygon[i].y * next.x;
    }
    if (area < 0) std::ranges::reverse(polygon);
    return polygon;
}

TEST(ContactRegion, ItsAreaIsThatOfTheClippedPolygons) {
    std::vector<Solid> prisms;
    for (const int sides : {3, 4, 5, 8, 12, 24})
        prisms.push_back(hull("prism", hull_rig::prism_corners(sides, 0.5, 0.4)));
    Random random(4);
    double least_share = 1;
    for (int i = 0; i < 4000; ++i) {
        const Solid& one = prisms[random.below(6)];
        const Solid& other = prisms[random.below(6)];
        const Vec3d at{random.uniform(-0.5F, 0.5F), 0.8, random.uniform(-0.5F, 0.5F)};
        const PlacedConvex a = placed(one, about_y(random.uniform(0, 6.28F)), at);
        const PlacedConvex b = placed(other, about_y(random.uniform(0, 6.28F)), {0, 0, 0});
        Feature feature_a;
        Feature feature_b;
        find_feature(a, {0, -1, 0}, feature_a);
        find_feature(b, {0, 1, 0}, feature_b);
        Polygon common = seen_from_above(feature_a);
        const Polygon clip = seen_from_above(feature_b);
        for (std::size_t k = 0; k < clip.size(); ++k)
            common = cut(common, clip[k], clip[(k + 1) % clip.size()]);
        ContactRegion region(feature_a, feature_b, {0, 1, 0}, kReach_m, 1e-4);
        const double area = area_of_hull(region.points());
        ASSERT_NEAR(area, area_of(common), 3e-4) << one.shape.hull->corners_m.size();
        region.reduce(1e-4);
        ASSERT_LE(region.points().size(), 8U);
        if (area > 1e-3) least_share = std::min(least_share, area_of_hull(region.points()) / area);
    }
    EXPECT_GT(least_share, 0.78);
}

TEST(ContactRegion, ReducingKeepsTheDeepest) {
    const Solid prism = hull("prism", hull_rig::prism_corners(12, 0.5, 0.4));
    const Solid table = box({2, 0.5, 2});
    const PlacedConvex below = placed(table, kUpright, {0, -0.5, 0});
    Random random(2);
    for (int i = 0; i < 500; ++i) {
        const double lean_rad = random.uniform(0, 0.03F);
        const Vec3d axis{std::cos(i), 0, std::sin(i)};
        const glm::dmat3 leaning =
            glm::mat3_cast(Quatd{std::cos(lean_rad / 2), axis * std::sin(lean_rad / 2)});
        const PlacedConvex above = placed(prism, leaning, {0, 0.4, 0});
        const auto found = physics::contact_of(above, below, kReach_m);
        double least_m = kReach_m;
        for (std::size_t k = 0; k < found->contact.count; ++k)
            least_m = std::min(least_m, found->contact.points[k].distance_m);
        ASSERT_NEAR(least_m, found->separation.distance_m, 2e-4);
        ASSERT_NEAR(found->separation.distance_m, gap_along(above, below, {0, 1, 0}), 1e-6);
    }
}

/// The points of a body that rests, each time with noise in its pose.
TEST(ContactRegion, ABodyAtRestKeepsItsPoints) {
    const Solid table = box({2, 0.5, 2});
    const PlacedConvex floor = placed(table, kUpright, {0, -0.5, 0});
    for (const Solid& solid : {hull("octagon", hull_rig::prism_corners(8, 0.5, 0.4)),
                               hull("barrel", hull_rig::prism_corners(24, 0.5, 0.4)),
                               cylinder(0.5, 0.4)}) {
        const PlacedConvex lower = placed(solid, kUpright, {0, -0.4, 0});
        for (const PlacedConvex& below : {floor, lower}) {
            const PlacedConvex rest = placed(solid, about_y(0.3), {0, 0.4 - 1e-4, 0});
            const SurfaceContact wanted = physics::contact_of(rest, below, kReach_m)->contact;
            // Two rims that lie on each other also have the places of both.
            const bool one_rim = solid.name == "cylinder" && below.shape == floor.shape;
            ASSERT_EQ(wanted.count, one_rim ? 4U : 8U) << solid.name;
            EXPECT_GT(area_of({wanted.points.data(), wanted.count}), 0.4) << solid.name;
            Random random(7);
            int kept = 0;
            for (int i = 0; i < 200; ++i) {
                PlacedConvex moved = rest;
                moved.center_m += random_direction(random) * 1e-6;
                const Vec3d turn = random_direction(random) * 0.5e-6;
                moved.axes = glm::mat3_cast(Quatd{1, turn}) * rest.axes;
                const auto found = physics::contact_of(moved, below, kReach_m);
                int same = 0;
                for (std::size_t k = 0; k < found->contact.count; ++k)
                    same += has_point(wanted, found->contact.points[k].on_b, 1e-4) ? 1 : 0;
                const bool all = found->contact.count == wanted.count;
                kept += all && same == static_cast<int>(wanted.count) ? 1 : 0;
            }
            EXPECT_EQ(kept, 200) << solid.name
                                 << (below.shape == floor.shape ? " on a table" : " stacked");
        }
    }
}

}  // namespace
}  // namespace plumbline::physics
