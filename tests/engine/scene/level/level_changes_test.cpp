// What [[change]] does to a scene once it is built.
#include "engine/scene/level/level_changes.h"

#include "tests/support/scene_in_code.h"

namespace plumbline::scene {
namespace {

ChangeDescription change_of(const char* name) {
    ChangeDescription change;
    change.of = name;
    return change;
}

TEST(LevelChanges, MoveFreezeAndTakeAway) {
    SceneDescription scene = test::scene_of(
        {test::ball("a", {0, 5, 0}, 0.5_r), test::ball("b", {3, 5, 0}, 0.5_r), test::ground()});
    scene.changes = {change_of("a"), change_of("b"), change_of("nobody")};
    scene.changes[0].world_from_body = Pose{.position = {0, 9, 0}};
    scene.changes[0].frozen = true;
    scene.changes[1].gone = true;
    test::Running run(scene);
    ASSERT_EQ(run->moving_bodies().size(), 1U);
    EXPECT_FALSE(run->find("b"));
    const ecs::Entity a = run->find("a");
    EXPECT_EQ(run->registry.get<Transform>(a).world_from_body.position, Vec3(0, 9, 0));
    EXPECT_EQ(run->registry.get<PreviousTransform>(a).world_from_body.position, Vec3(0, 9, 0));
    run.step(30);
    EXPECT_TRUE(run->physics.state(run->moving_bodies()[0].body).frozen);
    EXPECT_EQ(run->registry.get<Transform>(a).world_from_body.position, Vec3(0, 9, 0));
}

// A base's change comes first, that of the level after it.
TEST(LevelChanges, OfOneThingCountTheLaterOne) {
    SceneDescription scene = test::scene_of({test::ball("a", {0, 5, 0}, 0.5_r)});
    scene.changes = {change_of("a"), change_of("a")};
    scene.changes[0].frozen = true;
    scene.changes[1].frozen = false;
    test::Running run(scene);
    EXPECT_FALSE(run->physics.state(run->moving_bodies()[0].body).frozen);
}

TEST(LevelChanges, TakePathsAlong) {
    SceneDescription scene = test::scene_of({test::cube("lift", {0, 1, 0})});
    scene.entities[0].body->kind = physics::BodyKind::Kinematic;
    scene.entities[0].motion = MotionDescription{.points_m = {{0, 0, 0}, {0, 2, 0}}, .period_s = 4};
    scene.changes = {change_of("lift")};
    scene.changes[0].world_from_body = Pose{.position = {5, 1, 0}};
    test::Running run(scene);
    run.step(120);
    const Vec3 there = run->registry.get<Transform>(run->find("lift")).world_from_body.position;
    EXPECT_NEAR(static_cast<double>(there.x), 5, 1e-4);
    EXPECT_GT(there.y, 2.5_r) << "half a period: at the top";
}

}  // namespace
}  // namespace plumbline::scene
