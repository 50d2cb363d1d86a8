// What the wind moves, and water that mirrors: images that are known beforehand.
#include "engine/assets/image/image_import.h"
#include "tests/engine/render/image_fixture.h"

#include <filesystem>

namespace plumbline::render {
namespace {

class SwayGl : public ImageGl {
protected:
    /// A white strip 0.2 m wide before the dark, 2 m ahead: its foot stands, its top sways.
    RenderFrame strip(const assets::WindWeights& top) {
        assets::MeshData mesh;
        for (const float y : {-0.5F, 0.5F}) {
            for (const float x : {-0.1F, 0.1F}) {
                mesh.vertices.push_back({.position_body = {x, y, 0.0F},
                                         .normal_body = {0.0F, 0.0F, 1.0F},
                                         .wind = y > 0.0F ? top : assets::WindWeights{}});
            }
        }
        mesh.indices = {0, 1, 3, 0, 3, 2};
        mesh.sub_meshes = {{.first_index = 0, .index_count = 6}};
        mesh.bounds = assets::bounds_of(mesh);
        RenderFrame frame = empty_frame(128, 128);
        frame.camera = camera_at(Vec3f{0.0F}, {0.0F, 0.0F, -1.0F});
        add_item(frame,
                 library_.add_mesh("strip " + std::to_string(meshes_++), mesh),
                 unlit(Vec3f{1.0F}),
                 glm::translate(Mat4f{1.0F}, Vec3f{0.0F, 0.0F, -2.0F}));
        return frame;
    }
    /// Middle of what is lit in a row, px right of the image's middle.
    static float middle_of_row(const assets::ImageData& image, std::uint32_t y) {
        float sum = 0.0F;
        float count = 0.0F;
        for (std::uint32_t x = 0; x < image.width; ++x) {
            if (pixel_at(image, x, y).g < 100) continue;
            sum += static_cast<float>(x) + 0.5F;
            count += 1.0F;
        }
        return count > 0.0F ? sum / count - 0.5F * static_cast<float>(image.width) : -1e3F;
    }

