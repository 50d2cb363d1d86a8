// SOURCES B35: what moves in a model pushes what is in its way, at its own speed.
#include "engine/scene/build/model_bodies.h"

#include "engine/physics/query.h"
#include "tests/engine/scene/build/moving_model.h"

namespace plumbline::scene {
namespace {

TEST(ModelBodies, StandWhereTheAnimationHasTheirParts) {
    const TempFolder folder;
    EntityDescription model = moving_model(folder, sled());
    model.world_from_body = {.position = {1, 2, 3},
                             .orientation = glm::angleAxis(kPi / 2, Vec3{0, 1, 0})};
    model.scale = {3, 3, 3};
    test::Running run(test::scene_of({model}));
    ASSERT_EQ(run->moving_bodies().size(), 1U);
    for (const int steps : {15, 15}) {
        run.step(steps);
        const auto done_s = static_cast<Real>(run->time_s());
        const physics::BodyState plate = run.state("model/plate");
        // Three times 2 m/s, along -z after a quarter turn to the left.
        EXPECT_NEAR(glm::distance(plate.world_from_body.position, {1, 2, 3 - 6 * done_s}), 0, 1e-4);
        EXPECT_NEAR(glm::distance(plate.velocity_mps, {0, 0, -6}), 0, 1e-3);
    }
}

// The plate's front is at x = 1 and the box's back at 1.7, so they meet after 0.35 s. Friction keeps the
// box on the plate, at its 2 m/s; after 1 s, 1.3 m on, the plate begins anew, strikes nothing, and the
// box slides to a stop within v^2 / (2 mu g) = 0.51 m.
TEST(ModelBodies, PushAtTheirOwnSpeed) {
    const TempFolder folder;
    EntityDescription box = test::box("box", {2, 0.3_r, 0}, {0.6_r, 0.6_r, 0.6_r});
    EntityDescription ground = test::ground();
    box.body->friction = 0.4_r;
    ground.body->friction = 0.4_r;
    test::Running run(test::scene_of({ground, moving_model(folder, sled()), box}));
    run.step(20);
    EXPECT_NEAR(run.state("box").velocity_mps.x, 0, 1e-4) << "not yet";
    run.step(15);
    for (int i = 0; i < 24; ++i) {
        run.step(1);
        const Real front_m = run.state("model/plate").world_from_body.position.x + 1;
        EXPECT_NEAR(run.state("box").velocity_mps.x, 2, 0.02) << i;
        EXPECT_NEAR(run.state("box").world_from_body.position.x - 0.3_r, front_m, 0.01) << i;
    }
    run.step(60);
    EXPECT_NEAR(run.state("box").world_from_body.position.x, 3.3_r + 0.51_r, 0.06);
    EXPECT_NEAR(run.state("box").velocity_mps.x, 0, 1e-3) << "nothing struck it";
}

TEST(ModelBodies, OfSkinsAreTheBonesBoxes) {
    const TempFolder folder;
    test::Running run(test::scene_of({moving_model(folder, flag())}));
    run.step(15);
    const physics::BodyState bone = run.state("model/bone");
    const Vec3 along = bone.world_from_body.orientation * Vec3{1, 0, 0};
    const Real eighth = std::sqrt(0.5_r);
    EXPECT_NEAR(glm::distance(along, {eighth, 0, -eighth}), 0, 1e-3) << "turned by 45 degrees";
    EXPECT_NEAR(bone.angular_velocity_radps.y, kPi, 1e-2);
    Vec3 low;
    Vec3 high;
    physics::bounds(run->physics, run.body("model/bone"), low, high);
    EXPECT_NEAR(high.y - low.y, 1, 0.1) << "as tall as the triangle";
}

}  // namespace
}  // namespace plumbline::scene
