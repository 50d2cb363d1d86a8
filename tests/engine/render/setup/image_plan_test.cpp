// How large a frame's images are, and which passes run: computed without a driver.
#include "engine/render/setup/image_plan.h"

#include <gtest/gtest.h>

namespace plumbline::render {
namespace {

class ImagePlanTest : public testing::Test {
protected:
    ImagePlan plan() const {
        return plan_image(
            frame_, quality_in_force(frame_, device_, failed_tries_), device_, library_);
    }

    assets::AssetLibrary library_;
    Device device_{.limits = {.texture_px = 1000, .map_px = 1000},
                   .is_software_gl = true,
                   .is_offscreen = true};
    RenderFrame frame_{.width_px = 400, .height_px = 200};
    int failed_tries_{0};
};

TEST_F(ImagePlanTest, WithoutWishesAnOffscreenImageIsDrawnAtOnce) {
    EXPECT_TRUE(plan().writes_codes);
    EXPECT_EQ(plan().scene_px, (PixelSize{400, 200}));
    device_.is_offscreen = false;
    EXPECT_FALSE(plan().writes_codes) << "a window's own image takes no codes";
}

TEST_F(ImagePlanTest, WhateverMixesColorsNeedsLight) {
    frame_.fog = Fog{};
    EXPECT_FALSE(plan().writes_codes);
    frame_.fog.reset();
    frame_.drops.emplace_back();
    EXPECT_FALSE(plan().writes_codes);
    frame_.drops.clear();
    frame_.post = Post{};
    EXPECT_TRUE(plan().tone_curve);
    EXPECT_FALSE(plan().writes_codes);
}

TEST_F(ImagePlanTest, ImagesKeepTheirShapeWithinTheDriversLimit) {
    device_.is_offscreen = false;
    frame_.width_px = 4000;
    frame_.height_px = 1000;
    EXPECT_EQ(plan().present_px, (PixelSize{4000, 1000}));
    EXPECT_EQ(plan().image_px, (PixelSize{1000, 250}));
    frame_.width_px = 800;
    frame_.height_px = 400;
    frame_.quality.anti_aliasing = AntiAliasing::Ssaa4;
    EXPECT_EQ(plan().scene_px, (PixelSize{800, 400})) << "twice as wide would be too wide";
    frame_.quality.render_scale = 0.5F;
    EXPECT_EQ(plan().scene_px, (PixelSize{800, 400}));
    EXPECT_EQ(plan().image_px, (PixelSize{400, 200}));
    EXPECT_TRUE(plan().has_samples());
    EXPECT_TRUE(plan().is_scaled());
}

TEST_F(ImagePlanTest, PassesThatNeedHalfFloatsRunOnlyWithThem) {
    frame_.post = Post{.bloom = 0.1F};
    frame_.sun = DirectionalLight{};
    frame_.shafts = SunShafts{};
    frame_.occlusion = AmbientOcclusion{};
    frame_.refraction = Refraction{};
    frame_.depth_of_field = DepthOfField{};
    frame_.motion_blur = MotionBlur{};
    const ImagePlan all = plan();
    EXPECT_TRUE(all.bloom && all.shafts && all.occlusion && all.refraction && all.focus &&
                all.motion_blur);
    device_.limits.half_float_targets = false;
    const ImagePlan none = plan();
    EXPECT_FALSE(none.bloom || none.shafts || none.occlusion || none.refraction || none.focus ||
                 none.motion_blur);
    EXPECT_TRUE(none.tone_curve);
}

TEST_F(ImagePlanTest, WithoutMemoryTheScaleIsHalvedAndThenTheLowestLevelTaken) {
    frame_.quality.anti_aliasing = AntiAliasing::Msaa4;
    EXPECT_EQ(plan().samples, 4U);
    failed_tries_ = 1;
    EXPECT_EQ(plan().samples, 1U);
    EXPECT_EQ(plan().scene_px, (PixelSize{200, 100}));
    failed_tries_ = 2;
    EXPECT_EQ(plan().scene_px, (PixelSize{160, 80}));
    EXPECT_FALSE(plan().quality.surface_maps);
}

TEST_F(ImagePlanTest, OnlyAGpuDrawsWhatIsForGpus) {
    frame_.occlusion = AmbientOcclusion{};
    frame_.quality.ambient_occlusion = Drawn::OnGpu;
    EXPECT_FALSE(plan().occlusion);
    device_.is_software_gl = false;
    EXPECT_TRUE(plan().occlusion);
}

TEST_F(ImagePlanTest, NothingOfNoSize) {
    frame_.width_px = 0;
    EXPECT_EQ(plan().scene_px, PixelSize{});
    EXPECT_EQ(plan().present_px, (PixelSize{0, 200}));
}

}  // namespace
}  // namespace plumbline::render
