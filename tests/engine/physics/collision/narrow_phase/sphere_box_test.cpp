#include "engine/physics/collision/narrow_phase/sphere_box.h"

#include "engine/core/random.h"

#include <gtest/gtest.h>

namespace plumbline::physics {
namespace {

constexpr Real kBallNear = sizeof(Real) == sizeof(float) ? 1e-6_r : 1e-13_r;
const OrientedBox kBox{.center = {1, 2, 3}, .half_m = {0.5_r, 1, 1.5_r}};

TEST(BallBox, FaceEdgeAndCorner) {
    const SphereContact face = collide_sphere_box({1.2_r, 3.3_r, 2}, 0.2_r, kBox);
    EXPECT_EQ(face.normal, (Vec3{0, 1, 0}));
    EXPECT_NEAR(face.distance_m, 0.1_r, kBallNear);
    const SphereContact edge = collide_sphere_box({1.8_r, 3.4_r, 3}, 0.2_r, kBox);
    EXPECT_NEAR(edge.distance_m, 0.5_r - 0.2_r, kBallNear);
    EXPECT_NEAR(glm::distance(edge.normal, Vec3{0.6_r, 0.8_r, 0}), 0, kBallNear);
    EXPECT_NEAR(glm::distance(edge.on_box, Vec3{1.5_r, 3, 3}), 0, kBallNear);
    const SphereContact corner = collide_sphere_box({1.5_r + 2, 3 + 3, 4.5_r + 6}, 1, kBox);
    EXPECT_NEAR(corner.distance_m, 6, 10 * kBallNear);
}

TEST(BallBox, ACentreInsideComesOutAtTheNearestFace) {
    const SphereContact contact = collide_sphere_box({0.6_r, 2, 3}, 0.25_r, kBox);
    EXPECT_EQ(contact.normal, (Vec3{-1, 0, 0}));
    EXPECT_NEAR(contact.distance_m, -0.1_r - 0.25_r, kBallNear);
    EXPECT_NEAR(contact.on_box.x, 0.5_r, kBallNear);
}

TEST(BallBox, TurnsWithTheBox) {
    OrientedBox turned = kBox;
    const Quat turn = glm::angleAxis(1.1_r, glm::normalize(Vec3{1, -2, 0.5_r}));
    turned.axes = glm::mat3_cast(turn);
    const Vec3 away{0.9_r, 1.3_r, -0.4_r};
    const SphereContact straight = collide_sphere_box(kBox.center + away, 0.2_r, kBox);
    const SphereContact other = collide_sphere_box(turned.center + turn * away, 0.2_r, turned);
    EXPECT_NEAR(other.distance_m, straight.distance_m, 4 * kBallNear);
    EXPECT_NEAR(glm::distance(other.normal, turn * straight.normal), 0, 4 * kBallNear);
}

TEST(NearestOnSegment, IsAsNearAsAnyPlaceTried) {
    Random random(5);
    for (int i = 0; i < 200; ++i) {
        const auto any = [&] {
            return kBox.center + Vec3{random.uniform(-3.0F, 3.0F),
                                      random.uniform(-3.0F, 3.0F),
                                      random.uniform(-3.0F, 3.0F)};
        };
        const Vec3 from = any();
        const Vec3 to = any();
        const auto distance_m = [&](Real at) {
            return collide_sphere_box(from + (to - from) * at, 0, kBox).distance_m;
        };
        const Real found = distance_m(nearest_on_segment(from, to, kBox));
        for (int k = 0; k <= 100; ++k)
            EXPECT_LE(found, distance_m(static_cast<Real>(k) / 100) + 1e-4_r) << i;
    }
}

TEST(SegmentOverBox, EndsAtTheEdgesOfTheFace) {
    // Above the top, from the middle to 2 m beyond the edge at z = 4.5.
    const Vec3 from{1, 3.2_r, 3};
    const Vec3 to{1, 3.2_r, 6.5_r};
    const SegmentPart held = part_over_face(from, to, 0.1_r, kBox);
    EXPECT_EQ(held.from, 0);
    EXPECT_NEAR(held.to, 1.5_r / 3.5_r, kBallNear);
    const SegmentPart back = part_over_face(to, from, 0.9_r, kBox);
    EXPECT_NEAR(back.from, 2 / 3.5_r, kBallNear);
    EXPECT_EQ(back.to, 1);
    const SegmentPart across = part_over_face({-1, 3.2_r, 3}, {3, 3.2_r, 3}, 0.5_r, kBox);
    EXPECT_NEAR(across.from, 1.5_r / 4, kBallNear);
    EXPECT_NEAR(across.to, 2.5_r / 4, kBallNear);
}

TEST(SegmentOverBox, IsWholeWhereAnEdgeOrACornerIsNearest) {
    for (const Vec3& beside : {Vec3{1.9_r, 0, 0}, Vec3{1.9_r, 0, 3}}) {
        const Vec3 from = Vec3{1, 3.3_r, 3} + beside;
        const SegmentPart whole = part_over_face(from, from + Vec3{0.1_r, 0.2_r, 0.4_r}, 0, kBox);
        EXPECT_EQ(whole.from, 0);
        EXPECT_EQ(whole.to, 1);
    }
}

}  // namespace
}  // namespace plumbline::physics
