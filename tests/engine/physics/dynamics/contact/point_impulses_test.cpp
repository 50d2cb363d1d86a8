#include "engine/physics/dynamics/contact/point_impulses.h"

#include "engine/core/random.h"

#include <gtest/gtest.h>

namespace plumbline::physics {
namespace {

/// Four corners of a plate of 1 kg and 1 m: what an impulse at one does to the others' speeds.
ContactConstraint plate() {
    constexpr Real kCorner[4][2] = {
        {-0.5_r, -0.5_r}, {0.5_r, -0.5_r}, {0.5_r, 0.5_r}, {-0.5_r, 0.5_r}};
    constexpr Real kMoment_kgm2 = 1.0_r / 12;
    ContactConstraint constraint;
    constraint.count = 4;
    for (std::size_t i = 0; i < kLanes; ++i) {
        for (std::size_t k = 0; k < kLanes; ++k) {
            constraint.response[i][k] =
                1 + (kCorner[i][0] * kCorner[k][0] + kCorner[i][1] * kCorner[k][1]) / kMoment_kgm2;
        }
    }
    return constraint;
}

/// What is left of the closing speeds, m/s, once `next` acts instead of the constraint's impulses.
Lanes residual_of(const ContactConstraint& constraint, const Lanes& wanted, const Lanes& next) {
    Lanes left = wanted;
    for (std::size_t i = 0; i < kLanes; ++i) {
        for (std::size_t k = 0; k < kLanes; ++k)
            left[k] += constraint.response[i][k] * (next[i] - constraint.normal_Ns[i]);
    }
    return left;
}

TEST(PointImpulses, DirectTakesAllOfTheErrorAway) {
    LaneMatrix mass{};
    for (std::size_t i = 0; i < kLanes; ++i) mass[i][i] = static_cast<Real>(i + 1);
    const Lanes next = direct(splat(1), mass, Lanes{-1, 0, 1, -2});
    EXPECT_FALSE(any(next != Lanes{2, 1, -2, 9}));
}

TEST(PointImpulses, OnePointStopsItsOwnSpeedAndNeverPulls) {
    ContactConstraint constraint;
    constraint.count = 1;
    constraint.response[0][0] = 4;
    constraint.normal_Ns[0] = 0.5_r;
    EXPECT_EQ(projected(constraint, Lanes{-2, 0, 0, 0}, Lanes{})[0], 1);
    EXPECT_EQ(projected(constraint, Lanes{8, 0, 0, 0}, Lanes{})[0], 0);
    // Soft: A*change + wanted + compliance*impulse = 0.
    EXPECT_NEAR(projected(constraint, Lanes{-2, 0, 0, 0}, Lanes{4, 0, 0, 0})[0], 0.5, 1e-6);
}

TEST(PointImpulses, APlateThatFallsFlatIsStoppedByItsMomentum) {
    const ContactConstraint constraint = plate();
    const Lanes wanted = Lanes{-3, -3, -3, -3};
    const Lanes next = projected(constraint, wanted, Lanes{});
    EXPECT_NEAR(sum_of(next), 3, 6e-3);  // m v; four sweeps leave less than a 500th
    const Lanes left = residual_of(constraint, wanted, next);
    for (int i = 0; i < kLanes; ++i) EXPECT_NEAR(left[i], 0, 0.02);
}

TEST(PointImpulses, PointsThatPartPressNothingAndTheRestAreStopped) {
    const ContactConstraint constraint = plate();
    const Lanes wanted = Lanes{-1, -1, 5, 5};  // tips onto one edge
    const Lanes next = projected(constraint, wanted, Lanes{});
    EXPECT_EQ(next[2], 0);
    EXPECT_EQ(next[3], 0);
    const Lanes left = residual_of(constraint, wanted, next);
    EXPECT_NEAR(left[0], 0, 0.01);
    EXPECT_NEAR(left[1], 0, 0.01);
}

TEST(PointImpulses, OfTwoPointsNeitherPullsNorClosesAndOnlyWhatDoesNotPartPresses) {
    Random random{11};
    for (int round = 0; round < 2000; ++round) {
        ContactConstraint constraint = plate();
        constraint.count = 2;
        constraint.response[0][1] = constraint.response[1][0] = random.uniform(-6.9F, 6.9F);
        Lanes wanted{};
        Lanes compliance{};
        for (int i = 0; i < 2; ++i) {
            wanted[i] = random.uniform(-1.0F, 1.0F);
            compliance[i] = random.uniform(0.0F, 2.0F);
            constraint.normal_Ns[i] = random.uniform(0.0F, 0.2F);
        }
        Lanes left = wanted;
        for (int call = 0; call < 5; ++call) {  // a little less than all the first time
            const Lanes next = projected(constraint, left, compliance);
            left = residual_of(constraint, left, next);
            constraint.normal_Ns = next;
        }
        const Lanes next = constraint.normal_Ns;
        left += compliance * next;
        for (int i = 0; i < 2; ++i) {
            EXPECT_GE(next[i], 0);
            EXPECT_GE(left[i], -2e-5) << round;
            EXPECT_NEAR(left[i] * next[i], 0, 2e-5) << round;
        }
        EXPECT_EQ(next[2], 0);
        EXPECT_EQ(next[3], 0);
    }
}

TEST(PointImpulses, CallsOneAfterAnotherComeToPointsThatPressOrPart) {
    Random random{7};
    for (int round = 0; round < 200; ++round) {
        ContactConstraint constraint = plate();
        Lanes wanted;
        for (std::size_t i = 0; i < kLanes; ++i) {
            wanted[i] = random.uniform(-1.0F, 1.0F);
            constraint.normal_Ns[i] = random.uniform(0.0F, 0.2F);
        }
        for (int call = 0; call < 50; ++call) {
            const Lanes next = projected(constraint, wanted, Lanes{});
            wanted = residual_of(constraint, wanted, next);
            constraint.normal_Ns = next;
        }
        for (std::size_t i = 0; i < kLanes; ++i) {
            EXPECT_GE(constraint.normal_Ns[i], 0);
            EXPECT_GE(wanted[i], -1e-4) << round;
            EXPECT_NEAR(wanted[i] * constraint.normal_Ns[i], 0, 1e-5) << round;
        }
    }
}

}  // namespace
}  // namespace plumbline::physics
