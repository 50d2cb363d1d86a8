// Skies of six faces in a folder of their own.
#pragma once

#include "engine/assets/image/image_import.h"
#include "tests/engine/render/gl_fixture.h"

#include <filesystem>
#include <string>

namespace plumbline::render {

class SkyGl : public GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        folder_ = std::filesystem::temp_directory_path() /
                  (std::string{"plumbline_sky_"} +
                   testing::UnitTest::GetInstance()->current_test_info()->name());
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override {
        renderer_.reset();
        std::filesystem::remove_all(folder_);
    }

    /// A face of one colour whose upper left quarter is white.
    void write_face(const std::string& name, const Pixel& color, std::uint32_t side = 8) {
        assets::ImageData image{
            .width = side, .height = side, .format = assets::PixelFormat::Rgb8, .bytes = {}};
        for (std::uint32_t y = 0; y < side; ++y) {
            for (std::uint32_t x = 0; x < side; ++x) {
                const bool corner = x < side / 2 && y < side / 2;
                for (const int part : {color.r, color.g, color.b}) {
                    image.bytes.push_back(static_cast<std::uint8_t>(corner ? 255 : part));
                }
            }
        }
        ASSERT_TRUE(assets::write_png(folder_ / (name + ".png"), image).ok());
    }

    RenderFrame looking(const Vec3f& direction) {
        RenderFrame frame = empty_frame(64, 64);
        frame.camera = camera_at(Vec3f{0.0F}, direction);
        frame.sky = Sky{folder_};
        return frame;
    }

    std::filesystem::path folder_;
};

inline void expect_color(const Pixel& seen, const Pixel& expected) {
    EXPECT_NEAR(seen.r, expected.r, 2);
    EXPECT_NEAR(seen.g, expected.g, 2);
    EXPECT_NEAR(seen.b, expected.b, 2);
}

}  // namespace plumbline::render
