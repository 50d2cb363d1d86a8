// SOURCES B35: what moves in a model pushes what is in its way, at its own speed.
#include "engine/scene/build/model_bodies.h"

#include "tests/engine/assets/fixture.h"
#include "tests/support/scene_in_code.h"

namespace plumbline::scene {
namespace {

using assets::test::TempFolder;
using assets::test::TriangleFile;

/// A triangle from (0, 0) to (1, 0) and (0, 1) that slides by 2 m along x in one second.
std::string sled() {
    TriangleFile file;
    file.json["nodes"] = {{{"mesh", 0}, {"name", "plate"}}};
    file.slide(0);
    return file.glb();
}

std::string flag() {
    TriangleFile file;
    file.hang_on_turning_bone();
    return file.glb();
}

EntityDescription moving_model(const TempFolder& folder, const std::string& bytes) {
    EntityDescription model;
    model.name = "model";
    const std::filesystem::path file = folder.write("m.glb", bytes);
    model.visual = ModelVisual{.file = file, .root = file.parent_path()};
    model.body = BodyDescription{.kind = physics::BodyKind::Kinematic};
    return model;
}

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

TEST(ModelBodies, AreNotPulledThroughWhatStandsBehindWhenTheyBeginAnew) {
    const TempFolder folder;
    EntityDescription behind = test::box("behind", {0.9_r, 0.2_r, 0}, {0.2_r, 0.4_r, 2});
    behind.world_from_body.position = {-0.2_r, 0.2_r, 0};
    test::Running run(test::scene_of({test::ground(), moving_model(folder, sled()), behind}));
    run.step(75);
    EXPECT_LT(glm::length(run.state("behind").velocity_mps), 0.05);
    EXPECT_NEAR(run.state("behind").world_from_body.position.x, -0.2, 0.02);
}

TEST(ModelBodies, StopWithTheAnimation) {
    const TempFolder folder;
    test::Running run(test::scene_of({moving_model(folder, sled())}));
    run.step(15);
    for (auto [entity, playing] : run->registry.view<PlayingModel>()) playing.paused = true;
    run.step(15);
    const physics::BodyState plate = run.state("model/plate");
    EXPECT_NEAR(plate.world_from_body.position.x, 0.5, 1e-4);
    EXPECT_NEAR(glm::length(plate.velocity_mps), 0, 1e-6);
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
    run->physics.bounds(run.body("model/bone"), low, high);
    EXPECT_NEAR(high.y - low.y, 1, 0.1) << "as tall as the triangle";
}

TEST(ModelBodies, AreNotThereForModelsThatOnlyShow) {
    const TempFolder folder;
    EntityDescription shown = moving_model(folder, sled());
    shown.body.reset();
    test::Running run(test::scene_of({shown}));
    EXPECT_TRUE(run->moving_bodies().empty());
    shown.body = BodyDescription{.kind = physics::BodyKind::Static};
    test::Running still(test::scene_of({shown}));
    EXPECT_TRUE(still->moving_bodies().empty());
}

}  // namespace
}  // namespace plumbline::scene
