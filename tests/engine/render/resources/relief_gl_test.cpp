// Height maps and glass: where a mark on sunken ground is seen, and what a pane mirrors and lets through.
#include "engine/assets/image/image_import.h"
#include "tests/engine/render/image_fixture.h"
#include "tests/support/temporary_folder.h"

#include <cmath>

namespace plumbline::render {
namespace {

class ReliefGl : public ImageGl {
protected:
    static constexpr std::uint32_t kSide_px = 400;
    static constexpr int kTexels = 128;

    std::filesystem::path image(const char* name, auto&& code_at, int channels) {
        assets::ImageData data{
            .width = kTexels,
            .height = kTexels,
            .format = channels == 1 ? assets::PixelFormat::R8 : assets::PixelFormat::Rgb8,
            .bytes = {}};
        for (int y = 0; y < kTexels; ++y) {
            for (int x = 0; x < kTexels; ++x) {
                const Vec3f color = code_at(x, y);
                for (int c = 0; c < channels; ++c)
                    data.bytes.push_back(static_cast<std::uint8_t>(color[c]));
            }
        }
        const std::filesystem::path file = folder_.path() / name;
        EXPECT_TRUE(assets::write_png(file, data).ok());
        return file;
    }

    /// A square metre of ground with one bright line through its middle, along z or along x, all of it
    /// at `height` of the map; shows its own light only.
    assets::MaterialId ground(bool along_z, float height) {
        const auto line = image(
            along_z ? "z.png" : "x.png",
            [&](int x, int y) {
                const int at = along_z ? x : y;
                return Vec3f{std::abs(2 * at + 1 - kTexels) < 6 ? 255.0F : 0.0F};
            },
            3);
        const auto flat = image(
            "flat.png",
            [](int, int) {
                return Vec3f{128.0F, 128.0F, 255.0F};
            },
            3);
        const auto depth = image(("h" + std::to_string(height) + ".png").c_str(),
                                 [&](int, int) { return Vec3f{height * 255.0F}; },
                                 1);
        return library_.add_material({.name = "ground",
                                      .base_color_map = line,
                                      .normal_map = flat,
                                      .height_map = depth,
                                      .height_depth = 0.1F,
                                      .roughness = 1.0F});
    }

    /// The middle of the line in the row or column through the image's middle.
    static float line_px(const assets::ImageData& image, bool across) {
        double sum = 0.0;
        double weight = 0.0;
        for (std::uint32_t i = 0; i < kSide_px; ++i) {
            const Pixel p =
                across ? pixel_at(image, i, kSide_px / 2) : pixel_at(image, kSide_px / 2, i);
            if (p.g < 60) continue;
            sum += p.g * (i + 0.5);
            weight += p.g;
        }
        EXPECT_GT(weight, 0.0);
        return static_cast<float>(sum / weight);
    }

    RenderFrame seen_from(const Vec3f& eye, assets::MaterialId material) {
        RenderFrame frame = empty_frame(kSide_px, kSide_px);
        frame.camera = camera_at(eye, Vec3f{0.0F});
        frame.camera.fov_y_rad = radians_from_degrees(30.0F);
        frame.ambient = Vec3f{1.0F};
        add_item(frame,
                 library_.add_mesh("metre", assets::plane_mesh(Vec2f{1.0F})),
                 material,
                 Mat4f{1.0F});
        return frame;
    }

