// Which lamps cast shadows, and how fine those are.
#include "tests/engine/render/image_fixture.h"

namespace plumbline::render {
namespace {

class LightSetupGl : public ImageGl {
protected:
    RenderFrame with_lamps(int count) {
        RenderFrame frame = wall(matt(Vec3f{0.8F}));
        for (int i = 0; i < count; ++i) {
            frame.lights.push_back({.position_world = {0.1F * static_cast<float>(i), 0.0F, -1.0F},
                                    .intensity = Vec3f{1.0F + static_cast<float>(i)},
                                    .casts_shadow = true});
        }
        frame.light_shadows = LightShadows{.size_px = 64};
        return frame;
    }
};

TEST_F(LightSetupGl, AsManyCastAndAsFinelyAsTheQualityAllows) {
    RenderFrame frame = with_lamps(3);
    frame.quality.shadowed_lights = 2;
    const auto some = draw(frame);
    EXPECT_EQ(renderer_->stats().shadowed_lights, 2U);
    EXPECT_EQ(renderer_->stats().unshadowed_lights, 1U);
    EXPECT_EQ(bytes_of("light_shadows"), 2U * 6U * 64U * 64U * 4U);
    frame.quality.shadowed_lights = 0;
    const auto none = draw(frame);
    EXPECT_EQ(renderer_->stats().shadowed_lights, 0U);
    EXPECT_EQ(bytes_of("light_shadows"), 0U);
    // Nothing stands before the wall: with shadows and without it is as light.
    EXPECT_NEAR(pixel_at(some, 16, 16).g, pixel_at(none, 16, 16).g, 1);
    EXPECT_GT(pixel_at(none, 16, 16).g, 100);
    frame.lights.resize(1);
    frame.quality.shadowed_lights = 2;
    frame.quality.shadow_detail = 0.75F;
    draw(frame);
    EXPECT_EQ(bytes_of("light_shadows"), 6U * 48U * 48U * 4U);
    // And no coarser than this.
    frame.quality.shadow_detail = 0.25F;
    draw(frame);
    EXPECT_EQ(bytes_of("light_shadows"), 6U * 32U * 32U * 4U);
}

}  // namespace
}  // namespace plumbline::render
