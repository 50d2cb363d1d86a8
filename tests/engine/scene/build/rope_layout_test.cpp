// Where pieces of ropes begin: of one length each, from anchor to anchor, in equilibrium where they hang.
#include "engine/scene/build/rope_layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace plumbline::scene {
namespace {

constexpr Vec3d kGravity_mps2{0, -9.81, 0};

RopeDescription rope_between(const Vec3& a, const Vec3& b, double length_m) {
    RopeDescription rope;
    rope.anchor_a_m = a;
    rope.anchor_b_m = b;
    rope.length_m = length_m;
    rope.mass_kg = 1;
    return rope;
}

double largest_unevenness_m(const RopeLayout& layout, double piece_m) {
    double largest = 0;
    for (std::size_t i = 1; i < layout.points_m.size(); ++i) {
        const double length_m = glm::distance(layout.points_m[i - 1], layout.points_m[i]);
        largest = std::max(largest, std::abs(length_m - piece_m));
    }
    return largest;
}

TEST(RopeLayout, ATautRopeIsStraight) {
    const RopeLayout layout = lay_rope(rope_between({0, 5, 0}, {3, 1, 0}, 5), 10, kGravity_mps2);
    ASSERT_EQ(layout.points_m.size(), 11U);
    EXPECT_NEAR(layout.piece_m, 0.5, 1e-12);
    EXPECT_LT(largest_unevenness_m(layout, 0.5), 1e-9);
    EXPECT_NEAR(glm::distance(layout.points_m[5], Vec3d{1.5, 3, 0}), 0, 1e-9);
}

// The chain's own equilibrium, which comes near the catenary as the square of the number of pieces.
TEST(RopeLayout, ASlackRopeHangsAsACatenary) {
    const double x = 1.4345;  // sinh x / x = 4 / 3, refined below
    double root = x;
    for (int i = 0; i < 50; ++i)
        root -= (std::sinh(root) / root - 4.0 / 3) /
                ((std::cosh(root) * root - std::sinh(root)) / (root * root));
    const double sag_m = 3 / (2 * root) * (std::cosh(root) - 1);
    std::array<double, 2> errors{};
    for (const int pieces : {20, 40}) {
        const RopeLayout layout =
            lay_rope(rope_between({0, 5, 0}, {3, 5, 0}, 4), pieces, kGravity_mps2);
        EXPECT_LT(largest_unevenness_m(layout, 4.0 / pieces), 1e-8);
        EXPECT_NEAR(glm::distance(layout.points_m.back(), Vec3d{3, 5, 0}), 0, 1e-8);
        errors[pieces == 20 ? 0 : 1] =
            std::abs(5 - layout.points_m[static_cast<std::size_t>(pieces / 2)].y - sag_m);
    }
    EXPECT_LT(errors[0], 0.002 * sag_m);
    EXPECT_NEAR(errors[0] / errors[1], 4, 0.2);
}

// Down, and sideways where the anchors are above each other or on one spot.
TEST(RopeLayout, AFoldedRopeReachesBothAnchors) {
    for (const double rise_m : {0.0, 0.5, -1.5, 1.99}) {
        for (const int pieces : {7, 20}) {
            const RopeLayout layout =
                lay_rope(rope_between({1, 5, 2}, {1, static_cast<Real>(5 + rise_m), 2}, 2),
                         pieces,
                         kGravity_mps2);
            EXPECT_LT(largest_unevenness_m(layout, 2.0 / pieces), 1e-6) << rise_m << " " << pieces;
            EXPECT_NEAR(glm::distance(layout.points_m.back(), Vec3d{1, 5 + rise_m, 2}), 0, 1e-6);
        }
    }
}

TEST(RopeLayout, APathIsWalkedInEqualSteps) {
    RopeDescription rope = rope_between({0, 0, 0}, {1, 1, 0}, 2);
    rope.path_m = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
    const RopeLayout layout = lay_rope(rope, 9, kGravity_mps2);
    const double first_m = glm::distance(layout.points_m[0], layout.points_m[1]);
    EXPECT_LT(largest_unevenness_m(layout, first_m), 1e-6);
    EXPECT_EQ(layout.points_m.back(), (Vec3d{1, 1, 0}));
}

// Each piece's y axis lies along it, and it is not twisted against the one before.
TEST(RopeLayout, PiecesLieAlongIt) {
    const RopeLayout layout = lay_rope(rope_between({0, 5, 0}, {3, 5, 0}, 4), 20, kGravity_mps2);
    const std::vector<Pose> pieces = layout.pieces();
    ASSERT_EQ(pieces.size(), 20U);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const Vec3d along = glm::normalize(layout.points_m[i + 1] - layout.points_m[i]);
        const Vec3d axis(pieces[i].orientation * Vec3{0, 1, 0});
        EXPECT_NEAR(glm::dot(along, axis), 1, 1e-5);
        const Vec3d side(pieces[i].orientation * Vec3{0, 0, 1});
        EXPECT_NEAR(std::abs(side.z), 1, 1e-5);  // the rope hangs in the plane z = 0
    }
}

}  // namespace
}  // namespace plumbline::scene
