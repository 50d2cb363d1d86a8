// Outlines of collision shapes: whose are drawn.
#include "engine/physics/character.h"
#include "engine/physics/debug_lines.h"
#include "engine/physics/query.h"
#include "tests/engine/physics/test_world.h"

#include <gtest/gtest.h>

namespace plumbline::physics {
namespace {

std::size_t corners(const PhysicsWorld& world, const std::optional<Vec3>& eye_world = {}) {
    LineList lines;
    add_debug_lines(world, lines, eye_world);
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

// SOURCES A32: the box along the axes round a cube that is turned by 45 degrees is 1.414 m wide.
TEST(BulletLines, BoxesAlongTheAxesHaveTwelveEdges) {
    TestWorld test;
    BodyDef turned{.kind = BodyKind::Dynamic};
    turned.world_from_body.orientation = glm::angleAxis(kPi / 4, Vec3{0, 1, 0});
    const BodyId body = test.add(BoxShape{.size_m = {1, 1, 1}}, {3, 4, 5}, turned);
    LineList lines;
    add_box_lines(test.world, lines);
    ASSERT_EQ(lines.vertices.size(), 24U);
    Vec3 low{};
    Vec3 high{};
    bounds(test.world, body, low, high);
    EXPECT_NEAR(high.x - low.x, std::sqrt(2.0), 0.1);
    for (const LineVertex& vertex : lines.vertices) {
        for (int axis = 0; axis < 3; ++axis) {
            const auto part = static_cast<Real>(vertex.position_world[axis]);
            EXPECT_TRUE(std::abs(part - low[axis]) < 1e-5_r ||
                        std::abs(part - high[axis]) < 1e-5_r);
        }
    }
}

}  // namespace
}  // namespace plumbline::physics
