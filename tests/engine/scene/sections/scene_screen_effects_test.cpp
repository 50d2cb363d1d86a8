// What a scene file asks of its image beyond things and lights, and what it gets wrong there.
#include "tests/engine/scene/sections/scene_file_fixture.h"

namespace plumbline::scene {
namespace {

TEST_F(SceneFileTest, AmbientOcclusionIsThereWhenAskedFor) {
    const Outcome unasked = load("[ambient]\ncolor = [1, 1, 1]\n");
    ASSERT_TRUE(unasked.scene.ok());
    EXPECT_FALSE(unasked.scene->ambient.occlusion);
    const Outcome refused = load("[ambient]\nocclusion = false\n");
    ASSERT_TRUE(refused.scene.ok());
    EXPECT_FALSE(refused.scene->ambient.occlusion);
    const Outcome plain = load("[ambient]\nocclusion = true\n");
    ASSERT_TRUE(plain.scene.ok());
    ASSERT_TRUE(plain.scene->ambient.occlusion);
    EXPECT_EQ(plain.scene->ambient.occlusion->radius_m, OcclusionDescription{}.radius_m);
    EXPECT_EQ(plain.scene->screen_fidelity.occlusion, Fidelity::Balanced);
    const Outcome exact = load(
        "[ambient]\nocclusion = { radius_m = 1.5, strength = 0.25 }\n"
        "[effects.ambient_occlusion]\nfidelity = \"precise\"\n");
    ASSERT_TRUE(exact.scene.ok());
    ASSERT_TRUE(exact.scene->ambient.occlusion);
    EXPECT_EQ(exact.scene->ambient.occlusion->radius_m, 1.5F);
    EXPECT_EQ(exact.scene->ambient.occlusion->strength, 0.25F);
    EXPECT_EQ(exact.scene->screen_fidelity.occlusion, Fidelity::Precise);
}

TEST_F(SceneFileTest, WrongOcclusionIsNamed) {
    const auto fault = [&](const std::string& text) {
        const Outcome outcome = load(text);
        EXPECT_EQ(outcome.faults.size(), 1U) << text;
        return outcome.faults.empty() ? std::string() : outcome.faults.front();
    };
    EXPECT_EQ(fault("[ambient]\nocclusion = { radius_m = 0 }\n"),
              "scene.toml:2:26: error: ambient.occlusion.radius_m: 0; expected a length "
              "from 0.02 to 10 m");
    EXPECT_EQ(fault("[ambient]\nocclusion = { strenght = 1 }\n"),
              "scene.toml:2:15: error: ambient.occlusion.strenght: unknown key; did you mean "
              "\"strength\"?");
    EXPECT_EQ(fault("[ambient]\nocclusion = 3\n"),
              "scene.toml:2:13: error: ambient.occlusion: 3; expected a table");
}

TEST_F(SceneFileTest, IndirectLightHasABoxWithFewEnoughPoints) {
    const Outcome asked = load(
        "[ambient]\nindirect = { min_m = [-3, 0, -2], max_m = [3, 2.5, 2], spacing_m = 0.4 }\n");
    ASSERT_TRUE(asked.scene.ok()) << asked.scene.error().message;
    ASSERT_TRUE(asked.scene->ambient.indirect);
    EXPECT_EQ(asked.scene->ambient.indirect->min_m.x, -3.0F);
    EXPECT_EQ(asked.scene->ambient.indirect->spacing_m, 0.4F);
    EXPECT_EQ(asked.scene->ambient.indirect->gain, 1.0F);
    const auto fault = [&](const std::string& text) {
        const Outcome outcome = load(text);
        return outcome.faults.size() == 1 ? outcome.faults[0] : "not one fault";
    };
    EXPECT_EQ(
        fault("[ambient]\nindirect = { min_m = [0, 0, 0], max_m = [1, -1, 1] }\n"),
        "scene.toml:2:41: error: ambient.indirect.max_m: must be above min_m along each axis");
    EXPECT_EQ(fault("[ambient]\nindirect = { max_m = [30, 30, 30], spacing_m = 0.5 }\n"),
              "scene.toml:2:48: error: ambient.indirect.spacing_m: more than 20000 points; take a "
              "larger one or a smaller box");
}

TEST_F(SceneFileTest, ShaftsLensAndShutterAreThereWhenAskedFor) {
    const Outcome unasked = load("[sun]\nshafts = false\n[post]\nshutter_s = 0\n");
    ASSERT_TRUE(unasked.scene.ok());
    EXPECT_FALSE(unasked.scene->sun->shafts);
    EXPECT_FALSE(unasked.scene->camera.focus);
    EXPECT_FALSE(unasked.scene->post->shutter);
    const Outcome asked = load(
        "[sun]\nshafts = { density_per_m = 0.02, distance_m = 30 }\n"
        "[camera]\nfocus = { distance_m = 2, aperture_m = 0.05 }\n"
        "[post]\nshutter_s = 0.02\n[effects.motion_blur]\nfidelity = \"draft\"\n");
    ASSERT_TRUE(asked.scene.ok()) << asked.scene.error().message;
    EXPECT_TRUE(asked.faults.empty());
    EXPECT_EQ(asked.scene->sun->shafts->density_per_m, 0.02F);
    EXPECT_EQ(asked.scene->sun->shafts->distance_m, 30.0F);
    EXPECT_EQ(asked.scene->camera.focus->distance_m, 2.0F);
    EXPECT_EQ(asked.scene->camera.focus->aperture_m, 0.05F);
    EXPECT_FALSE(asked.scene->has_camera) << "a lens places no camera";
    EXPECT_EQ(asked.scene->post->shutter->open_s, 0.02F);
    EXPECT_EQ(asked.scene->screen_fidelity.shutter, Fidelity::Draft);
}

TEST_F(SceneFileTest, WrongShaftsLensAndShutterAreNamed) {
    const Outcome outcome = load(
        "[sun]\nshafts = { density_per_m = 2 }\n[camera]\nfocus = { distance_m = 0 }\n"
        "[post]\nshutter_s = -1\n");
    ASSERT_EQ(outcome.faults.size(), 3U);
    EXPECT_EQ(outcome.faults[0],
              "scene.toml:2:28: error: sun.shafts.density_per_m: 2; expected a density "
              "from 0 to 1 per m");
    EXPECT_EQ(outcome.faults[1],
              "scene.toml:4:24: error: camera.focus.distance_m: 0; expected a length "
              "from 0.01 to 10000 m");
    EXPECT_EQ(outcome.faults[2],
              "scene.toml:6:13: error: post.shutter_s: -1; expected a time from 0 to 1 "
              "s");
}

}  // namespace
}  // namespace plumbline::scene