    test::TemporaryFolder folder_;
};

// A line on ground of height 0.4, 6 cm below the mesh, is seen where the pinhole shows a line there.
TEST_F(ReliefGl, AMarkOnLowGroundIsSeenWhereItLies) {
    constexpr float kHeight = 0.4F;
    constexpr float kDepth_m = 0.1F * (1.0F - kHeight);
    for (const bool along_z : {true, false}) {
        for (const float side : {1.2F, -1.2F}) {
            const Vec3f eye = along_z ? Vec3f{side, 1.2F, 0.0F} : Vec3f{0.0F, 1.2F, side};
            RenderFrame frame = seen_from(eye, ground(along_z, kHeight));
            const auto sunken = draw(frame);
            frame.quality.parallax = Drawn::Never;
            const auto flat = draw(frame);
            EXPECT_NEAR(line_px(flat, false), 0.5F * kSide_px, 1.0F);
            // The eye's ray to the line's middle, 6 cm below the origin.
            const Vec3f way = Vec3f{0.0F, -kDepth_m, 0.0F} - eye;
            const Vec3f forward = glm::normalize(-eye);
            const Vec3f up = frame.camera.orientation * Vec3f{0.0F, 1.0F, 0.0F};
            const float slope = glm::dot(way, up) / glm::dot(way, forward);
            const float expected_px =
                0.5F * kSide_px * (1.0F - slope / std::tan(0.5F * frame.camera.fov_y_rad));
            EXPECT_GT(expected_px, 0.5F * kSide_px + 10.0F);
            EXPECT_NEAR(line_px(sunken, false), expected_px, 1.5F) << along_z << ' ' << side;
        }
    }
}

TEST_F(ReliefGl, WhiteIsTheMeshItselfAndFarOffAllIsFlat) {
    RenderFrame frame = seen_from({1.2F, 1.2F, 0.0F}, ground(true, 1.0F));
    const auto high = draw(frame);
    frame.quality.parallax = Drawn::Never;
    EXPECT_NEAR(line_px(draw(frame), false), line_px(high, false), 0.2F);

    frame = seen_from({8.0F, 8.0F, 0.0F}, ground(true, 0.0F));
    frame.camera.fov_y_rad = radians_from_degrees(4.0F);
    const auto far = draw(frame);
    frame.quality.parallax = Drawn::Never;
    EXPECT_EQ(draw(frame).bytes, far.bytes);
}

class GlassGl : public ImageGl {
protected:
    assets::MaterialId pane(float ior, float alpha) {
        return library_.add_material({.name = "pane",
                                      .base_color = Vec3f{0.0F},
                                      .alpha = alpha,
                                      .roughness = 0.0F,
                                      .alpha_mode = assets::AlphaMode::Blend,
                                      .ior = ior});
    }

    /// Of a wall of light 0.5 behind a pane that is seen at such an angle, under light 0.8 from all over.
    float seen(assets::MaterialId material, float angle_rad, float behind) {
        RenderFrame frame = empty_frame(33, 33);
        frame.camera = camera_at({0.0F, 2.0F, 0.0F}, Vec3f{0.0F});
        frame.camera.fov_y_rad = 0.02F;
        frame.ambient = Vec3f{0.8F};
        add_box(frame, {20.0F, 0.1F, 20.0F}, {0.0F, -3.0F, 0.0F}, unlit(Vec3f{behind}));
        const auto mesh = library_.add_mesh("pane", assets::plane_mesh(Vec2f{1.0F}));
        add_item(
            frame, mesh, material, glm::rotate(Mat4f{1.0F}, angle_rad, Vec3f{1.0F, 0.0F, 0.0F}));
        const float c = static_cast<float>(pixel_at(draw(frame), 16, 16).g) / 255.0F;
        return std::pow((c + 0.055F) / 1.055F, 2.4F);
    }
};

// Both sides of a pane mirror, in turns: 2 F / (1 + F), F by Schlick.
TEST_F(GlassGl, APaneMirrorsAsFresnelSaysAndShowsTheRest) {
    for (const float angle_deg : {0.0F, 15.0F, 28.0F}) {
        const float angle = radians_from_degrees(angle_deg);
        const float m = 1.0F - std::cos(angle);
        const float side = 0.04F + 0.96F * std::pow(m, 5.0F);
        const float mirrors = 2.0F * side / (1.0F + side);
        EXPECT_NEAR(
            seen(pane(1.5F, 0.0F), angle, 0.5F), 0.8F * mirrors + 0.5F * (1.0F - mirrors), 0.006F)
            << angle_deg;
        EXPECT_NEAR(seen(pane(1.5F, 0.3F), angle, 0.5F),
                    0.8F * mirrors + 0.5F * 0.7F * (1.0F - mirrors),
                    0.006F)
            << angle_deg;
    }
}

TEST_F(GlassGl, WhatBendsNoLightIsNotSeen) {
    EXPECT_NEAR(seen(pane(1.0001F, 0.0F), 0.0F, 0.5F), 0.5F, 0.004F);
}

}  // namespace
}  // namespace plumbline::render
