// The computed sky as it is drawn: its colours are the model's, and what it lights is lit by it.
#include "engine/assets/image/image_import.h"
#include "engine/render/sky/computed_sky.h"
#include "tests/engine/render/image_fixture.h"
#include "tests/support/temporary_folder.h"

#include <cmath>

namespace plumbline::render {
namespace {

Vec3f at_height(float height_deg, float turn_deg) {
    const float height = radians_from_degrees(height_deg);
    const float turn = radians_from_degrees(turn_deg);
    return {std::cos(height) * std::cos(turn), std::sin(height), std::cos(height) * std::sin(turn)};
}

class GpuSkyDomeGl : public ImageGl {
protected:
    RenderFrame under(float sun_height_deg, float strength = 3.0F) {
        RenderFrame frame = empty_frame(33, 33);
        const Vec3f to_sun = at_height(sun_height_deg, 20.0F);
        frame.sun = DirectionalLight{.direction_world = -to_sun, .radiance = Vec3f{strength}};
        frame.sky = Sky{.folder = {}, .model = SkyModel{.to_sun_world = to_sun, .clouds = 0.0F}};
        sky_.want(*frame.sky->model, frame.sun->radiance);
        return frame;
    }
    Pixel seen(RenderFrame frame, const Vec3f& direction) {
        frame.camera = camera_at({3.0F, 2.0F, 1.0F}, Vec3f{3.0F, 2.0F, 1.0F} + direction);
        frame.camera.fov_y_rad = 0.02F;
        return center(frame);
    }