    int meshes_{0};
};

TEST_F(SwayGl, ATipIsCarriedAsTheSquareOfTheWindAndTheFootStays) {
    RenderFrame frame = strip({.sway = 255});
    // At 2 m a metre is 55.4 px; the top is at row 36, the foot at row 91.
    EXPECT_NEAR(middle_of_row(draw(frame), 40), 0.0F, 0.6F) << "no wind";
    frame.wind = Wind{.mean_mps = {5.0F, 0.0F}};
    const assets::ImageData blown = draw(frame);
    // 0.25 m at the very top, which is 0.0735 m lower then: at row 44 the strip is 0.94 of the way up.
    EXPECT_NEAR(middle_of_row(blown, 44), 0.93F * 0.25F * 55.4F, 1.2F);
    EXPECT_NEAR(middle_of_row(blown, 89), 0.0F, 1.0F);
}

TEST_F(SwayGl, AGaleBendsNoFurtherThanAStrongWind) {
    RenderFrame frame = strip({.sway = 128});
    frame.wind = Wind{.mean_mps = {15.0F, 0.0F}};
    const assets::ImageData strong = draw(frame);
    EXPECT_GT(middle_of_row(strong, 50), 10.0F);
    frame.wind = Wind{.mean_mps = {1000.0F, 0.0F}};
    EXPECT_EQ(draw(frame).bytes, strong.bytes);
}

TEST_F(SwayGl, WhatHasNoWeightsStandsAndAsksForNoOtherShader) {
    RenderFrame frame = strip({});
    const assets::ImageData still = draw(frame);
    frame.wind = Wind{.mean_mps = {9.0F, 0.0F}};
    frame.time_s = 3.0F;
    EXPECT_EQ(draw(frame).bytes, still.bytes);
}

TEST_F(SwayGl, GustsPassOverTime) {
    RenderFrame frame = strip({.sway = 255});
    frame.wind = Wind{.mean_mps = {4.0F, 0.0F}};
    // A wave across z blows along x: 4 and 0 m/s at its crests.
    frame.wind->gusts[0] = {.number_radpm = {0.0F, -1.0F}, .phase_rad = 0.0F, .speed_mps = 4.0F};
    const auto at_phase = [&](float phase_rad) {
        // The strip is at z = -2, which is 2 rad on.
        frame.wind->gusts[0].phase_rad = phase_rad - 2.0F;
        return middle_of_row(draw(frame), 70);
    };
    const float strong = at_phase(glm::half_pi<float>());
    const float weak = at_phase(-glm::half_pi<float>());
    EXPECT_GT(strong, 8.0F) << "8 m/s";
    EXPECT_NEAR(weak, 0.0F, 0.6F) << "calm";
}

class WaterGl : public ImageGl {
protected:
    void SetUp() override {
        GlTest::SetUp();
        folder_ = std::filesystem::temp_directory_path() /
                  (std::string{"plumbline_water_"} +
                   testing::UnitTest::GetInstance()->current_test_info()->name());
        std::filesystem::create_directories(folder_);
        assets::ImageData face{
            .width = 8, .height = 8, .format = assets::PixelFormat::Rgb8, .bytes = {}};
        face.bytes.assign(8 * 8 * 3, 255);
        for (const char* name : {"px", "nx", "py", "ny", "pz", "nz"})
            ASSERT_TRUE(assets::write_png(folder_ / (std::string(name) + ".png"), face).ok());
    }
    void TearDown() override {
        renderer_.reset();
        std::filesystem::remove_all(folder_);
    }
    /// Black water under a white sky, over a bright bed; seen so far down.
    RenderFrame pool(float down_rad, float slope = 1e-4F) {
        RenderFrame frame = empty_frame(33, 33);
        frame.camera =
            camera_at(Vec3f{0.0F}, Vec3f{0.0F, -std::sin(down_rad), -std::cos(down_rad)} * 4.0F);
        frame.camera.fov_y_rad = 0.02F;
        frame.sky = Sky{folder_};
        const auto water = library_.add_material({.name = "water",
                                                  .base_color = Vec3f{0.0F},
                                                  .alpha = 0.5F,
                                                  .roughness = 0.0F,
                                                  .alpha_mode = assets::AlphaMode::Blend,
                                                  .ripple_slope = slope});
        const float depth_m = 4.0F * std::sin(down_rad);
        add_box(frame, {60.0F, 1.0F, 60.0F}, {0.0F, -depth_m - 0.5F, 0.0F}, water);
        add_box(frame, {60.0F, 0.1F, 60.0F}, {0.0F, -depth_m - 1.2F, 0.0F}, unlit(Vec3f{0.4F}));
        return frame;
    }
    std::filesystem::path folder_;
};

float schlick(float cosine) {
    return 0.02F + 0.98F * std::pow(1.0F - cosine, 5.0F);
}

TEST_F(WaterGl, MirrorsByFresnelAndShowsItsBedWhereItDoesNot) {
    const auto expected = [](float mirrors, float mirrored) {
        return code_of(mirrors * mirrored + (1.0F - mirrors) * 0.5F * 0.4F);
    };
    for (const float down_rad : {1.5F, 0.8F, 0.5F}) {
        const float mirrors = schlick(std::sin(down_rad));
        EXPECT_NEAR(center(pool(down_rad)).g, expected(mirrors, 1.0F), 4) << down_rad;
    }
    // Flat along the water it mirrors what stands round it, not the sky.
    const int flat = center(pool(0.05F)).g;
    EXPECT_NEAR(flat, expected(schlick(std::sin(0.05F)), 0.0F), 6);
}

TEST_F(WaterGl, RipplesRunInTime) {
    RenderFrame frame = pool(0.3F, 0.2F);
    frame.camera.fov_y_rad = 0.5F;
    const assets::ImageData now = draw(frame);
    EXPECT_EQ(draw(frame).bytes, now.bytes) << "the same time";
    frame.time_s = 0.2F;
    EXPECT_NE(draw(frame).bytes, now.bytes);
}

TEST_F(WaterGl, VariationKeepsTheMeanAndAnEvenMapAsItIs) {
    assets::ImageData map{
        .width = 8, .height = 8, .format = assets::PixelFormat::Rgb8, .bytes = {}};
    map.bytes.assign(8 * 8 * 3, 128);
    ASSERT_TRUE(assets::write_png(folder_ / "even.png", map).ok());
    const auto lawn = [&](float variation) {
        return library_.add_material({.name = "lawn",
                                      .base_color_map = folder_ / "even.png",
                                      .roughness = 1.0F,
                                      .variation = variation});
    };
    RenderFrame plain = wall(lawn(0.0F));
    plain.ambient = Vec3f{0.8F};
    RenderFrame varied = wall(lawn(1.0F));
    varied.ambient = plain.ambient;
    EXPECT_NEAR(center(varied).g, center(plain).g, 1);
}

}  // namespace
}  // namespace plumbline::render
