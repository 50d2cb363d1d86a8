// A frame's setup is a function of the frame: computed here without a driver.
#include "engine/render/setup/frame_setup.h"

#include "engine/assets/primitives.h"

#include <gtest/gtest.h>

#include <cstring>

namespace plumbline::render {
namespace {

using namespace mesh_feature;

class FrameSetupTest : public testing::Test {
protected:
    FrameSetup setup() const {
        const ImagePlan image = plan_image(frame_, frame_.quality, device_, library_);
        return set_up(frame_, image, {device_, library_, sky_, lamps_before_});
    }
    void add_lamp(float x, bool casts_shadow) {
        frame_.lights.push_back(
            {.position_world = {x, 0.0F, -5.0F}, .radius_m = 2.0F, .casts_shadow = casts_shadow});
    }

    mutable assets::AssetLibrary library_;
    GpuSky sky_{library_, 1024};
    Device device_{.limits = {.texture_px = 4096, .map_px = 4096}, .is_software_gl = true};
    RenderFrame frame_{.width_px = 200, .height_px = 100};
    LightShadowChoice lamps_before_;
};

TEST_F(FrameSetupTest, TheSameFrameHasTheSameSetup) {
    frame_.sun = DirectionalLight{};
    frame_.sun_shadow = SunShadow{.cascades = 2};
    frame_.flashlight = Flashlight{.position_world = {0.2F, 0.0F, 0.0F}};
    frame_.fog = Fog{};
    const FrameSetup first = setup();
    const FrameSetup second = setup();
    EXPECT_EQ(std::memcmp(&first.block, &second.block, sizeof(FrameBlock)), 0);
    EXPECT_EQ(first.features, second.features);
}

TEST_F(FrameSetupTest, DepthAndRaysAreThoseOfTheCamera) {
    frame_.camera = {.fov_y_rad = 1.2F, .near_m = 0.1F, .far_m = 50.0F};
    const FrameSetup s = setup();
    // A point 7 m ahead: its depth, and back.
    const Vec4f clip = s.block.clip_from_world * Vec4f{0.0F, 0.0F, -7.0F, 1.0F};
    const float depth = 0.5F * clip.z / clip.w + 0.5F;
    EXPECT_NEAR(1.0F / (s.screen.depth_line.x + s.screen.depth_line.y * depth), 7.0F, 1e-3F);
    // The ray through the upper edge.
    const Vec4f ray = s.block.world_from_ray * Vec4f{0.0F, 1.0F, 1.0F, 0.0F};
    EXPECT_NEAR(ray.y / -ray.z, std::tan(0.6F), 1e-5F);
    EXPECT_NEAR(s.screen.tan_half.x, 2.0F * std::tan(0.6F), 1e-5F);
}

TEST_F(FrameSetupTest, WhatPlaySwitchesIsNoFeatureOfTheMeshShader) {
    frame_.sun = DirectionalLight{};
    const FeatureSet plain = setup().features;
    frame_.fog = Fog{};
    frame_.wind = Wind{};
    frame_.textures = false;
    frame_.depth_test = DepthTest::Always;
    frame_.refraction = Refraction{.caustics = true};
    frame_.post = Post{.bloom = 0.2F};
    EXPECT_EQ(setup().features, plain);
}

TEST_F(FrameSetupTest, ShadowsOfLampsAreAFeatureOfTheSceneNotOfWhatIsInSight) {
    frame_.light_shadows = LightShadows{};
    add_lamp(0.0F, true);
    const FeatureSet in_sight = setup().features;
    EXPECT_NE(in_sight & kLightShadows, 0U);
    EXPECT_EQ(setup().block.wind.w, 1.0F);
    frame_.camera.orientation = glm::angleAxis(3.14F, Vec3f{0.0F, 1.0F, 0.0F});
    EXPECT_EQ(setup().features, in_sight);
    EXPECT_EQ(setup().block.wind.w, 0.0F) << "and none casts";
    frame_.lights[0].casts_shadow = false;
    EXPECT_EQ(setup().features & kLightShadows, 0U);
}

TEST_F(FrameSetupTest, LampsThatCastComeFirst) {
    frame_.light_shadows = LightShadows{};
    add_lamp(-1.0F, false);
    add_lamp(1.0F, true);
    const LampSetup lamps = setup().lamps;
    ASSERT_EQ(lamps.lights.size(), 2U);
    EXPECT_EQ(lamps.lights[0].position_world.x, 1.0F);
    EXPECT_EQ(lamps.shadow_places.size(), 1U);
}

TEST_F(FrameSetupTest, AFlashlightAtTheEyeHasABeamAndNoMap) {
    frame_.flashlight = Flashlight{};
    EXPECT_TRUE(setup().flashlight.beam.has_value());
    EXPECT_FALSE(setup().flashlight.shadow.has_value());
    EXPECT_NE(setup().features & kFlashlightAtEye, 0U);
    frame_.flashlight->position_world.x = 1e-3F;
    EXPECT_TRUE(setup().flashlight.shadow.has_value());
    EXPECT_EQ(setup().features & kFlashlightAtEye, 0U);
}

TEST_F(FrameSetupTest, CascadesLieSideBySideWithinTheDriversLimit) {
    frame_.sun = DirectionalLight{};
    frame_.sun_shadow = SunShadow{.size_px = 2048, .cascades = 3};
    const FrameSetup s = setup();
    ASSERT_EQ(s.sun.shadow_views.size(), 3U);
    EXPECT_EQ(s.sun.shadow_views[0].size_px, 4096U / 3);
    EXPECT_FLOAT_EQ(s.block.clusters.z, 1.0F / 3.0F);
    EXPECT_LT(s.block.cascade_ends.x, s.block.cascade_ends.y);
    EXPECT_EQ(s.block.cascade_ends.z, 1e9F) << "of a fourth that there is not";
    frame_.sun_reaches_ground = false;
    EXPECT_TRUE(setup().sun.shadow_views.empty());
}

TEST_F(FrameSetupTest, DrawsAreWhatIsInSight) {
    const auto box = library_.add_mesh("box", assets::box_mesh(Vec3f{1.0F}));
    const auto red = library_.add_material({.name = "red"});
    for (const float z : {-4.0F, 4.0F}) {
        add_item(frame_,
                 {.mesh = box, .world_from_body = glm::translate(Mat4f{1.0F}, {0.0F, 0.0F, z})},
                 {&red, 1});
    }
    const DrawSetup draws = set_up_draws(setup(), library_, nullptr);
    ASSERT_EQ(draws.opaque.instances.size(), 1U);
    EXPECT_EQ(draws.opaque.instances[0].row_z.w, -4.0F);
    EXPECT_TRUE(draws.translucent.runs.empty());
    EXPECT_FALSE(draws.shadow_sight.has_value());
}

}  // namespace
}  // namespace plumbline::render
