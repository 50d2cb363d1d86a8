// Small images against stored ones, for what no closed form predicts: how it all looks together.
// PL_UPDATE_GOLDEN=1 writes the stored ones anew; look at them before committing.
#include "engine/assets/image/image_import.h"
#include "tests/engine/render/gl_fixture.h"

#include <cstdlib>
#include <filesystem>

namespace plumbline::render {
namespace {

namespace fs = std::filesystem;

// Software GL of another Mesa version rounds texture filters and square roots differently, and a
// sample may fall on the other side of an edge: single pixels differ much, the average little.
constexpr double kMeanTolerance = 1.0;
constexpr int kPixelTolerance = 24;
constexpr double kPixelsOverTolerance = 0.01;

struct Difference {
    double mean{0};
    double share_over{0};
    assets::ImageData image;
};

Difference difference_of(const assets::ImageData& a, const assets::ImageData& b) {
    Difference result;
    result.image = a;
    std::size_t over = 0;
    for (std::size_t i = 0; i < a.bytes.size(); ++i) {
        const int apart = std::abs(static_cast<int>(a.bytes[i]) - static_cast<int>(b.bytes[i]));
        result.mean += apart;
        if (apart > kPixelTolerance) ++over;
        result.image.bytes[i] = static_cast<std::uint8_t>(std::min(apart * 8, 255));
    }
    result.mean /= static_cast<double>(a.bytes.size());
    result.share_over = static_cast<double>(over) / static_cast<double>(a.bytes.size());
    return result;
}

class Golden : public GlTest {
protected:
    /// A yard with boxes, a ball and a low wall.
    RenderFrame yard() {
        RenderFrame frame = empty_frame(320, 180);
        frame.camera = camera_at({4.0F, 2.6F, 6.0F}, {0.0F, 0.6F, 0.0F});
        frame.clear_color = {0.5F, 0.65F, 0.85F};
        frame.ambient = {0.16F, 0.18F, 0.22F};
        add_box(frame, {60.0F, 1.0F, 60.0F}, {0.0F, -0.5F, 0.0F}, matt({0.35F, 0.45F, 0.25F}));
        add_box(frame, Vec3f{1.0F}, {0.0F, 0.5F, 0.0F}, matt({0.7F, 0.45F, 0.25F}));
        add_box(frame, Vec3f{1.0F}, {-1.8F, 0.5F, -1.0F}, matt({0.6F, 0.2F, 0.15F}));
        add_box(frame, {5.0F, 0.8F, 0.3F}, {0.0F, 0.4F, -3.0F}, matt(Vec3f{0.7F}));
        const auto ball = library_.add_mesh("ball", assets::sphere_mesh(0.6F));
        const auto brass = library_.add_material({.name = "brass",
                                                  .base_color = {0.9F, 0.7F, 0.3F},
                                                  .roughness = 0.35F,
                                                  .metallic = 1.0F});
        add_item(frame, ball, brass, glm::translate(Mat4f{1.0F}, Vec3f{1.8F, 0.6F, 0.6F}));
        frame.post = Post{.exposure = 1.0F};
        return frame;
    }

    void add_sun(RenderFrame& frame) {
        frame.sun = DirectionalLight{.direction_world = glm::normalize(Vec3f{-0.6F, -0.8F, -0.35F}),
                                     .radiance = {3.4F, 3.2F, 2.8F}};
        frame.sun_shadow = SunShadow{.size_px = 2048, .distance_m = 30.0F};
    }

    void compare(const std::string& name, const RenderFrame& frame) {
        const auto got = draw(frame);
        const fs::path stored = fs::path{PL_SOURCE_DIR "/tests/golden"} / (name + ".png");
        if (std::getenv("PL_UPDATE_GOLDEN") != nullptr) {
            ASSERT_TRUE(assets::write_png(stored, got).ok());
            return;
        }
        const auto want = assets::import_image(stored);
        ASSERT_TRUE(want.ok()) << want.error().message;
        ASSERT_EQ(want->bytes.size(), got.bytes.size());
        const Difference difference = difference_of(*want, got);
        EXPECT_LE(difference.mean, kMeanTolerance);
        EXPECT_LE(difference.share_over, kPixelsOverTolerance);
        if (!HasFailure()) return;
        const fs::path folder = PL_BINARY_DIR "/golden";
        fs::create_directories(folder);
        (void)assets::write_png(folder / (name + "_want.png"), *want);
        (void)assets::write_png(folder / (name + "_got.png"), got);
        (void)assets::write_png(folder / (name + "_difference.png"), difference.image);
        ADD_FAILURE() << "the images are in " << folder.string();
    }
};

TEST_F(Golden, YardInTheSun) {
    RenderFrame frame = yard();
    add_sun(frame);
    compare("yard_in_the_sun", frame);
}

TEST_F(Golden, YardInFogWithBloom) {
    RenderFrame frame = yard();
    add_sun(frame);
    frame.fog = Fog{.color = {0.6F, 0.66F, 0.72F}, .density_per_m = 0.06F};
    frame.post->bloom = 0.08F;
    compare("yard_in_fog_with_bloom", frame);
}

TEST_F(Golden, YardByFlashlight) {
    RenderFrame frame = yard();
    frame.clear_color = Vec3f{0.005F};
    frame.ambient = Vec3f{0.01F};
    const Vec3f forward = frame.camera.orientation * Vec3f{0.0F, 0.0F, -1.0F};
    frame.flashlight =
        Flashlight{.position_world = frame.camera.position_world + Vec3f{0.3F, -0.3F, 0.0F},
                   .direction_world = forward};
    compare("yard_by_flashlight", frame);
}

}  // namespace
}  // namespace plumbline::render
