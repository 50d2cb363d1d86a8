#include "engine/physics/collision/narrow_phase/box_box.h"

#include "engine/core/random.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace plumbline::physics {
namespace {

constexpr Real kBoxNear = sizeof(Real) == sizeof(float) ? 2e-6_r : 1e-12_r;

OrientedBox box_at(const Vec3& center, const Vec3& half_m, const Quat& turn = kNoRotation) {
    return {.center = center, .axes = glm::mat3_cast(turn), .half_m = half_m};
}
Quat about(const Vec3& axis, Real angle_deg) {
    return glm::angleAxis(radians_from_degrees(angle_deg), glm::normalize(axis));
}
Real widest(const BoxContact& contact, int axis) {
    Real low = 1e9_r;
    Real high = -1e9_r;
    for (int i = 0; i < contact.count; ++i) {
        low = std::min(low, contact.on_b[static_cast<std::size_t>(i)][axis]);
        high = std::max(high, contact.on_b[static_cast<std::size_t>(i)][axis]);
    }
    return high - low;
}

TEST(BoxBox, FacesMeetAtTheCornersOfTheirOverlap) {
    const OrientedBox floor = box_at({0, -1, 0}, {5, 1, 5});
    for (const Real gap : {0.01_r, 0.0_r, -0.02_r}) {
        const BoxContact contact =
            collide_boxes(box_at({1, 0.5_r + gap, 4.75_r}, {1, 0.5_r, 0.5_r}), floor, 0.05_r);
        ASSERT_EQ(contact.count, 4);
        EXPECT_EQ(contact.normal, (Vec3{0, 1, 0}));
        // 2 m by 0.75 m: the rest hangs over.
        EXPECT_NEAR(widest(contact, 0), 2, kBoxNear);
        EXPECT_NEAR(widest(contact, 2), 0.75_r, kBoxNear);
        for (std::size_t i = 0; i < 4; ++i) {
            EXPECT_NEAR(contact.distance_m[i], gap, kBoxNear);
            EXPECT_NEAR(contact.on_b[i].y, 0, kBoxNear);
        }
    }
}

TEST(BoxBox, FartherThanTheReachIsNoContact) {
    const OrientedBox a = box_at({0, 1.02_r, 0}, {0.5_r, 0.5_r, 0.5_r});
    const OrientedBox b = box_at({0, 0, 0}, {0.5_r, 0.5_r, 0.5_r});
    EXPECT_EQ(collide_boxes(a, b, 0.01_r).count, 0);
    EXPECT_EQ(collide_boxes(a, b, 0.03_r).count, 4);
}

TEST(BoxBox, OfEightCornersFourSpanTheOctagon) {
    const BoxContact contact =
        collide_boxes(box_at({0, 0.99_r, 0}, {0.5_r, 0.5_r, 0.5_r}, about({0, 1, 0}, 45)),
                      box_at({0, 0, 0}, {0.5_r, 0.5_r, 0.5_r}),
                      0.1_r);
    ASSERT_EQ(contact.count, 4);
    // The octagon's largest quadrilateral is a square over its circle of radius 0.5 / cos 22.5.
    Real area = 0;
    const std::array<std::size_t, 4> round{0, 2, 1, 3};
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec3& p = contact.on_b[round[i]];
        const Vec3& q = contact.on_b[round[(i + 1) % 4]];
        area += (p.x * q.z - p.z * q.x) / 2;
        EXPECT_NEAR(contact.distance_m[i], -0.01_r, kBoxNear);
    }
    const Real radius = 0.5_r / std::cos(kPi / 8);
    EXPECT_GT(std::abs(area), 0.9_r * 2 * radius * radius);
}

TEST(BoxBox, CrossedEdgesMeetInOnePoint) {
    // A bar along x on its edge over one along z on its edge: sqrt(1/2) from middle to edge.
    const Real edge = std::sqrt(0.5_r);
    const OrientedBox upper =
        box_at({0.3_r, 2 * edge - 0.03_r, -0.2_r}, {3, 0.5_r, 0.5_r}, about({1, 0, 0}, 45));
    const OrientedBox lower = box_at({-0.1_r, 0, 0.4_r}, {0.5_r, 0.5_r, 3}, about({0, 0, 1}, 45));
    const BoxContact contact = collide_boxes(upper, lower, 0.1_r);
    ASSERT_EQ(contact.count, 1);
    EXPECT_NEAR(contact.normal.y, 1, kBoxNear);
    EXPECT_NEAR(contact.distance_m[0], -0.03_r, 4 * kBoxNear);
    // Over the lower's upper edge, under the upper's lower one.
    EXPECT_NEAR(contact.on_b[0].x, -0.1_r, 4 * kBoxNear);
    EXPECT_NEAR(contact.on_b[0].y, edge, 4 * kBoxNear);
    EXPECT_NEAR(contact.on_b[0].z, -0.2_r, 4 * kBoxNear);
}