    ComputedSky sky_;
};

TEST_F(GpuSkyDomeGl, ShowsTheModelsRadianceAllOverTheDome) {
    for (const float sun_deg : {55.0F, 8.0F, -4.0F}) {
        const RenderFrame frame = under(sun_deg);
        for (const float height_deg : {3.0F, 20.0F, 50.0F, 85.0F}) {
            for (const float turn_deg : {80.0F, 170.0F, 290.0F}) {
                const Vec3f direction = at_height(height_deg, turn_deg);
                expect_near(seen(frame, direction), srgb_from_linear(sky_.radiance(direction)), 3);
            }
        }
    }
}

TEST_F(GpuSkyDomeGl, TheSunStandsWhereTheModelSaysAndIsWhite) {
    const RenderFrame frame = under(40.0F);
    const Pixel disc = seen(frame, at_height(40.0F, 20.0F));
    EXPECT_EQ(std::min({disc.r, disc.g, disc.b}), 255);
    EXPECT_LT(seen(frame, at_height(40.0F, 32.0F)).r, 255);
}

// Points of light do not shine through: behind a closed cover the sun's place is as dull as any other.
TEST_F(GpuSkyDomeGl, WhatIsBehindCloudsIsNotSeen) {
    const test::TemporaryFolder folder;
    constexpr std::uint32_t kSide = ComputedSky::kSide;
    assets::ImageData face{
        .width = kSide, .height = kSide, .format = assets::PixelFormat::Rgba8, .bytes = {}};
    for (std::uint32_t i = 0; i < kSide * kSide; ++i)
        face.bytes.insert(face.bytes.end(), {128, 128, 128, 255});
    for (const char* name : {"px.png", "nx.png", "py.png", "ny.png", "pz.png", "nz.png"})
        ASSERT_TRUE(assets::write_png(folder / name, face).ok());
    RenderFrame frame = under(40.0F, 0.3F);
    const Vec3f to_sun = at_height(40.0F, 20.0F);
    EXPECT_EQ(seen(frame, to_sun).g, 255);
    frame.sky->folder = folder.path();
    frame.sky->model->clouds = 1.0F;
    const Pixel covered = seen(frame, to_sun);
    EXPECT_LT(covered.g, 200);
    EXPECT_NEAR(covered.g, seen(frame, at_height(40.0F, 23.0F)).g, 6);
}

// Level white ground sends out what falls on it, over pi.
TEST_F(GpuSkyDomeGl, LightsTheGroundAsItsIrradianceSays) {
    for (const float sun_deg : {60.0F, 20.0F, -30.0F}) {
        RenderFrame frame = under(sun_deg, sun_deg > 0.0F ? 1.5F : 8.0F);
        add_box(frame, {40.0F, 1.0F, 40.0F}, {0.0F, -0.5F, 0.0F}, matt(Vec3f{1.0F}));
        frame.camera = camera_at({0.0F, 3.0F, 0.0F}, Vec3f{0.0F});
        const Vec3f expected = sky_.irradiance() * glm::one_over_pi<float>();
        const Pixel ground = center(frame);
        const Vec3f code = srgb_from_linear(expected) * 255.0F;
        EXPECT_NEAR(static_cast<float>(ground.r) / code.x, 1.0F, 0.05F) << sun_deg;
        EXPECT_NEAR(static_cast<float>(ground.g) / code.y, 1.0F, 0.05F) << sun_deg;
        EXPECT_NEAR(static_cast<float>(ground.b) / code.z, 1.0F, 0.05F) << sun_deg;
    }
}

TEST_F(GpuSkyDomeGl, ASunThatDoesNotReachTheGroundStillMakesTheSky) {
    RenderFrame frame = under(60.0F, 1.5F);
    add_box(frame, {40.0F, 1.0F, 40.0F}, {0.0F, -0.5F, 0.0F}, matt(Vec3f{1.0F}));
    const Vec3f down{0.0F, -1.0F, 0.01F};
    const Vec3f up = at_height(30.0F, 170.0F);
    const Pixel sky = seen(frame, up);
    const Pixel lit = seen(frame, down);
    frame.sun_reaches_ground = false;
    EXPECT_EQ(seen(frame, up).b, sky.b);
    const Pixel shaded = seen(frame, down);
    EXPECT_LT(shaded.g, lit.g / 2);
    EXPECT_GT(shaded.b, shaded.r) << "the sky's light is left";
}

TEST_F(GpuSkyDomeGl, HidesBehindThingsAndGoesWithTheFrameThatAsked) {
    RenderFrame frame = under(40.0F);
    add_box(frame, Vec3f{1.0F}, {0.0F, 0.0F, -2.0F}, unlit({1.0F, 0.0F, 0.0F}));
    frame.camera = camera_at(Vec3f{0.0F}, {0.0F, 0.0F, -1.0F});
    EXPECT_EQ(center(frame).g, 0);
    EXPECT_GT(bytes_of("sky"), 0U);
    frame.sky.reset();
    draw(frame);
    EXPECT_EQ(bytes_of("sky"), 0U);
}

TEST_F(GpuSkyDomeGl, WithoutASunItIsNight) {
    RenderFrame frame = under(-90.0F);
    frame.sun.reset();
    frame.sky->model->to_sun_world = {0.0F, -1.0F, 0.0F};
    const Pixel overhead = seen(frame, {0.3F, 0.9F, 0.1F});
    EXPECT_LT(overhead.g, 60);
}

// What is far goes over into the sky behind it, what is near does not.
TEST_F(GpuSkyDomeGl, DistanceGoesOverIntoTheHorizon) {
    RenderFrame frame = under(50.0F);
    frame.sky->model->visibility_m = 200.0F;
    const auto seen_at = [&](float distance_m) {
        RenderFrame each = frame;
        add_box(each, Vec3f{4.0F}, {0.0F, 0.0F, -distance_m - 2.0F}, unlit(Vec3f{0.0F}));
        each.camera = camera_at(Vec3f{0.0F}, {0.0F, 0.0F, -1.0F});
        each.camera.far_m = 5000.0F;
        each.camera.fov_y_rad = 0.001F;
        return center(each);
    };
    EXPECT_EQ(seen_at(15.0F).g, 0);
    const auto horizon = sky_.horizon();
    const float cosine = glm::dot(Vec2f{0.0F, -1.0F}, sky_.light_heading());
    const Vec3f behind = horizon[0] + cosine * (horizon[1] + cosine * horizon[2]);
    // 100 m beyond the first 20: exp(-3.912 / 2) of the black is left.
    const float left = std::exp(-3.912F * 100.0F / 200.0F);
    expect_near(seen_at(120.0F), srgb_from_linear(behind * (1.0F - left)), 3);
    expect_near(seen_at(1500.0F), srgb_from_linear(behind), 3);
}

}  // namespace
}  // namespace plumbline::render
