// Drops and rings in images that are known beforehand.
#include "tests/engine/render/image_fixture.h"

#include <algorithm>

namespace plumbline::render {
namespace {

class DropPassGl : public ImageGl {
protected:
    /// Looks down -Z from the origin into the dark; light from everywhere shows drops.
    RenderFrame dark() {
        RenderFrame frame = empty_frame(64, 64);
        frame.camera = camera_at(Vec3f{0.0F}, {0.0F, 0.0F, -1.0F});
        frame.ambient = Vec3f{0.5F};
        return frame;
    }
    static int lit_pixels(const assets::ImageData& image) {
        int count = 0;
        for (std::size_t i = 0; i < image.bytes.size(); i += 3) count += image.bytes[i] > 8 ? 1 : 0;
        return count;
    }
    bool pass_ran() const {
        return std::ranges::any_of(renderer_->stats().passes,
                                   [](const PassTiming& pass) { return pass.name == "drops"; });
    }
};

TEST_F(DropPassGl, WithoutDropsThereIsNoPassAndNoMemory) {
    RenderFrame frame = dark();
    EXPECT_EQ(lit_pixels(draw(frame)), 0);
    EXPECT_FALSE(pass_ran());
    EXPECT_EQ(bytes_of("drops"), 0U);
    frame.drops = {{.position_world = {0.0F, 0.0F, -2.0F}, .radius_m = 0.1F}};
    draw(frame);
    EXPECT_TRUE(pass_ran());
    EXPECT_EQ(bytes_of("drops"), 32U);
    frame.drops.clear();
    draw(frame);
    EXPECT_EQ(bytes_of("drops"), 0U);
}

TEST_F(DropPassGl, ADropIsDrawnOutAlongItsWay) {
    RenderFrame frame = dark();
    frame.drops = {
        {.position_world = {0.0F, 0.0F, -2.0F}, .radius_m = 0.05F, .trail_m = {0.0F, -1.0F, 0.0F}}};
    const assets::ImageData image = draw(frame);
    // At 2 m a metre is 27.7 px: the streak reaches 15 px up and down, and 1.4 px aside.
    EXPECT_GT(pixel_at(image, 32, 24).r, 30);
    EXPECT_GT(pixel_at(image, 32, 40).r, 30);
    EXPECT_EQ(pixel_at(image, 32, 14).r, 0);
    EXPECT_EQ(pixel_at(image, 36, 32).r, 0);
    EXPECT_EQ(pixel_at(image, 28, 32).r, 0);
}

TEST_F(DropPassGl, ADropThinnerThanAPixelStaysThereAndIsFainter) {
    RenderFrame frame = dark();
    frame.drops = {{.position_world = {0.01F, 0.01F, -2.0F},
                    .radius_m = 0.018F,
                    .trail_m = {0.0F, -1.0F, 0.0F}}};
    const int whole = pixel_at(draw(frame), 32, 31).r;
    frame.drops[0].radius_m = 0.006F;
    const int third = pixel_at(draw(frame), 32, 31).r;
    EXPECT_GT(third, 8);
    EXPECT_LT(third, whole * 3 / 4);
}

TEST_F(DropPassGl, WhatStandsBeforeThemHidesThem) {
    RenderFrame frame = dark();
    frame.drops = {{.position_world = {0.0F, 0.0F, -2.0F}, .radius_m = 0.2F}};
    EXPECT_GT(lit_pixels(draw(frame)), 20);
    add_box(frame, {2.0F, 2.0F, 0.1F}, {0.0F, 0.0F, -1.0F}, unlit(Vec3f{0.0F}));
    EXPECT_EQ(lit_pixels(draw(frame)), 0);
}

TEST_F(DropPassGl, ARingIsHollowAndLiesLevel) {
    RenderFrame frame = dark();
    frame.camera = camera_at({0.0F, 2.0F, 0.0F}, {0.0F, 0.0F, 0.0F});
    frame.water_rings = {{.center_world = Vec3f{0.0F}, .radius_m = 0.5F}};
    const assets::ImageData above = draw(frame);
    EXPECT_EQ(pixel_at(above, 32, 32).r, 0) << "its middle is water";
    EXPECT_GT(pixel_at(above, 32 + 11, 32).r, 30) << "0.4 m off it has its crest";
    EXPECT_EQ(pixel_at(above, 32 + 16, 32).r, 0);
    frame.camera = camera_at({0.0F, 0.0F, 2.0F}, {0.0F, 0.0F, 0.0F});
    EXPECT_LT(lit_pixels(draw(frame)), 40) << "edge on";
}

}  // namespace
}  // namespace plumbline::render
