// From the scene's light to the finished image.
#include "engine/assets/image/image_import.h"
#include "tests/engine/render/image_fixture.h"
#include "tests/engine/render/renderer_fixture.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace plumbline::render {
namespace {

class PostPassGl : public ImageGl {};

TEST_F(PostPassGl, ToneCurveRisesStaysBelowOneAndAgreesWithTheCpu) {
    int before = -1;
    for (const float light : {0.01F, 0.05F, 0.18F, 0.5F, 1.0F, 2.0F, 5.0F, 20.0F}) {
        RenderFrame frame = wall(unlit(Vec3f{light}));
        frame.post = Post{.exposure = 1.0F};
        const Pixel pixel = center(frame);
        EXPECT_GT(pixel.r, before);
        EXPECT_LE(pixel.r, 255);
        expect_near(pixel, srgb_from_linear(tone_mapped(Vec3f{light}, 1.0F)), 1);
        before = pixel.r;
    }
}

TEST_F(PostPassGl, BloomTakesTheSamePathToTheScreen) {
    // An even image blooms into itself: HDR image, six levels and tone map change nothing.
    RenderFrame frame = wall(unlit({0.6F, 0.3F, 0.1F}));
    frame.post = Post{.exposure = 1.5F};
    const Pixel direct = center(frame);
    frame.post->bloom = 0.2F;
    const Pixel bloomed = center(frame);
    EXPECT_NEAR(direct.r, bloomed.r, 2);
    EXPECT_NEAR(direct.g, bloomed.g, 2);
    EXPECT_NEAR(direct.b, bloomed.b, 2);
}

TEST_F(PostPassGl, LightBeyondWhiteIsKeptUntilTheExposureTakesIt) {
    RenderFrame frame = wall(unlit(Vec3f{3.0F}));
    EXPECT_EQ(center(frame).r, 255);
    frame.post = Post{.exposure = 0.1F};
    expect_near(center(frame), srgb_from_linear(tone_mapped(Vec3f{3.0F}, 0.1F)), 1);
}

/// A white half and a black half, the edge turned a little: stairs.
class EdgeGl : public ImageGl {
protected:
    RenderFrame slope() {
        RenderFrame frame = empty_frame(120, 90);
        frame.camera = camera_at(Vec3f{0.0F}, {0.0F, 0.0F, -1.0F});
        const auto mesh = library_.add_mesh("board", assets::box_mesh({20.0F, 10.0F, 0.1F}));
        const Mat4f turned = glm::rotate(Mat4f{1.0F}, 0.12F, Vec3f{0.0F, 0.0F, 1.0F});
        add_item(frame,
                 mesh,
                 unlit(Vec3f{1.0F}),
                 turned * glm::translate(Mat4f{1.0F}, Vec3f{0.0F, -5.0F, -4.0F}));
        return frame;
    }
    /// Pixels that are neither black nor white.
    static std::size_t greys(const assets::ImageData& image) {
        std::size_t count = 0;
        for (std::size_t i = 0; i < image.bytes.size(); i += 3) {
            if (image.bytes[i] > 8 && image.bytes[i] < 247) ++count;
        }
        return count;
    }
};

TEST_F(EdgeGl, FxaaTurnsStairsIntoGreysAndLeavesTheRest) {
    RenderFrame frame = slope();
    const auto plain = draw(frame);
    EXPECT_EQ(greys(plain), 0U);
    EXPECT_EQ(bytes_of("targets"), 120U * 90U * (4U + 4U));  // encoded as it is drawn
    frame.quality.anti_aliasing = AntiAliasing::Fxaa;
    const auto smooth = draw(frame);
    // One grey at least for each column of the edge, and none off it.
    EXPECT_GE(greys(smooth), 100U);
    EXPECT_LE(greys(smooth), 4U * 120U);
    EXPECT_EQ(bytes_of("targets"), 120U * 90U * (8U + 4U + 4U + 4U + 4U));
    std::size_t changed_off_edge = 0;
    for (std::uint32_t x = 0; x < 120; ++x) {
        for (const std::uint32_t y : {0U, 10U, 80U, 89U}) {
            if (pixel_at(plain, x, y).r != pixel_at(smooth, x, y).r) ++changed_off_edge;
        }
    }
    EXPECT_EQ(changed_off_edge, 0U);
}

TEST_F(EdgeGl, SamplesOfAPixelAreCountedAlongEdgesOnly) {
    RenderFrame frame = slope();
    const auto plain = draw(frame);
    frame.quality.anti_aliasing = AntiAliasing::Msaa4;
    const auto smooth = draw(frame);
    // The image, the scene's image and its four samples.
    EXPECT_EQ(bytes_of("targets"), 120U * 90U * (8U + 12U * 5U));
    EXPECT_GE(greys(smooth), 60U);
    for (std::uint32_t y = 0; y < 90; ++y) {
        for (std::uint32_t x = 0; x < 120; ++x) {
            const int code = pixel_at(smooth, x, y).r;
            const float quarters = 4.0F * linear_from_srgb(static_cast<float>(code) / 255.0F);
            EXPECT_NEAR(quarters, std::round(quarters), 0.05F) << x << " " << y;
            if (y < 20 || y > 70) {
                EXPECT_EQ(code, pixel_at(plain, x, y).r);
            }
        }
    }
    frame.quality.anti_aliasing = AntiAliasing::Off;
    EXPECT_EQ(draw(frame).bytes, plain.bytes);
    EXPECT_EQ(bytes_of("targets"), 120U * 90U * 8U);
}

TEST_F(EdgeGl, AMaskCoversSamplesWhereThereAreSeveral) {
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / "plumbline_mask_image.png";
    assets::ImageData mask{
        .width = 8, .height = 8, .format = assets::PixelFormat::Rgba8, .bytes = {}};
    for (int i = 0; i < 64; ++i) {
        mask.bytes.insert(mask.bytes.end(), 3, 255);
        mask.bytes.push_back(static_cast<std::uint8_t>((i % 8) * 36));
    }
    ASSERT_TRUE(assets::write_png(file, mask).ok());
    const auto leaf = library_.add_material({.name = "leaf",
                                             .shading = assets::Shading::Unlit,
                                             .base_color_map = file,
                                             .alpha_mode = assets::AlphaMode::Mask,
                                             .alpha_cutoff = 0.5F});
    RenderFrame frame = empty_frame(120, 90);
    frame.camera = camera_at(Vec3f{0.0F}, {0.0F, 0.0F, -1.0F});
    const auto mesh = library_.add_mesh("leaf", assets::box_mesh({3.0F, 3.0F, 0.01F}));
    add_item(
        frame,
        mesh,
        leaf,
        glm::rotate(
            glm::translate(Mat4f{1.0F}, Vec3f{0.0F, 0.0F, -4.0F}), 0.12F, Vec3f{0.0F, 0.0F, 1.0F}));
    const auto plain = draw(frame);
    EXPECT_EQ(greys(plain), 0U);
    frame.quality.anti_aliasing = AntiAliasing::Msaa4;
    const auto smooth = draw(frame);
    EXPECT_GE(greys(smooth), 60U);
    const auto light_of = [](const assets::ImageData& image) {
        float sum = 0.0F;
        for (std::size_t i = 0; i < image.bytes.size(); i += 3)
            sum += linear_from_srgb(static_cast<float>(image.bytes[i]) / 255.0F);
        return sum;
    };
    // The mask neither grows nor shrinks.
    EXPECT_NEAR(light_of(smooth), light_of(plain), 0.03F * light_of(plain));
    std::filesystem::remove(file);
}

TEST_F(EdgeGl, RenderScaleDrawsFewerPixelsAndLinesInFull) {
    RenderFrame frame = slope();
    frame.quality.render_scale = 0.5F;
    const auto half = draw(frame);
    EXPECT_EQ(half.width, 120U);
    EXPECT_EQ(renderer_->stats().scene_width_px, 60U);
    EXPECT_EQ(renderer_->stats().scene_height_px, 45U);
    EXPECT_EQ(pixel_at(half, 60, 5).r, 0);
    EXPECT_EQ(pixel_at(half, 60, 85).r, 255);
    // A line in front is one pixel wide in the image, not two.
    frame.lines.add({-5.0F, 1.0F, -3.0F}, {5.0F, 1.0F, -3.0F}, {1.0F, 0.0F, 0.0F});
    const auto lined = draw(frame);
    int red = 0;
    for (std::uint32_t y = 0; y < 90; ++y) {
        const Pixel pixel = pixel_at(lined, 60, y);
        if (pixel.r > 200 && pixel.g < 60) ++red;
    }
    EXPECT_EQ(red, 1);
    // One behind the board shows through faintly only: the depth came along.
    frame.lines = {};
    frame.lines.add({-5.0F, -1.0F, -6.0F}, {5.0F, -1.0F, -6.0F}, {1.0F, 0.0F, 0.0F});
    const auto hidden = draw(frame);
    int least_green = 255;
    for (std::uint32_t y = 50; y < 90; ++y) {
        least_green = std::min(least_green, pixel_at(hidden, 60, y).g);
    }
    EXPECT_NEAR(least_green, 204, 2);  // a fifth of the line
}

class PostPassSteps : public RendererGl {};

TEST_F(PostPassSteps, PostWithoutBloomNeedsNoMoreImages) {
    RenderFrame frame = sunny_box();
    frame.post = Post{};
    draw(frame);
    EXPECT_EQ(bytes_of("post"), 0U);
}

TEST_F(PostPassSteps, LightIsEncodedAlikeWhileItIsDrawnAndByAPassAfterIt) {
    RenderFrame frame = sunny_box();
    const auto direct = draw(frame);
    ASSERT_EQ(renderer_->stats().passes.back().name, "opaque");
    // Edges are smoothed in a pass of its own; the box's inside stays.
    frame.quality.anti_aliasing = AntiAliasing::Fxaa;
    const auto after = draw(frame);
    ASSERT_EQ(renderer_->stats().passes.back().name, "image");
    std::size_t different = 0;
    for (std::size_t i = 0; i < direct.bytes.size(); ++i)
        different += std::abs(direct.bytes[i] - after.bytes[i]) > 1 ? 1U : 0U;
    EXPECT_LT(different, direct.bytes.size() / 20);
}

}  // namespace
}  // namespace plumbline::render
