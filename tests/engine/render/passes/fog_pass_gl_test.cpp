// Fog over what is drawn: its closed form, before the sky, and no new shaders for it.
#include "tests/engine/render/image_fixture.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace plumbline::render {
namespace {

class FogPassGl : public ImageGl {
protected:
    static Vec3f in_fog(const Fog& fog, const Vec3f& light, float distance_m) {
        const float depth = fog.density_per_m * distance_m;
        return glm::mix(fog.color, light, std::exp(-depth * depth));
    }
    void expect_center(const RenderFrame& frame, const Vec3f& light) {
        expect_near(center(frame), srgb_from_linear(light), 2);
    }
    RenderFrame wall_in_fog() {
        RenderFrame frame = wall(unlit({0.9F, 0.1F, 0.1F}), 20.0F);
        frame.fog = Fog{.color = {0.2F, 0.4F, 0.8F}, .density_per_m = 0.04F};
        return frame;
    }
};

TEST_F(FogPassGl, HidesAWallByItsDistanceWithAnyNumberOfSamples) {
    RenderFrame frame = wall_in_fog();
    for (const AntiAliasing way : {AntiAliasing::Off, AntiAliasing::Msaa4, AntiAliasing::Fxaa}) {
        frame.quality.anti_aliasing = way;
        expect_center(frame, in_fog(*frame.fog, {0.9F, 0.1F, 0.1F}, 20.0F));
    }
}

TEST_F(FogPassGl, HidesTheBackgroundAsFarAsTheCameraSees) {
    RenderFrame frame = empty_frame(33, 33);
    frame.clear_color = {0.9F, 0.1F, 0.1F};
    frame.camera.far_m = 40.0F;
    frame.fog = Fog{.color = {0.2F, 0.4F, 0.8F}, .density_per_m = 0.02F};
    expect_center(frame, in_fog(*frame.fog, frame.clear_color, 40.0F));
}

TEST_F(FogPassGl, GlassStandsInTheFogByItsOwnDistance) {
    RenderFrame frame = wall_in_fog();
    const auto pane = library_.add_material({.name = "pane",
                                             .shading = assets::Shading::Unlit,
                                             .base_color = {0.1F, 0.9F, 0.1F},
                                             .alpha = 0.5F,
                                             .alpha_mode = assets::AlphaMode::Blend});
    add_box(frame, {4.0F, 4.0F, 0.02F}, {0.0F, 0.0F, -5.01F}, pane);
    const Vec3f behind = in_fog(*frame.fog, {0.9F, 0.1F, 0.1F}, 20.0F);
    const Vec3f front = in_fog(*frame.fog, {0.1F, 0.9F, 0.1F}, 5.0F);
    expect_center(frame, 0.5F * (behind + front));
}

// FAULTS: switched on while playing, fog came over the hills one shader after another.
TEST_F(FogPassGl, NeedsNoShaderOfItsOwnForWhatItHides) {
    RenderFrame frame = wall_in_fog();
    add_box(frame, Vec3f{1.0F}, {0.0F, 0.0F, -5.0F}, matt(Vec3f{0.5F}));
    add_box(frame,
            Vec3f{1.0F},
            {2.0F, 0.0F, -5.0F},
            library_.add_material({.name = "glass", .alpha_mode = assets::AlphaMode::Blend}));
    const std::optional<Fog> fog = std::exchange(frame.fog, {});
    draw(frame);
    EXPECT_GT(renderer_->stats().new_programs, 2U);
    frame.fog = fog;
    draw(frame);
    EXPECT_EQ(renderer_->stats().new_programs, 0U);
    const auto& passes = renderer_->stats().passes;
    EXPECT_EQ(std::ranges::count(passes, "fog", &PassTiming::name), 1);
}

}  // namespace
}  // namespace plumbline::render