TEST(BoxBox, CrossedPlatesThatTiltALittleMeetByFaces) {
    // The lower one's highest edge and the upper one's lowest cross where both tilt.
    const auto crossed = [](Real tilt_deg) {
        const OrientedBox lower =
            box_at({0, 0, 0}, {2, 0.05_r, 0.5_r}, about({1, 0, 0}, -tilt_deg));
        const Real lift_m = 0.5_r * std::sin(radians_from_degrees(tilt_deg));
        return collide_boxes(
            box_at({0, 0.095_r + 2 * lift_m, 0}, {0.5_r, 0.05_r, 2}, about({0, 0, 1}, tilt_deg)),
            lower,
            0.3_r);
    };
    for (const Real tilt_deg : {1.0_r, 3.0_r, 5.0_r})
        EXPECT_GT(crossed(tilt_deg).count, 1) << tilt_deg;
    EXPECT_EQ(crossed(12).count, 1);
}

TEST(BoxBox, ACornerOverAFaceIsOnePoint) {
    const Quat on_corner = about({1, 0, -1}, degrees_from_radians(std::acos(1 / std::sqrt(3.0_r))));
    const Real height = std::sqrt(0.75_r);
    const BoxContact contact =
        collide_boxes(box_at({0, height + 0.02_r, 0}, {0.5_r, 0.5_r, 0.5_r}, on_corner),
                      box_at({0, -1, 0}, {5, 1, 5}),
                      0.03_r);
    ASSERT_EQ(contact.count, 1);
    EXPECT_EQ(contact.normal, (Vec3{0, 1, 0}));
    EXPECT_NEAR(contact.distance_m[0], 0.02_r, 4 * kBoxNear);
    EXPECT_NEAR(contact.on_b[0].x, 0, 4 * kBoxNear);
    EXPECT_NEAR(contact.on_b[0].z, 0, 4 * kBoxNear);
}

/// Of the deepest point.
Real depth_of(const BoxContact& contact) {
    Real least = 1e9_r;
    for (int i = 0; i < contact.count; ++i)
        least = std::min(least, contact.distance_m[static_cast<std::size_t>(i)]);
    return least;
}

TEST(BoxBox, TheOtherWayRoundTheNormalIsTurnedAndTheDepthIsTheSame) {
    Random random(11);
    int met = 0;
    for (int i = 0; i < 500; ++i) {
        const auto any = [&](Real size) {
            return Vec3{random.uniform(-1.0F, 1.0F) * size,
                        random.uniform(-1.0F, 1.0F) * size,
                        random.uniform(-1.0F, 1.0F) * size};
        };
        const OrientedBox a =
            box_at(any(1.2_r), {0.5_r, 0.3_r, 0.7_r}, about(any(1) + Vec3{0.01_r}, 77));
        const OrientedBox b = box_at(any(0.1_r), {0.6_r, 0.4_r, 0.5_r}, about(any(1), 131));
        const BoxContact ab = collide_boxes(a, b, 0.05_r);
        const BoxContact ba = collide_boxes(b, a, 0.05_r);
        ASSERT_EQ(ab.count > 0, ba.count > 0) << i;
        if (ab.count == 0) continue;
        ++met;
        EXPECT_NEAR(depth_of(ab), depth_of(ba), 5e-3_r) << i;
        EXPECT_LE(ab.count, 4);
    }
    EXPECT_GT(met, 100);
}

TEST(BoxBox, FarFromTheOriginIsAsNear) {
    const Vec3 far{1000, -500, 2000};
    const OrientedBox a = box_at({0, 0.99_r, 0}, {0.5_r, 0.5_r, 0.5_r});
    const OrientedBox b = box_at({0, 0, 0}, {0.5_r, 0.5_r, 0.5_r});
    OrientedBox far_a = a;
    OrientedBox far_b = b;
    far_a.center += far;
    far_b.center += far;
    const Real gap = (far_a.center - far_b.center).y - 1;
    const BoxContact contact = collide_boxes(far_a, far_b, 0.1_r);
    ASSERT_EQ(contact.count, 4);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(contact.distance_m[i], gap, kBoxNear);
}

}  // namespace
}  // namespace plumbline::physics
