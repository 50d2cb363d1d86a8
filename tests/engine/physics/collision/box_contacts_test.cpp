// Points of boxes with boxes, spheres and capsules: the same whether a box is a body of its own or a
// part of a compound.
#include "tests/engine/physics/test_world.h"

#include <array>

namespace plumbline::physics {
namespace {

enum class Ground { Box, Part };
constexpr std::array kBothGrounds{Ground::Box, Ground::Part};

/// A box whose top is at y = 0, and a block far beside it where it is to be a part.
void lay_ground(TestWorld& test, Ground ground, const Vec3& size_m, Real friction) {
    const BodyDef still{.kind = BodyKind::Static, .friction = friction};
    if (ground == Ground::Box) {
        test.add(BoxShape{.size_m = size_m}, {0, -0.5_r, 0}, still);
        return;
    }
    test.add(CompoundShape{{{.shape = BoxShape{.size_m = size_m}},
                            {.shape = BoxShape{}, .body_from_child = {.position = {30, 0, 0}}}}},
             {0, -0.5_r, 0},
             still);
}

/// Contact points of what rests on a box, after a while.
std::uint32_t points_on_a_box(Ground ground, const ShapeDef& shape, const Pose& at) {
    TestWorld test(in_small_steps());
    lay_ground(test, ground, {6, 1, 6}, 0.5_r);
    test.world.create_body({.kind = BodyKind::Dynamic,
                            .shape = test.shape(shape),
                            .world_from_body = at,
                            .can_sleep = false});
    test.run(0.5);
    EXPECT_EQ(test.world.report().islands.size(), 1U);
    return test.world.report().islands.empty() ? 0 : test.world.report().islands[0].contacts;
}

TEST(BoxContacts, EachShapeHasThePointsItStandsOn) {
    const Quat lying = glm::angleAxis(kPi / 2, Vec3{0, 0, 1});
    const CapsuleShape capsule{.radius_m = 0.2_r, .height_m = 1};
    for (const Ground ground : kBothGrounds) {
        SCOPED_TRACE(ground == Ground::Box ? "a box" : "a part");
        EXPECT_EQ(points_on_a_box(ground, BoxShape{}, {.position = {0, 0.5_r, 0}}), 4U);
        EXPECT_EQ(points_on_a_box(ground, SphereShape{}, {.position = {0, 0.5_r, 0}}), 1U);
        EXPECT_EQ(
            points_on_a_box(ground, capsule, {.position = {0, 0.2_r, 0}, .orientation = lying}),
            2U);
    }
}

// A long capsule across an upright blade: neither of its ends is near, the edge between them is.
TEST(BoxContacts, AnEdgeBetweenTheEndsOfACapsuleIsMet) {
    for (const Ground ground : kBothGrounds) {
        TestWorld test(in_small_steps());
        lay_ground(test, ground, {0.1_r, 1, 6}, 0.5_r);
        const BodyId beam = test.world.create_body(
            {.kind = BodyKind::Dynamic,
             .shape = test.shape(CapsuleShape{.radius_m = 0.2_r, .height_m = 4}),
             .world_from_body = {.position = {0, 0.2_r, 0},
                                 .orientation = glm::angleAxis(kPi / 2, Vec3{0, 0, 1})}});
        test.run(0.2);
        EXPECT_NEAR(test.at(beam).y, 0.2, 2e-3);
    }
}

// The points change their places on the lower box all the time; it is one touch all the same.
TEST(BoxContacts, PointsAreFoundAgainWhileABoxSlides) {
    for (const Ground ground : kBothGrounds) {
        SCOPED_TRACE(ground == Ground::Box ? "a box" : "a part");
        TestWorld test(in_small_steps());
        lay_ground(test, ground, {40, 1, 6}, 0);
        const BodyId slider = test.add(BoxShape{},
                                       {0, 0.5_r, 0},
                                       {.kind = BodyKind::Dynamic,
                                        .velocity_mps = {4, 0, 0},
                                        .friction = 0,
                                        .contact_events = true});
        int began = 0;
        for (int i = 0; i < 120; ++i) {
            test.world.step();
            for (const ContactEvent& event : test.world.report().contacts)
                began += event.began ? 1 : 0;
        }
        EXPECT_EQ(began, 1);
        EXPECT_NEAR(test.at(slider).x, 8, 1e-3);
        ASSERT_EQ(test.world.report().contacts.size(), 1U);
        EXPECT_NEAR(test.world.report().contacts[0].impulse_Ns, kG / 60, 1e-3)
            << "its weight, over a step";
    }
}

}  // namespace
}  // namespace plumbline::physics
