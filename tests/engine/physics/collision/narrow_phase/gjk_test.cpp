// Distances and penetrations that have closed forms, and the places where searches get stuck.
#include "engine/physics/collision/narrow_phase/gjk.h"

#include "engine/physics/collision/narrow_phase/epa.h"
#include "engine/physics/collision/narrow_phase/placed_convex.h"
#include "tests/engine/physics/collision/narrow_phase/convex_rig.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::physics {
namespace {

using namespace convex_rig;

const glm::dmat3 kNoTurn{1.0};
const double kFar_m = 100;
/// Sizes may be floats.
constexpr double kNear_m = 1e-7;

/// About z, by the angle.
glm::dmat3 turned(double angle_rad) {
    const double c = std::cos(angle_rad);
    const double s = std::sin(angle_rad);
    return {c, s, 0, -s, c, 0, 0, 0, 1};
}

double distance_m(const PlacedConvex& a, const PlacedConvex& b) {
    const auto found = separation_of(a, b, kFar_m);
    return found ? found->distance_m : kFar_m;
}

TEST(Gjk, SpheresAreApartByTheirCentres) {
    const Solid ball = sphere(0.5);
    const PlacedConvex here = placed(ball, kNoTurn, {0, 0, 0});
    for (const double far_m : {0.001, 0.4, 1.0, 3.0, 50.0}) {
        const PlacedConvex there = placed(ball, kNoTurn, {0, far_m * 0.6, far_m * 0.8});
        EXPECT_NEAR(distance_m(here, there), far_m - 1, 1e-12);
    }
}

TEST(Gjk, BoxesAreApartByFacesEdgesAndCorners) {
    const Solid cube = box({0.5, 0.5, 0.5});
    const PlacedConvex here = placed(cube, kNoTurn, {0, 0, 0});
    EXPECT_NEAR(distance_m(placed(cube, kNoTurn, {1.5, 0.2, 0.1}), here), 0.5, 1e-12);
    EXPECT_NEAR(distance_m(placed(cube, kNoTurn, {1.3, 1.4, 0.1}), here), 0.5, 1e-12);
    EXPECT_NEAR(distance_m(placed(cube, kNoTurn, {1.2, 1.3, 1.6}), here), 0.7, 1e-12);
    EXPECT_NEAR(distance_m(placed(cube, kNoTurn, {0.1, 0.9, 0.2}), here), -0.1, 1e-12);
    // On its edge: half the diagonal below its centre.
    const double lowest_m = std::sqrt(0.5);
    EXPECT_NEAR(distance_m(placed(cube, turned(std::atan(1.0)), {0.1, 1.5, 0.2}), here),
                1 - lowest_m,
                kNear_m);
}

TEST(Gjk, CapsulesAreApartByTheirAxes) {
    const Solid rod = capsule(0.2, 0.5);
    const PlacedConvex here = placed(rod, kNoTurn, {0, 0, 0});
    EXPECT_NEAR(distance_m(placed(rod, kNoTurn, {1, 0.3, 0}), here), 0.6, kNear_m) << "beside";
    EXPECT_NEAR(distance_m(placed(rod, kNoTurn, {0, 2, 0}), here), 0.6, kNear_m) << "above";
    EXPECT_NEAR(distance_m(placed(rod, kNoTurn, {0.3, 1.4, 0}), here), 0.1, kNear_m)
        << "end to end";
    const PlacedConvex across = placed(rod, turned(std::acos(0.0)), {0, 0.2, 0.3});
    EXPECT_NEAR(distance_m(across, here), -0.1, kNear_m) << "crossed";
}

TEST(Gjk, CylindersAndConesAreApartAsTheirOutlines) {
    const Solid drum = cylinder(0.5, 0.4);
    const Solid hat = cone(0.6, 0.4);
    const Solid point = sphere(1e-3);
    const auto from_drum = [&](const Vec3d& at) {
        return distance_m(placed(point, kNoTurn, at), placed(drum, kNoTurn, {0, 0, 0})) + 1e-3;
    };
    EXPECT_NEAR(from_drum({0, 1, 0}), 0.6, kNear_m);
    EXPECT_NEAR(from_drum({0.9, 0.1, 1.2}), 1, kNear_m);
    EXPECT_NEAR(from_drum({0.8, 0.8, 0}), 0.5, kNear_m) << "the rim";
    EXPECT_NEAR(from_drum({0.1, 0.3, 0.1}), -0.1, kNear_m) << "inside, under the cap";
    EXPECT_NEAR(from_drum({0.24, 0, 0.32}), -0.1, kNear_m) << "inside, by the side";
    const auto from_hat = [&](const Vec3d& at) {
        return distance_m(placed(point, kNoTurn, at), placed(hat, kNoTurn, {0, 0, 0})) + 1e-3;
    };
    EXPECT_NEAR(from_hat({0, 1, 0}), 0.6, kNear_m) << "the tip";
    EXPECT_NEAR(from_hat({0.1, -0.9, 0.2}), 0.5, kNear_m) << "the base";
    // Over the middle of the side, whose normal is (0.8, 0.6).
    EXPECT_NEAR(from_hat({0.3 + 0.8, 0.6, 0}), 1, kNear_m);
    EXPECT_NEAR(from_hat({0.3 - 0.08, -0.06, 0}), -0.1, kNear_m);
}

TEST(Gjk, APairFartherApartThanAskedForIsNone) {
    const Solid cube = box({0.5, 0.5, 0.5});
    const PlacedConvex here = placed(cube, kNoTurn, {0, 0, 0});
    const PlacedConvex there = placed(cube, turned(0.3), {2, 1, 0});
    const double apart_m = distance_m(here, there);
    EXPECT_TRUE(separation_of(here, there, apart_m + 1e-6));
    EXPECT_FALSE(separation_of(here, there, apart_m - 1e-6));
}

TEST(Epa, AxesThatCrossPartAcrossBoth) {
    const Solid rod = capsule(0.2, 0.5);
    const PlacedConvex here = placed(rod, kNoTurn, {0, 0, 0});
    const PlacedConvex across = placed(rod, turned(0.7), {0.01, 0.1, 0});
    const auto found = separation_of(across, here, kFar_m);
    EXPECT_NEAR(std::abs(found->normal.z), 1, 1e-12);
    EXPECT_NEAR(found->distance_m, -0.4, kNear_m);
}

TEST(Epa, TheDepthOfABallInACylinderIsThatToTheNearestSide) {
    const Solid ball = sphere(0.1);
    const Solid drum = cylinder(0.4, 0.5);
    const PlacedConvex here = placed(drum, kNoTurn, {0, 0, 0});
    Random random(3);
    for (int i = 0; i < 500; ++i) {
        const double ring = random.uniform(0, 0.39F);
        const double around_rad = random.uniform(0, 6.28F);
        const Vec3d at{ring * std::cos(around_rad),
                       random.uniform(-0.45F, 0.45F),
                       ring * std::sin(around_rad)};
        const double depth_m = std::min(0.4 - ring, 0.5 - std::abs(at.y));
        const double near_m = ring < 0.02 ? 1e-3 : 1e-6;
        ASSERT_NEAR(distance_m(placed(ball, kNoTurn, at), here), -depth_m - 0.1, near_m) << ring;
    }
}

/// Against the optimiser, over all kinds, deep in each other.
TEST(Epa, NoDirectionIsBetterHoweverDeep) {
    Random random(11);
    for (const Solid& one : catalogue()) {
        for (const Solid& other : catalogue()) {
            for (int i = 0; i < 8; ++i) {
                const Vec3d at =
                    random_direction(random) * static_cast<double>(random.uniform(0, 0.2F));
                const PlacedConvex a = placed(one, random_turn(random), at);
                const PlacedConvex b = placed(other, random_turn(random), {0, 0, 0});
                const auto found = separation_of(a, b, kFar_m);
                ASSERT_NEAR(gap_along(a, b, found->normal), found->distance_m, 1e-6);
                ASSERT_LE(widest_gap(a, b, 500, 6).gap_m, found->distance_m + 1e-6)
                    << one.name << " in " << other.name;
            }
        }
    }
}

/// Unit normal, no more than the sizes apart, and consistent with the gap along the normal.
void expect_sane(const PlacedConvex& a,
                 const PlacedConvex& b,
                 double scale_m,
                 const std::string& what) {
    const auto found = contact_of(a, b, kFar_m * scale_m);
    ASSERT_TRUE(found) << what;
    const Separation& separation = found->separation;
    ASSERT_NEAR(glm::length(separation.normal), 1, 1e-9) << what;
    ASSERT_NEAR(separation.distance_m, gap_along(a, b, separation.normal), 2e-6 * scale_m) << what;
    for (std::size_t i = 0; i < found->contact.count; ++i) {
        ASSERT_TRUE(is_finite(found->contact.points[i].on_a)) << what;
        ASSERT_TRUE(is_finite(found->contact.points[i].on_b)) << what;
    }
}

std::vector<Solid> odd_solids() {
    return {box({1e-3, 0.5, 1e-3}),
            box({0.5, 1e-3, 0.5}),
            cylinder(1e-3, 0.5),
            cylinder(0.5, 1e-3),
            cone(1e-3, 0.5),
            capsule(1e-3, 0.5),
            sphere(1e-3),
            sphere(500),
            box({500, 500, 500}),
            hull("needle", hull_rig::prism_corners(3, 1e-3, 0.5)),
            hull("ball of 64", hull_rig::sphere_corners(64, 0.5)),
            hull("pebble", hull_rig::sphere_corners(12, 5e-4))};
}

TEST(Robust, OddShapesInOddPlacesGiveFiniteContacts) {
    std::vector<Solid> solids = odd_solids();
    solids.insert(solids.end(), catalogue().begin(), catalogue().end());
    Random random(5);
    for (const Solid& one : solids) {
        for (const Solid& other : solids) {
            const double scale_m = std::max({1.0,
                                             static_cast<double>(one.shape.half_m.x),
                                             static_cast<double>(one.shape.radius_m),
                                             static_cast<double>(other.shape.half_m.x),
                                             static_cast<double>(other.shape.radius_m)});
            const std::string what = one.name + " and " + other.name;
            const PlacedConvex here = placed(other, kNoTurn, {0, 0, 0});
            expect_sane(
                placed(one, kNoTurn, {0, 0, 0}), here, scale_m, what + ", one in the other");
            expect_sane(placed(one, turned(1e-9), {1e-12, 0, 0}), here, scale_m, what + ", almost");
            for (int i = 0; i < 20; ++i) {
                const Vec3d at = random_direction(random) * static_cast<double>(random.uniform());
                expect_sane(placed(one, random_turn(random), at), here, scale_m, what);
            }
        }
    }
}

/// Whether every axis meets the surface where it reaches farthest along the axis.
bool is_even(const Solid& solid) {
    return solid.shape.kind != Kind::Cone &&
           (solid.shape.kind != Kind::Hull || solid.name == "octagonal prism");
}

TEST(Robust, WhatJustTouchesHasNoDistance) {
    const std::vector<Solid> solids = catalogue();
    Random random(6);
    for (const Solid& one : solids) {
        for (const Solid& other : solids) {
            // Along the axes: face on face, edge on edge, tip on face. Then any way.
            for (int i = 0; i < 12; ++i) {
                Vec3d direction{0, 0, 0};
                direction[i % 3] = i % 2 == 0 ? 1 : -1;
                if (i >= 6) direction = random_direction(random);
                PlacedConvex a = placed(one, kNoTurn, {0, 0, 0});
                PlacedConvex b = placed(other, kNoTurn, {0, 0, 0});
                if (i >= 6) a.axes = random_turn(random);
                a.center_m = direction * -gap_along(a, b, direction);
                const Direction touching = widest_gap(a, b, 200, 3);
                const auto found = separation_of(a, b, 1);
                ASSERT_TRUE(found);
                ASSERT_GE(found->distance_m, -1e-6) << one.name << " on " << other.name;
                ASSERT_GE(found->distance_m, touching.gap_m - 1e-6);
                if (i < 6 && is_even(one) && is_even(other)) {
                    ASSERT_NEAR(found->distance_m, 0, 1e-6) << one.name << " on " << other.name;
                }
                expect_sane(a, b, 1, one.name + " on " + other.name);
            }
        }
    }
}

TEST(Robust, TrianglesMeetEveryKind) {
    const std::vector<PlacedConvex> triangles{
        placed_triangle({Vec3d{-1, 0, -1}, Vec3d{-1, 0, 1}, Vec3d{1, 0, 0}}),
        placed_triangle({Vec3d{-100, 0, -1e-3}, Vec3d{-100, 0, 1e-3}, Vec3d{100, 0, 0}}),
        placed_triangle({Vec3d{-1, 0, 0}, Vec3d{0, 0, 0}, Vec3d{1, 0, 0}}),
        placed_triangle({Vec3d{-1e-3, 0, -1e-3}, Vec3d{-1e-3, 0, 1e-3}, Vec3d{1e-3, 0, 0}})};
    Random random(8);
    for (const PlacedConvex& triangle : triangles) {
        for (const Solid& solid : catalogue()) {
            PlacedConvex convex = placed(solid, kNoTurn, {0, 0, 0});
            expect_sane(convex, triangle, 1, solid.name + " through a triangle");
            convex.center_m = Vec3d{0, 0.01 + convex.radius_m, 0} - support(convex, {0, -1, 0});
            const auto found = contact_of(convex, triangle, 1);
            ASSERT_TRUE(found);
            EXPECT_NEAR(found->separation.distance_m, 0.01, 1e-6) << solid.name;
            EXPECT_NEAR(found->separation.normal.y, 1, 1e-6) << solid.name;
            for (int i = 0; i < 50; ++i) {
                convex.axes = random_turn(random);
                convex.center_m = random_direction(random) * static_cast<double>(random.uniform());
                expect_sane(convex, triangle, 100, solid.name + " by a triangle");
                expect_sane(triangle, convex, 100, "a triangle by " + solid.name);
            }
        }
        expect_sane(triangle, triangle, 1, "a triangle on itself");
    }
}

}  // namespace
}  // namespace plumbline::physics
