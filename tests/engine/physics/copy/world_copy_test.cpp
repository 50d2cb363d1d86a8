// Worlds copied as plain data, and poses judged by what can be worked out.
#include "engine/physics/world_copy.h"

#include "engine/physics/physics_world.h"
#include "engine/physics/totals.h"

#include <gtest/gtest.h>

namespace plumbline::physics {
namespace {

BodyId add(PhysicsWorld& world, const ShapeDef& shape, const Vec3& at, BodyKind kind) {
    return world.create_body({.kind = kind,
                              .shape = *world.create_shape(shape),
                              .world_from_body = {.position = at},
                              .mass_kg = 2});
}

TEST(WorldCopy, SaysShapesAndMassesInMassFrames) {
    PhysicsWorld world({});
    const ShapeId box = *world.create_shape(BoxShape{.size_m = {1, 2, 3}});
    world.create_body({.kind = BodyKind::Dynamic,
                       .shape = box,
                       .world_from_body = {.position = {4, 5, 6}},
                       .mass_kg = 12,
                       .center_of_mass_m = Vec3{0.25_r, 0, 0},
                       .friction = 0.3_r,
                       .restitution = 0.4_r});
    add(world, SphereShape{.radius_m = 0.5_r}, {0, 0, 0}, BodyKind::Static);
    const WorldCopy copy = copy_of(world);
    ASSERT_EQ(copy.bodies.size(), 2U);
    const BodyCopy& body = copy.bodies[0];
    ASSERT_EQ(body.parts.size(), 1U);
    EXPECT_EQ(std::get<BoxShape>(body.parts[0].shape).size_m, (Vec3{1, 2, 3}));
    EXPECT_NEAR(body.parts[0].body_from_child.position.x, -0.25, 1e-6);
    EXPECT_NEAR(body.world_from_mass.position.x, 4.25, 1e-6);
    EXPECT_DOUBLE_EQ(body.mass_kg, 12);
    EXPECT_FLOAT_EQ(static_cast<float>(body.friction), 0.3F);
    EXPECT_FLOAT_EQ(static_cast<float>(body.restitution), 0.4F);
    EXPECT_EQ(copy.bodies[1].kind, BodyKind::Static);
    EXPECT_EQ(std::get<SphereShape>(copy.bodies[1].parts[0].shape).radius_m, 0.5_r);
}

TEST(WorldCopy, EveryShapeComesBackAsItself) {
    PhysicsWorld world({});
    const std::vector<Vec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    add(world, CapsuleShape{.radius_m = 0.2_r, .height_m = 1.5_r}, {}, BodyKind::Dynamic);
    add(world, CylinderShape{.radius_m = 0.3_r, .height_m = 0.5_r}, {}, BodyKind::Dynamic);
    add(world, ConeShape{.radius_m = 0.4_r, .height_m = 0.6_r}, {}, BodyKind::Dynamic);
    add(world, HullShape{corners}, {}, BodyKind::Dynamic);
    add(world, MeshShape{corners, {{0, 2, 1}, {0, 1, 3}}}, {}, BodyKind::Static);
    const std::vector<BodyCopy> bodies = copy_of(world).bodies;
    EXPECT_FLOAT_EQ(static_cast<float>(std::get<CapsuleShape>(bodies[0].parts[0].shape).height_m),
                    1.5F);
    EXPECT_FLOAT_EQ(static_cast<float>(std::get<CylinderShape>(bodies[1].parts[0].shape).height_m),
                    0.5F);
    EXPECT_FLOAT_EQ(static_cast<float>(std::get<ConeShape>(bodies[2].parts[0].shape).radius_m),
                    0.4F);
    EXPECT_EQ(std::get<HullShape>(bodies[3].parts[0].shape).points_m.size(), 4U);
    EXPECT_EQ(std::get<MeshShape>(bodies[4].parts[0].shape).triangles.size(), 2U);
}

TEST(PoseFaults, AreTheDeepestOverlapAndTheWidestGap) {
    PhysicsWorld world({.gravity_mps2 = {0, 0, 0}});
    add(world, BoxShape{.size_m = {10, 1, 10}}, {0, -0.5_r, 0}, BodyKind::Static);
    const BodyId ball = add(world, SphereShape{.radius_m = 0.5_r}, {0, 2, 0}, BodyKind::Dynamic);
    ASSERT_TRUE(world.create_joint({.kind = JointKind::BallAndSocket,
                                    .a = ball,
                                    .anchor_a_world = {0, 2.5_r, 0},
                                    .anchor_b_world = {0, 2.5_r, 0}}));
    EXPECT_EQ(pose_faults(world).penetration_m, 0);
    EXPECT_NEAR(pose_faults(world).joint_error_m, 0, 1e-7);
    world.set_pose(ball, {.position = {0, 0.4_r, 0}});
    const PoseFaults faults = pose_faults(world);
    EXPECT_NEAR(faults.penetration_m, 0.1, 1e-6);
    EXPECT_NEAR(faults.joint_error_m, 1.6, 1e-6);
    EXPECT_NEAR(max_joint_error_m(world), 1.6, 1e-6);
}

TEST(PoseFaults, LeaveOutWhatMayNotTouch) {
    PhysicsWorld world({});
    const BodyId a = add(world, BoxShape{}, {0, 0, 0}, BodyKind::Dynamic);
    const BodyId b = add(world, BoxShape{}, {0.5_r, 0, 0}, BodyKind::Dynamic);
    EXPECT_NEAR(pose_faults(world).penetration_m, 0.5, 1e-6);
    ASSERT_TRUE(world.create_joint({.kind = JointKind::Fixed, .a = a, .b = b}));
    EXPECT_EQ(pose_faults(world).penetration_m, 0);
}

/// What a solver says of its own points is what its poses say: studies compare the two.
TEST(PoseFaults, AgreeWithTheContactsOfAStack) {
    PhysicsWorld world({});
    add(world, BoxShape{.size_m = {10, 1, 10}}, {0, -0.5_r, 0}, BodyKind::Static);
    for (int i = 0; i < 5; ++i)
        add(world, BoxShape{}, {0, 0.5_r + static_cast<Real>(i), 0}, BodyKind::Dynamic);
    for (int i = 0; i < 30; ++i) world.step();
    EXPECT_GT(max_penetration_m(world), 1e-6);
    EXPECT_NEAR(pose_faults(world).penetration_m, max_penetration_m(world), 2e-5);
}

}  // namespace
}  // namespace plumbline::physics
