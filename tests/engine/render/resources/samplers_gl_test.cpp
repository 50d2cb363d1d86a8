// How fine textures are where the image is scaled up.
#include "engine/assets/image/image_import.h"
#include "tests/engine/render/image_fixture.h"

#include <cmath>
#include <filesystem>

namespace plumbline::render {
namespace {

class SamplersGl : public ImageGl {};

// White noise halves its spread with each level of detail. Four texels to a pixel that is shown: the third
// level. Drawn at half the size it would be the fourth, and scaling up leaves 0.6 of the spread: 0.3 in all.
TEST_F(SamplersGl, ScaledUpImagesHaveTexturesAsFineAsTheSizeShown) {
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / "plumbline_noise_image.png";
    assets::ImageData noise{
        .width = 512, .height = 512, .format = assets::PixelFormat::Rgb8, .bytes = {}};
    std::uint32_t state = 1;
    while (noise.bytes.size() < std::size_t{512} * 512 * 3) {
        state = state * 1664525U + 1013904223U;
        const std::uint8_t code = (state >> 24U) < 128U ? 96 : 160;
        noise.bytes.insert(noise.bytes.end(), 3, code);
    }
    ASSERT_TRUE(assets::write_png(file, noise).ok());
    const auto material = library_.add_material(
        {.name = "noise", .shading = assets::Shading::Unlit, .base_color_map = file});
    RenderFrame frame = empty_frame(128, 128);
    frame.camera = camera_at({0.0F, 10.0F, 0.0F}, Vec3f{0.0F});
    // A metre of the plane is once the image: 128 px show 512 texels.
    frame.camera.fov_y_rad = 2.0F * std::atan(0.05F);
    add_item(
        frame, library_.add_mesh("plane", assets::plane_mesh(Vec2f{4.0F})), material, Mat4f{1.0F});
    // Moved by half a texel of the third level, a pixel of the smaller image has its middle on one, too.
    const auto spread = [&](float render_scale, float moved_m) {
        frame.quality.render_scale = render_scale;
        frame.items.front().world_from_body[3] = Vec4f{moved_m, 0.0F, moved_m, 1.0F};
        const auto image = draw(frame);
        double sum = 0.0;
        double square = 0.0;
        for (std::uint32_t i = 0; i < 128 * 128; ++i) {
            const double code = pixel_at(image, i % 128, i / 128).g;
            sum += code / (128 * 128);
            square += code * code / (128 * 128);
        }
        return std::sqrt(square - sum * sum);
    };
    const double whole = spread(1.0F, 0.0F);
    EXPECT_GT(whole, 4.0);
    EXPECT_GT(spread(0.5F, 2.0F / 512.0F), 0.5 * whole);
    std::filesystem::remove(file);
}

}  // namespace
}  // namespace plumbline::render
