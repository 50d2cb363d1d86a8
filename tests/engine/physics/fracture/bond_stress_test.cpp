// Stress in a square section, 0.1 m wide, across x.
#include "engine/physics/fracture/bond_stress.h"

#include <gtest/gtest.h>

namespace plumbline::physics {
namespace {

constexpr double kHalf_m = 0.05;

FractureBond square() {
    const double moment_m4 = 16 * kHalf_m * kHalf_m * kHalf_m * kHalf_m / 12;
    return {.area_m2 = 4 * kHalf_m * kHalf_m,
            .distance_m = 0.1,
            .second_m4 = glm::dmat3{2 * moment_m4, 0, 0, 0, moment_m4, 0, 0, 0, moment_m4},
            .torsion_m3 = 0.208e-3,
            .corners_m = {{0, kHalf_m, kHalf_m},
                          {0, -kHalf_m, kHalf_m},
                          {0, -kHalf_m, -kHalf_m},
                          {0, kHalf_m, -kHalf_m}}};
}

TEST(BondStress, OfAPullIsTheTractionAndOfAPushNone) {
    EXPECT_DOUBLE_EQ(principal_Pa(square(), {100, 0, 0}, {0, 0, 0}, true), 100);
    EXPECT_DOUBLE_EQ(principal_Pa(square(), {-100, 0, 0}, {0, 0, 0}, true), 0);
}

TEST(BondStress, OfShearIsTheShear) {
    EXPECT_DOUBLE_EQ(principal_Pa(square(), {0, 30, 40}, {0, 0, 0}, true), 50);
}

// Bent about z, it is pulled at one side; pushed as much, nowhere.
TEST(BondStress, OfBendingIsThatAtTheRim) {
    EXPECT_NEAR(principal_Pa(square(), {0, 0, 0}, {0, 0, 200}, true), 200 * kHalf_m, 1e-12);
    EXPECT_NEAR(principal_Pa(square(), {-10, 0, 0}, {0, 0, 200}, true), 0, 1e-12);
}

// By itself it warps, 0.208 a3; as part of a larger one it turns with that.
TEST(BondStress, OfTwistIsByTheTorqueOrByTheTurn) {
    const FractureBond bond = square();
    const double torque_Nm = bond.second_m4[0][0] * 200;
    EXPECT_NEAR(principal_Pa(bond, {0, 0, 0}, {200, 0, 0}, true), torque_Nm / 0.208e-3, 1e-9);
    EXPECT_NEAR(principal_Pa(bond, {0, 0, 0}, {200, 0, 0}, false),
                200 * glm::length(bond.corners_m[0]),
                1e-9);
}

}  // namespace
}  // namespace plumbline::physics
