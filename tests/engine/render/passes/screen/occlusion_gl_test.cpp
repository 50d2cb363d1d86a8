// Ambient occlusion against closed forms.
#include "engine/core/color.h"
#include "tests/engine/render/image_fixture.h"

#include <algorithm>
#include <cmath>

namespace plumbline::render {
namespace {

constexpr float kWallHeight_m = 0.4F;

class OcclusionGl : public ImageGl {
protected:
    /// A floor at y = 0 and, where there is one, a wall on it whose face is at z = 0; both go on beyond
    /// the image. Lit from everywhere.
    RenderFrame room(bool with_wall) {
        RenderFrame frame = empty_frame(960, 720);
        frame.camera = camera_at({0.0F, 5.5F, 5.5F}, {0.0F, 0.0F, 0.0F});
        frame.ambient = Vec3f{0.8F};
        const auto white = matt(Vec3f{1.0F});
        add_box(frame, {60.0F, 1.0F, 60.0F}, {0.0F, -0.5F, 0.0F}, white);
        if (with_wall)
            add_box(
                frame, {60.0F, kWallHeight_m, 2.0F}, {0.0F, 0.5F * kWallHeight_m, -1.0F}, white);
        return frame;
    }
    static RenderFrame occluded(RenderFrame frame) {
        frame.occlusion = AmbientOcclusion{.radius_m = 3.0F, .slices = 3, .steps = 24};
        return frame;
    }
    /// The share of its light that a place keeps in the second image.
    static float kept(const RenderFrame& frame,
                      const assets::ImageData& without,
                      const assets::ImageData& with,
                      const Vec3f& place_world) {
        const Camera& camera = frame.camera;
        const Vec3f seen =
            glm::conjugate(camera.orientation) * (place_world - camera.position_world);
        const float tan_y = std::tan(0.5F * camera.fov_y_rad);
        const auto height = static_cast<float>(frame.height_px);
        const auto x = static_cast<std::uint32_t>(0.5F * static_cast<float>(frame.width_px) +
                                                  0.5F * height * seen.x / (-seen.z * tan_y));
        const auto y =
            static_cast<std::uint32_t>(0.5F * height * (1.0F - seen.y / (-seen.z * tan_y)));
        return linear_from_srgb(static_cast<float>(pixel_at(with, x, y).g) / 255.0F) /
               linear_from_srgb(static_cast<float>(pixel_at(without, x, y).g) / 255.0F);
    }
};

// A wall of height h, seen from the ground d before it, hides (1 - d / sqrt(d^2 + h^2)) / 2 of the
// light: the form factor of an endless strip (Nusselt: half the disc less its projection).
TEST_F(OcclusionGl, TheFootOfAWallGetsWhatTheClosedFormSays) {
    const RenderFrame frame = room(true);
    const auto without = draw(frame);
    const auto with = draw(occluded(frame));
    for (const float d : {0.1F, 0.15F, 0.2F, 0.3F}) {
        const float open = 0.5F * (1.0F + d / std::hypot(d, kWallHeight_m));
        for (const float x : {-1.03F, 0.02F, 1.21F})
            EXPECT_NEAR(kept(frame, without, with, {x, 0.0F, d}), open, 0.05F) << d << " " << x;
    }
    // Beyond the radius nothing is taken away.
    EXPECT_GT(kept(frame, without, with, {0.0F, 0.0F, 3.1F}), 0.985F);
}

TEST_F(OcclusionGl, AnOpenPlaneKeepsItsLightHoweverFlatItIsSeen) {
    RenderFrame frame = room(false);
    for (const float height_m : {6.0F, 1.0F, 0.3F}) {
        frame.camera = camera_at({0.0F, height_m, 6.0F}, {0.0F, 0.0F, 0.0F});
        const auto without = draw(frame);
        const auto with = draw(occluded(frame));
        for (const float z : {0.0F, 2.0F, -3.0F})
            EXPECT_GT(kept(frame, without, with, {0.1F, 0.0F, z}), 0.985F) << height_m << " " << z;
    }
}

TEST_F(OcclusionGl, LightOfTheSunIsNotTakenAway) {
    RenderFrame frame = room(true);
    frame.ambient = Vec3f{0.0F};
    frame.sun = DirectionalLight{.direction_world = glm::normalize(Vec3f{0.2F, -1.0F, -0.4F})};
    const auto without = draw(frame);
    const auto with = draw(occluded(frame));
    // Encoded by the driver once, by the shader's fitted curve once.
    for (std::size_t i = 0; i < with.bytes.size(); ++i)
        ASSERT_LE(std::abs(int{with.bytes[i]} - int{without.bytes[i]}), 1) << i;
}

TEST_F(OcclusionGl, WhatHidesAPlaceHidesItsOcclusionToo) {
    RenderFrame frame = room(true);
    const auto glass = library_.add_material({.name = "glass",
                                              .shading = assets::Shading::Unlit,
                                              .base_color = Vec3f{0.5F},
                                              .alpha = 0.999F,
                                              .alpha_mode = assets::AlphaMode::Blend});
    add_box(frame, {20.0F, 0.01F, 20.0F}, {0.0F, 2.0F, 0.0F}, glass);
    const auto without = draw(frame);
    const auto with = draw(occluded(frame));
    EXPECT_NEAR(kept(frame, without, with, {0.0F, 0.0F, 0.05F}), 1.0F, 0.02F);
}

TEST_F(OcclusionGl, NobodyPaysUnaskedOrWhereItGaveWay) {
    RenderFrame frame = room(true);
    const auto plain = draw(frame);
    EXPECT_EQ(bytes_of("ambient_occlusion"), 0U);
    RenderFrame asked = occluded(frame);
    draw(asked);
    // Two images of half the width and height, two half floats a pixel.
    EXPECT_EQ(bytes_of("ambient_occlusion"), 2U * 480U * 360U * 4U);
    asked.quality.ambient_occlusion = Drawn::Never;
    EXPECT_EQ(draw(asked).bytes, plain.bytes);
    EXPECT_EQ(bytes_of("ambient_occlusion"), 0U);
    for (const PassTiming& pass : renderer_->stats().passes) EXPECT_NE(pass.name, "occlusion");
}

}  // namespace
}  // namespace plumbline::render
