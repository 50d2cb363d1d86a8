#include "engine/physics/collision/shape/mass.h"

#include "tests/engine/physics/bullet/shape/shape_rig.h"

#include <utility>

namespace plumbline::physics {
namespace {

TEST(ShapeMass, ClosedFormsOfPrimitives) {
    TestWorld test;
    const double tolerance = 50 * kRounding;
    expect_near(
        weigh(test, BoxShape{.size_m = {1, 2, 3}}, 12).inertia_kgm2, {13, 10, 5}, tolerance);
    expect_near(weigh(test, SphereShape{.radius_m = 2}, 5).inertia_kgm2, {8, 8, 8}, tolerance);
    expect_near(weigh(test, CylinderShape{.radius_m = 1, .height_m = 3}, 4).inertia_kgm2,
                {4, 2, 4},
                tolerance);
    const MassProperties cone = weigh(test, ConeShape{.radius_m = 1, .height_m = 2}, 10);
    expect_near(cone.inertia_kgm2, {3, 3, 3}, tolerance);
    expect_near(cone.center_of_mass_m, {0, -0.5, 0}, tolerance);
}

TEST(ShapeMass, CapsuleIsACylinderAndTwoHalfBalls) {
    TestWorld test;
    const double r = 0.5;
    const double h = 2.0;
    const double barrel = kPiD * r * r * h;
    const double half = 2.0 / 3.0 * kPiD * r * r * r;
    const double share = 7.0 / (barrel + 2 * half);
    // A half ball about its own centre: 83/320 m r^2 across, at h/2 + 3r/8.
    const double offset = 0.5 * h + 0.375 * r;
    const double across =
        barrel * (3 * r * r + h * h) / 12 + 2 * half * (83.0 / 320.0 * r * r + offset * offset);
    const double along = 0.5 * barrel * r * r + 2 * half * 0.4 * r * r;
    expect_near(weigh(test, CapsuleShape{.radius_m = 0.5_r, .height_m = 2}, 7).inertia_kgm2,
                {share * across, share * along, share * across},
                50 * kRounding);
}

TEST(ShapeMass, TetrahedronByItsClosedForm) {
    TestWorld test;
    // Corner at the origin, legs 1: centre 1/4 each; about it Ixx = m (3/80 + 3/80), Ixy = m/80.
    const MassProperties mass =
        weigh(test, HullShape{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, 80);
    expect_near(mass.center_of_mass_m, {0.25, 0.25, 0.25}, 50 * kRounding);
    Vec3d moments{mass.inertia_kgm2};
    if (moments.x > moments.y) std::swap(moments.x, moments.y);
    if (moments.y > moments.z) std::swap(moments.y, moments.z);
    if (moments.x > moments.y) std::swap(moments.x, moments.y);
    // 6 on the diagonal, 1 beside it: 5 + 1 * {0, 0, 3}... or 7, 7, 4 when the sign is negative.
    const double sum = moments.x + moments.y + moments.z;
    EXPECT_NEAR(sum, 18.0, 1e-3);
    EXPECT_NEAR(moments.y * moments.z * moments.x, 5.0 * 5.0 * 8.0, 0.01);
}

TEST(ShapeMass, PlatesAreThinnerThanASixthOfTheirWidth) {
    const auto is_box_a_plate = [](const Vec3& size_m) {
        TestWorld test;
        return is_plate(Vec3d(weigh(test, BoxShape{size_m}, 3).inertia_kgm2));
    };
    EXPECT_TRUE(is_box_a_plate({1, 0.16_r, 1}));
    EXPECT_FALSE(is_box_a_plate({1, 0.17_r, 1}));
    EXPECT_TRUE(is_box_a_plate({0.01_r, 0.1_r, 5}));
    EXPECT_FALSE(is_box_a_plate({0.1_r, 0.1_r, 5})) << "a rod";
    EXPECT_FALSE(is_box_a_plate({1, 1, 1}));
}

}  // namespace
}  // namespace plumbline::physics
