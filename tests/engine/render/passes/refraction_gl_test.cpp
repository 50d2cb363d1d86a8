// What lies below water: where Snell's law puts it, as dark as the way through the water makes it, and lit
// by what the ripples gather.
#include "engine/core/color.h"
#include "tests/engine/render/image_fixture.h"

#include <cmath>

namespace plumbline::render {
namespace {

constexpr std::uint32_t kPoolSide_px = 400;
constexpr float kIndex = 1.33F;

class RefractionGl : public ImageGl {
protected:
    assets::MaterialId water(const Vec3f& color, float slope = 1e-6F, float caustics = 0.0F) {
        return library_.add_material({.name = "water",
                                      .base_color = color,
                                      .alpha = 0.5F,
                                      .roughness = 0.0F,
                                      .alpha_mode = assets::AlphaMode::Blend,
                                      .ripple_slope = slope,
                                      .attenuation_m = 2.0F,
                                      .caustics = caustics});
    }
    /// Level water at the origin, seen so far down from 4 m; nothing shines but what is drawn as light.
    RenderFrame pool(float down_rad, assets::MaterialId material) {
        RenderFrame frame = empty_frame(kPoolSide_px, kPoolSide_px);
        frame.camera =
            camera_at(Vec3f{0.0F, std::sin(down_rad), std::cos(down_rad)} * 4.0F, Vec3f{0.0F});
        frame.camera.fov_y_rad = 0.4F;
        frame.ambient = Vec3f{0.0F};
        const auto mesh = library_.add_mesh("level", assets::plane_mesh(Vec2f{40.0F}));
        add_item(frame, mesh, material, Mat4f{1.0F});
        frame.refraction = Refraction{};
        return frame;
    }
    void add_bed(
        RenderFrame& frame, float depth_m, float from_z, float to_z, assets::MaterialId material) {
        add_box(frame,
                {40.0F, 0.1F, to_z - from_z},
                {0.0F, -depth_m - 0.05F, 0.5F * (from_z + to_z)},
                material);
    }
    static float light_at(const assets::ImageData& image, std::uint32_t x, std::uint32_t y) {
        return linear_from_srgb(static_cast<float>(pixel_at(image, x, y).g) / 255.0F);
    }
    /// Rows from the upper edge to where light goes over into dark.
    static float edge_row(const assets::ImageData& image) {
        const std::uint32_t x = image.width / 2;
        const float half = 0.5F * (light_at(image, x, 4) + light_at(image, x, image.height - 5));
        for (std::uint32_t y = 1; y < image.height; ++y)
            if ((light_at(image, x, y) < half) != (light_at(image, x, y - 1) < half))
                return static_cast<float>(y);
        return -1.0F;
    }
};

float mirrored(float cosine) {
    return 0.02F + 0.98F * std::pow(1.0F - cosine, 5.0F);
}

TEST_F(RefractionGl, TheBedLiesWhereSnellsLawPutsIt) {
    for (const float down_rad : {0.6F, 0.9F, 1.3F}) {
        constexpr float kDepth_m = 0.3F;
        RenderFrame frame = pool(down_rad, water(Vec3f{1.0F}));
        // The edge that is seen at the origin: so far off as light in water goes.
        const float sine = std::cos(down_rad) / kIndex;
        const float off_m = kDepth_m * sine / std::sqrt(1.0F - sine * sine);
        add_bed(frame, kDepth_m, -20.0F, -off_m, unlit(Vec3f{0.6F}));
        add_bed(frame, kDepth_m, -off_m, 20.0F, unlit(Vec3f{0.1F}));
        EXPECT_NEAR(edge_row(draw(frame)), 0.5F * kPoolSide_px, 2.5F) << down_rad;
        // Unbent it is seen through another place.
        frame.quality.refraction = Drawn::Never;
        EXPECT_GT(std::abs(edge_row(draw(frame)) - 0.5F * kPoolSide_px), 4.0F) << down_rad;
    }
}

TEST_F(RefractionGl, WaterTakesItsColourWithItsDepth) {
    for (const float depth_m : {0.2F, 1.0F, 2.0F}) {
        const Vec3f color{0.1F, 0.4F, 0.7F};
        RenderFrame frame = pool(1.57F, water(color));
        add_bed(frame, depth_m, -20.0F, 20.0F, unlit(Vec3f{0.8F}));
        const Pixel seen = pixel_at(draw(frame), kPoolSide_px / 2, kPoolSide_px / 2);
        // Down and up again, of 2 m that leave the colour.
        const Vec3f left = glm::pow(color, Vec3f{depth_m}) * (0.8F * (1.0F - mirrored(1.0F)));
        EXPECT_NEAR(seen.r, code_of(left.x), 3) << depth_m;
        EXPECT_NEAR(seen.g, code_of(left.y), 3) << depth_m;
        EXPECT_NEAR(seen.b, code_of(left.z), 3) << depth_m;
    }
}

TEST_F(RefractionGl, WhatStandsBeforeTheWaterIsNotSeenInIt) {
    RenderFrame frame = pool(0.7F, water(Vec3f{1.0F}));
    add_bed(frame, 0.5F, -20.0F, 20.0F, unlit(Vec3f{0.2F}));
    const auto without = draw(frame);
    add_box(frame, {0.1F, 0.6F, 0.1F}, {0.0F, 0.3F, 0.8F}, unlit(Vec3f{1.0F}));
    const auto with = draw(frame);
    std::size_t post_px = 0;
    const auto is_post = [&](std::uint32_t x, std::uint32_t y) {
        return x < kPoolSide_px && y < kPoolSide_px && pixel_at(with, x, y).g == 255;
    };
    // Next to its edges light is looked up between two pixels; no other place sees it.
    const auto is_next_to_post = [&](std::uint32_t x, std::uint32_t y) {
        for (std::uint32_t dx = 0; dx < 5; ++dx)
            for (std::uint32_t dy = 0; dy < 5; ++dy)
                if (is_post(x + dx - 2, y + dy - 2)) return true;
        return false;
    };
    for (std::uint32_t x = 0; x < kPoolSide_px; ++x) {
        for (std::uint32_t y = 0; y < kPoolSide_px; ++y) {
            post_px += is_post(x, y);
            if (is_next_to_post(x, y)) continue;
            EXPECT_NEAR(pixel_at(with, x, y).g, pixel_at(without, x, y).g, 2) << x << ' ' << y;
        }
    }
    EXPECT_GT(post_px, 2000U);
}

TEST_F(RefractionGl, RipplesGatherTheSunAndLoseNoneOfIt) {
    const auto lit = [&](bool caustics, bool sun) {
        RenderFrame frame = pool(1.57F, water(Vec3f{1.0F}, 0.05F, 2.0F));
        frame.camera.fov_y_rad = 0.25F;
        if (sun)
            frame.sun =
                DirectionalLight{.direction_world = {0.0F, -1.0F, 0.0F}, .radiance = Vec3f{2.0F}};
        frame.refraction->caustics = caustics;
        add_bed(frame, 0.4F, -20.0F, 20.0F, unlit(Vec3f{0.3F}));
        return draw(frame);
    };
    const auto even = lit(false, true);
    const auto gathered = lit(true, true);
    double sum = 0;
    double even_sum = 0;
    float least = 1.0F;
    float most = 0.0F;
    for (std::uint32_t x = 0; x < kPoolSide_px; ++x) {
        for (std::uint32_t y = 0; y < kPoolSide_px; ++y) {
            const float light = light_at(gathered, x, y);
            sum += static_cast<double>(light);
            even_sum += static_cast<double>(light_at(even, x, y));
            least = std::min(least, light);
            most = std::max(most, light);
        }
    }
    EXPECT_NEAR(sum / even_sum, 1.0, 0.05);
    EXPECT_GT(most, 1.5F * least);
    EXPECT_EQ(lit(true, false).bytes, lit(false, false).bytes) << "without a sun";
}

TEST_F(RefractionGl, NobodyPaysUnasked) {
    RenderFrame frame = pool(0.7F, water(Vec3f{1.0F}));
    add_bed(frame, 0.5F, -20.0F, 20.0F, unlit(Vec3f{0.2F}));
    draw(frame);
    constexpr std::uint64_t kPixels = std::uint64_t{kPoolSide_px} * kPoolSide_px;
    EXPECT_EQ(bytes_of("refraction"), kPixels * (8 + 4));
    frame.refraction.reset();
    draw(frame);
    EXPECT_EQ(bytes_of("refraction"), 0U);
    for (const PassTiming& pass : renderer_->stats().passes) EXPECT_NE(pass.name, "refraction");
}

}  // namespace
}  // namespace plumbline::render
