// Into how many parts an island's step is cut.
#include "engine/physics/dynamics/part_choice.h"

#include "engine/physics/dynamics/island.h"
#include "engine/physics/world/body_record.h"

#include <gtest/gtest.h>

#include <vector>

namespace plumbline::physics {
namespace {

constexpr double kStep_s = 1.0 / 60;

/// A body that touches the ground below its centre.
struct Standing {
    explicit Standing(ConvexShape::Kind kind, std::size_t bodies = 1) {
        geometry->parts.resize(1);
        for (BodyRecord* record : {&body, &ground}) {
            record->traits.geometry = geometry;
            record->in_world = true;
        }
        body.kind = BodyKind::Dynamic;
        body.motion = &body_motion;
        body.motion->inverse_mass = 1;
        body.traits.primitive.kind = kind;
        body.traits.radius_m = 0.2_r;
        body.sweep.inner_radius_m = 0.1_r;
        ground.motion = &ground_motion;
        manifold.a = &body;
        manifold.b = &ground;
        manifold.points.push_back({});
        manifold.points.back().a.offset_m = {0, -0.1_r, 0};
        island.bodies.assign(bodies, &body);
        island.manifolds = {&manifold};
    }

    std::shared_ptr<BodyGeometry> geometry = std::make_shared<BodyGeometry>();
    BodyMotion body_motion;
    BodyMotion ground_motion;
    BodyRecord body;
    BodyRecord ground;
    Manifold manifold;
    Island island;
};

TEST(PartChoice, ABoxThatTurnsByATenthIsOnePart) {
    Standing box(ConvexShape::Kind::Box);
    EXPECT_EQ(parts_of_step(box.island, kStep_s), 1);
    box.body_motion.spin_radps = {0, 5.9_r, 0};
    EXPECT_EQ(parts_of_step(box.island, kStep_s), 1);
    box.body_motion.spin_radps = {0, 30.1_r, 0};
    EXPECT_EQ(parts_of_step(box.island, kStep_s), 6) << "half a radian";
    box.island.swept = true;
    EXPECT_EQ(parts_of_step(box.island, kStep_s), 11) << "finely";
    EXPECT_EQ(parts_of_step(box.island, kStep_s / 2), 6) << "half of the step is left";
}

TEST(PartChoice, WhatIsThinIsFollowedMoreFinely) {
    Standing plate(ConvexShape::Kind::Box);
    plate.island.swept = true;
    plate.body_motion.spin_radps = {0, 30, 0};
    const int thick = parts_of_step(plate.island, kStep_s);
    plate.body.sweep.inner_radius_m = 1e-4_r;
    EXPECT_GT(parts_of_step(plate.island, kStep_s), 2 * thick);
}

TEST(PartChoice, WhatIsRoundTurnsInPlace) {
    Standing ball(ConvexShape::Kind::Sphere);
    ball.body_motion.spin_radps = {0, 0, 300};
    EXPECT_EQ(parts_of_step(ball.island, kStep_s), 1);
    Standing wheel(ConvexShape::Kind::Cylinder);
    wheel.body_motion.spin_radps = {0, 300, 0};
    EXPECT_EQ(parts_of_step(wheel.island, kStep_s), 1) << "about its own axis";
    wheel.body_motion.spin_radps = {300, 0, 0};
    EXPECT_GT(parts_of_step(wheel.island, kStep_s), 40);
}

TEST(PartChoice, AnImpactThatComesCountsAsTurning) {
    Standing box(ConvexShape::Kind::Box);
    box.body_motion.velocity_mps = {0, -12.1_r, 0};
    // 12 m/s over 0.2 m: as much as a radian in the step.
    EXPECT_EQ(parts_of_step(box.island, kStep_s), 11);
    box.body_motion.velocity_mps = {0, 12.1_r, 0};
    EXPECT_EQ(parts_of_step(box.island, kStep_s), 1) << "it leaves";
}

TEST(PartChoice, JointsManyBodiesAndForcesThroughThingsForbidThem) {
    Standing few(ConvexShape::Kind::Box, kMostBodiesInParts);
    EXPECT_TRUE(may_be_parted(few.island, kStep_s));
    few.body_motion.spin_radps = {0, 300, 0};
    EXPECT_GT(parts_of_step(few.island, kStep_s), 1);
    EXPECT_LE(parts_of_step(few.island, kStep_s), most_parts(few.island));
    Standing many(ConvexShape::Kind::Box, kMostBodiesInParts + 1);
    EXPECT_FALSE(may_be_parted(many.island, kStep_s));
    many.body_motion.spin_radps = {0, 300, 0};
    EXPECT_EQ(parts_of_step(many.island, kStep_s), 1);
    JointRecord joint;
    few.island.joints = {&joint};
    EXPECT_FALSE(may_be_parted(few.island, kStep_s));
    Standing driven(ConvexShape::Kind::Box);
    driven.body.applied = {.force_N = {0, -1000, 0}, .by_caller = true};
    EXPECT_FALSE(may_be_parted(driven.island, kStep_s));
    driven.body.applied.force_N = {0, -100, 0};
    EXPECT_TRUE(may_be_parted(driven.island, kStep_s));
}

TEST(PartChoice, FewerPartsOfMoreBodies) {
    int before = most_parts(Standing(ConvexShape::Kind::Box).island);
    EXPECT_GE(before, 64);
    for (const std::size_t bodies : {8U, 32U, 64U}) {
        const Standing heap(ConvexShape::Kind::Box, bodies);
        EXPECT_LE(most_parts(heap.island), before);
        before = most_parts(heap.island);
    }
    EXPECT_GE(before, 16);
}

}  // namespace
}  // namespace plumbline::physics
