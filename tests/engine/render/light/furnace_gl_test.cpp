// The furnace: what loses no light cannot be seen before a sky of one radiance all over.
#include "engine/assets/image/image_import.h"
#include "tests/engine/render/image_fixture.h"

#include <filesystem>

namespace plumbline::render {
namespace {

class FurnaceGl : public ImageGl {
protected:
    static constexpr std::uint32_t kSide_px = 96;
    static constexpr std::uint8_t kSkyCode = 188;  // half the light

    void SetUp() override {
        ImageGl::SetUp();
        folder_ = std::filesystem::temp_directory_path() /
                  (std::string{"plumbline_furnace_"} +
                   testing::UnitTest::GetInstance()->current_test_info()->name());
        std::filesystem::create_directories(folder_);
        const assets::ImageData face{.width = 4,
                                     .height = 4,
                                     .format = assets::PixelFormat::Rgb8,
                                     .bytes = std::vector<std::uint8_t>(48, kSkyCode)};
        for (const char* name : {"px", "nx", "py", "ny", "pz", "nz"}) {
            ASSERT_TRUE(assets::write_png(folder_ / (std::string(name) + ".png"), face).ok());
        }
    }
    void TearDown() override {
        renderer_.reset();
        std::filesystem::remove_all(folder_);
    }

    /// The largest difference of a pixel of the sphere from the sky, as a share of the sky's light.
    float largest_error(float metallic, float roughness) {
        const auto material = library_.add_material({.name = "white",
                                                     .base_color = Vec3f{1.0F},
                                                     .roughness = roughness,
                                                     .metallic = metallic});
        RenderFrame frame = empty_frame(kSide_px, kSide_px);
        frame.camera = camera_at({0.0F, 0.0F, 3.0F}, Vec3f{0.0F});
        frame.sky = Sky{.folder = folder_};
        const float sky = std::pow((kSkyCode / 255.0F + 0.055F) / 1.055F, 2.4F);
        frame.ambient = Vec3f{sky};
        add_item(
            frame, library_.add_mesh("ball", assets::sphere_mesh(1.0F)), material, Mat4f{1.0F});
        const auto image = draw(frame);
        float worst = 0.0F;
        for (std::uint32_t y = 0; y < kSide_px; ++y) {
            for (std::uint32_t x = 0; x < kSide_px; ++x) {
                const Pixel pixel = pixel_at(image, x, y);
                for (const int part : {pixel.r, pixel.g, pixel.b}) {
                    const float light =
                        std::pow((static_cast<float>(part) / 255.0F + 0.055F) / 1.055F, 2.4F);
                    worst = std::max(worst, std::abs(light / sky - 1.0F));
                }
            }
        }
        return worst;
    }

    std::filesystem::path folder_;
};

// A step of the image's codes is 1.2 % of this light: not one pixel is a step off.
TEST_F(FurnaceGl, AWhiteMattSphereIsNotSeen) {
    EXPECT_LT(largest_error(0.0F, 1.0F), 0.0095F);
    EXPECT_LT(largest_error(0.0F, 0.5F), 0.0095F);
}

TEST_F(FurnaceGl, ASphereOfRoughMetalIsNotSeen) {
    EXPECT_LT(largest_error(1.0F, 1.0F), 0.0095F);
    EXPECT_LT(largest_error(1.0F, 0.4F), 0.0095F);
}

}  // namespace
}  // namespace plumbline::render
