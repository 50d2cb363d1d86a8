// Scenes as the study steps them.
#include "engine/study/played_scene.h"

#include "tests/support/scene_in_code.h"

#include <gtest/gtest.h>

namespace plumbline::study {
namespace {

TEST(PlayedScene, KnowsThePiecesOfItsRopes) {
    scene::SceneDescription scene = test::scene_of({test::cube("load", {0, 2, 0})});
    scene.forces.ropes.push_back({.name = "rope",
                                  .a = "world",
                                  .b = "load",
                                  .anchor_a_m = Vec3{0, 5, 0},
                                  .anchor_b_m = Vec3{0, 2.5_r, 0},
                                  .length_m = 2.5,
                                  .pieces = 8,
                                  .location = in_file("test.toml", 9)});
    test::Running run(scene);
    ASSERT_TRUE(run.simulation);
    const std::set<physics::BodyId> pieces = rope_pieces(*run);
    EXPECT_EQ(pieces.size(), run->ropes().front().pieces.size());
    EXPECT_GE(pieces.size(), 7U);
    EXPECT_EQ(run->moving_bodies().size(), pieces.size() + 1) << "and the load";
    EXPECT_TRUE(rope_pieces(*test::Running(test::scene_of({}))).empty());
}

}  // namespace
}  // namespace plumbline::study
