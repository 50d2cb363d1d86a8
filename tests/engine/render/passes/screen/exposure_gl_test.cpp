// Exposure that follows the image.
#include "engine/render/passes/screen/exposure_meter.h"
#include "tests/engine/render/image_fixture.h"

namespace plumbline::render {
namespace {

TEST(Exposure, FollowsDarknessButNotAllTheWay) {
    EXPECT_FLOAT_EQ(exposure_for(0.2F), 1.0F);
    // A fifth of the light: 5^0.6 times the exposure, so the image is darker by 5^0.4.
    EXPECT_NEAR(exposure_for(0.04F), std::pow(5.0F, 0.6F), 1e-3F);
    EXPECT_EQ(exposure_for(1e-5F), 5.0F);
    EXPECT_EQ(exposure_for(0.0F), 5.0F);
    EXPECT_EQ(exposure_for(50.0F), 0.6F);
}

TEST(Exposure, EyesTakeTheirTimeWhateverTheFramesAre) {
    float fine = 1.0F;
    for (int i = 0; i < 100; ++i) fine = adapted(fine, 4.0F, 0.01F);
    EXPECT_NEAR(fine, adapted(1.0F, 4.0F, 1.0F), 1e-3F);
    EXPECT_NEAR(adapted(1.0F, 4.0F, 100.0F), 4.0F, 1e-3F);
    EXPECT_FLOAT_EQ(adapted(2.0F, 4.0F, 0.0F), 2.0F);
    // Into the light eyes are faster than into the dark.
    EXPECT_GT(std::log(4.0F / adapted(4.0F, 1.0F, 0.3F)), std::log(adapted(1.0F, 4.0F, 0.3F)));
}

class ExposureGl : public ImageGl {
protected:
    /// A wall that shines by itself, seen through eyes that adapt or do not.
    Pixel shown(float light, bool adapts, float exposure = 1.0F) {
        RenderFrame frame = wall(unlit(Vec3f{light}));
        frame.post = Post{.exposure = exposure, .adapts = adapts};
        return center(frame);
    }
};

TEST_F(ExposureGl, AnEvenImageIsShownAsItsOwnExposureSays) {
    for (const float light : {0.02F, 0.2F, 0.9F}) {
        const Pixel adapted_image = shown(light, true);
        const Pixel expected = shown(light, false, exposure_for(light));
        EXPECT_NEAR(adapted_image.g, expected.g, 1) << light;
    }
    EXPECT_NEAR(shown(0.2F, true).g, shown(0.2F, false).g, 1);
}

TEST_F(ExposureGl, EveryImageIsTheSameWhateverWasSeenBefore) {
    const Pixel first = shown(0.05F, true);
    shown(0.9F, true);
    EXPECT_EQ(shown(0.05F, true).g, first.g);
}

TEST_F(ExposureGl, CostsNothingUnasked) {
    shown(0.5F, true);
    EXPECT_GT(bytes_of("post"), 0U);
    shown(0.5F, false);
    EXPECT_EQ(bytes_of("post"), 0U);
}

}  // namespace
}  // namespace plumbline::render
