// Outlines of collision shapes: whose are drawn.
#include "engine/physics/character.h"
#include "tests/engine/physics/test_world.h"

#include <gtest/gtest.h>

namespace plumbline::physics {
namespace {

std::size_t corners(const PhysicsWorld& world, const std::optional<Vec3>& eye_world = {}) {
    LineList lines;
    world.add_debug_lines(lines, eye_world);
    return lines.vertices.size();
}

TEST(BulletLines, TheCapsuleRoundTheEyeIsLeftOut) {
    TestWorld test;
    test.ground();
    test.add(BoxShape{.size_m = {1, 1, 1}}, {3, 0.5_r, 0});
    const std::size_t things = corners(test.world);
    const Character me(test.world, {.feet_position_m = {0, 0, 0}});
    const Character another(test.world, {.feet_position_m = {-3, 0, 0}});
    const std::size_t all = corners(test.world);
    const std::size_t capsule = (all - things) / 2;
    EXPECT_GT(capsule, 20U);
    EXPECT_EQ(corners(test.world, me.state().eye_position_m), things + capsule);
    EXPECT_EQ(corners(test.world, Vec3{0, 5, 0}), all) << "seen from above, both are drawn";
    // A thing's outline stays, also from inside it.
    EXPECT_EQ(corners(test.world, Vec3{3, 0.5_r, 0}), all);
}

}  // namespace
}  // namespace plumbline::physics
