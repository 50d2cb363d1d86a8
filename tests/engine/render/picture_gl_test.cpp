// Pictures whose colours can be computed by hand.
#include "engine/assets/image_import.h"
#include "tests/engine/render/display_color.h"
#include "tests/engine/render/gl_fixture.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace plumbline::render {
namespace {

int code_of(float light) {
    return static_cast<int>(std::lround(srgb_from_linear(Vec3f{light}).x * 255.0F));
}

void expect_near(const Pixel& pixel, const Vec3f& code, int tolerance) {
    EXPECT_NEAR(pixel.r, code.x * 255.0F, tolerance);
    EXPECT_NEAR(pixel.g, code.y * 255.0F, tolerance);
    EXPECT_NEAR(pixel.b, code.z * 255.0F, tolerance);
}

class PictureGl : public GlTest {
protected:
    /// A wall 2 m ahead that fills the picture.
    RenderFrame wall(assets::MaterialId material, float distance_m = 2.0F) {
        RenderFrame frame = empty_frame(33, 33);
        frame.camera = camera_at(Vec3f{0.0F}, {0.0F, 0.0F, -1.0F});
        const float size_m = distance_m * 4.0F;
        add_box(frame, {size_m, size_m, 1.0F}, {0.0F, 0.0F, -distance_m - 0.5F}, material);
        return frame;
    }
    Pixel center(const RenderFrame& frame) { return pixel_at(draw(frame), 16, 16); }
};

TEST_F(PictureGl, UnlitColoursComeOutAsSrgb) {
    for (const float light : {0.0F, 0.002F, 0.02F, 0.18F, 0.5F, 1.0F}) {
        const Pixel pixel = center(wall(unlit(Vec3f{light})));
        // The shader's fitted curve may round the other way.
        EXPECT_NEAR(pixel.r, code_of(light), 1) << light;
        EXPECT_EQ(pixel.r, pixel.g);
        EXPECT_EQ(pixel.r, pixel.b);
    }
}

TEST_F(PictureGl, ClearColourComesOutAsSrgb) {
    RenderFrame frame = empty_frame(8, 8);
    frame.clear_color = {0.5F, 0.7F, 0.9F};
    expect_near(pixel_at(draw(frame), 4, 4), srgb_from_linear(frame.clear_color), 1);
}

TEST_F(PictureGl, AmbientLightAloneGivesAlbedoTimesAmbient) {
    RenderFrame frame = wall(matt({0.5F, 0.25F, 0.1F}));
    frame.ambient = Vec3f{0.8F};
    // A dielectric mirrors up to a twenty-fifth of it on top; a matt one nothing more.
    const Pixel pixel = center(frame);
    expect_near(pixel, srgb_from_linear(Vec3f{0.432F, 0.232F, 0.112F}), 2);
}

TEST_F(PictureGl, FogIsTheClosedForm) {
    const float distance_m = 20.0F;
    RenderFrame frame = wall(unlit({0.9F, 0.1F, 0.1F}), distance_m);
    frame.fog = Fog{.color = {0.2F, 0.4F, 0.8F}, .density_per_m = 0.03F};
    const float through = std::exp(-std::pow(0.03F * distance_m, 2.0F));
    const Vec3f expected = frame.fog->color * (1.0F - through) + Vec3f{0.9F, 0.1F, 0.1F} * through;
    expect_near(center(frame), srgb_from_linear(expected), 1);
}

TEST_F(PictureGl, ToneCurveRisesStaysBelowOneAndAgreesWithTheCpu) {
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

TEST_F(PictureGl, BloomTakesTheSamePathToTheScreen) {
    // An even picture blooms into itself: HDR image, six levels and tone map change nothing.
    RenderFrame frame = wall(unlit({0.6F, 0.3F, 0.1F}));
    frame.post = Post{.exposure = 1.5F};
    const Pixel direct = center(frame);
    frame.post->bloom = 0.2F;
    const Pixel bloomed = center(frame);
    EXPECT_NEAR(direct.r, bloomed.r, 2);
    EXPECT_NEAR(direct.g, bloomed.g, 2);
    EXPECT_NEAR(direct.b, bloomed.b, 2);
}

TEST_F(PictureGl, GlassBlendsOverWhatIsBehind) {
    RenderFrame frame = wall(unlit({1.0F, 1.0F, 1.0F}));
    const auto glass = library_.add_material({.name = "glass",
                                              .shading = assets::Shading::Unlit,
                                              .base_color = Vec3f{0.0F},
                                              .alpha = 0.5F,
                                              .alpha_mode = assets::AlphaMode::Blend});
    add_box(frame, {4.0F, 4.0F, 0.1F}, {0.0F, 0.0F, -1.0F}, glass);
    // Half of the light, not half of the code: 188, not 128. With a tone curve and without.
    EXPECT_NEAR(center(frame).r, code_of(0.5F), 1);
    frame.post = Post{.exposure = 1.0F};
    expect_near(center(frame), srgb_from_linear(tone_mapped(Vec3f{0.5F}, 1.0F)), 1);
}

TEST_F(PictureGl, LightBeyondWhiteIsKeptUntilTheExposureTakesIt) {
    RenderFrame frame = wall(unlit(Vec3f{3.0F}));
    EXPECT_EQ(center(frame).r, 255);
    frame.post = Post{.exposure = 0.1F};
    expect_near(center(frame), srgb_from_linear(tone_mapped(Vec3f{3.0F}, 0.1F)), 1);
}

/// A white half and a black half, the edge turned a little: stairs.
class EdgeGl : public PictureGl {
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
    EXPECT_EQ(bytes_of("targets"), 120U * 90U * (8U + 4U + 4U + 4U));
    frame.quality.fxaa = true;
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

TEST_F(EdgeGl, RenderScaleDrawsFewerPixelsAndLinesInFull) {
    RenderFrame frame = slope();
    frame.quality.render_scale = 0.5F;
    const auto half = draw(frame);
    EXPECT_EQ(half.width, 120U);
    EXPECT_EQ(renderer_->stats().scene_width_px, 60U);
    EXPECT_EQ(renderer_->stats().scene_height_px, 45U);
    EXPECT_EQ(pixel_at(half, 60, 5).r, 0);
    EXPECT_EQ(pixel_at(half, 60, 85).r, 255);
    // A line in front is one pixel wide in the picture, not two.
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

// EXPERIENCE G21
TEST_F(PictureGl, ImagesLargerThanTheDriverTakesAreHalvedUntilTheyFit) {
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / "plumbline_large_image.png";
    assets::ImageData stripes{.width = 256,
                              .height = 64,
                              .format = assets::PixelFormat::Rgb8,
                              .bytes = std::vector<std::uint8_t>(256 * 64 * 3, 200)};
    ASSERT_TRUE(assets::write_png(file, stripes).ok());
    const auto material = library_.add_material(
        {.name = "stripes", .shading = assets::Shading::Unlit, .base_color_map = file});
    const RenderFrame frame = wall(material);
    const Pixel whole = center(frame);
    const std::uint64_t before = bytes_of("textures");
    make_renderer(PL_SOURCE_DIR "/shaders", {.texture_px = 64});
    const Pixel halved = center(frame);
    EXPECT_NEAR(halved.r, whole.r, 1);
    EXPECT_NEAR(whole.r, 200, 1);
    // 256 x 64 with all levels is a little over 4/3 of 65536; 64 x 16 a sixteenth of it.
    EXPECT_NEAR(
        static_cast<double>(bytes_of("textures")) / static_cast<double>(before), 1.0 / 16.0, 0.001);
    std::filesystem::remove(file);
}

/// Ground, a box of 2 m on it, and a sun whose shadow of the box can be computed.
class ShadowGl : public PictureGl {
protected:
    static constexpr std::uint32_t kSide_px = 300;
    static constexpr float kHalf_m = 6.0F;

    void SetUp() override {
        PictureGl::SetUp();
        frame_ = empty_frame(kSide_px, kSide_px);
        // From high above with a narrow lens: nearly a map.
        frame_.camera = camera_at({0.0F, 60.0F, 0.0F}, Vec3f{0.0F});
        frame_.camera.fov_y_rad = 2.0F * std::atan(kHalf_m / 60.0F);
        add_box(frame_, {40.0F, 1.0F, 40.0F}, {0.0F, -0.5F, 0.0F}, matt(Vec3f{0.8F}));
        add_box(frame_, Vec3f{2.0F}, {0.0F, 1.0F, 0.0F}, matt({0.8F, 0.1F, 0.1F}));
        frame_.sun = DirectionalLight{.direction_world = glm::normalize(Vec3f{1.0F, -1.0F, 0.0F}),
                                      .radiance = Vec3f{3.0F}};
        frame_.sun_shadow = SunShadow{.size_px = 2048, .distance_m = 80.0F};
    }

    /// Acne would darken single pixels of the lit ground, at any height of the sun.
    void expect_no_specks() {
        for (const float height : {0.25F, 0.6F, 3.0F}) {
            frame_.sun->direction_world = glm::normalize(Vec3f{1.0F, -height, 0.37F});
            const auto image = draw(frame_);
            const int lit = ground(image, -5.0F, -5.0F);
            for (float z = -5.5F; z < 5.5F; z += 0.1F) {
                for (float x = -5.5F; x < -1.3F; x += 0.1F) {
                    ASSERT_NEAR(ground(image, x, z), lit, 4) << x << ' ' << z << ' ' << height;
                }
            }
        }
    }

    /// How bright the ground is at (x, z), 0 to 255.
    int ground(const assets::ImageData& image, float x, float z) const {
        const auto pixel = [](float at_m) {
            return static_cast<std::uint32_t>((at_m + kHalf_m) / (2.0F * kHalf_m) * kSide_px);
        };
        return pixel_at(image, pixel(x), pixel(z)).g;
    }

    RenderFrame frame_;
};

TEST_F(ShadowGl, LiesWhereGeometryPutsIt) {
    // 45 degrees: the box from x = -1 to 1, 2 m high, shades the ground from its foot at x = 1
    // to x = 3. The map's texel is under 7 cm here.
    const auto image = draw(frame_);
    const int lit = ground(image, -3.0F, 0.0F);
    const int shaded = ground(image, 2.0F, 0.0F);
    EXPECT_GT(lit, 180);
    EXPECT_LT(shaded, 20);
    for (const float x : {1.15F, 1.5F, 2.8F}) EXPECT_EQ(ground(image, x, 0.0F), shaded) << x;
    for (const float x : {3.2F, 4.0F, -1.2F}) EXPECT_NEAR(ground(image, x, 0.0F), lit, 3) << x;
    EXPECT_EQ(ground(image, 2.0F, 0.85F), shaded);
    EXPECT_NEAR(ground(image, 2.0F, 1.2F), lit, 3);
}

TEST_F(ShadowGl, LeavesNoSpecksOnWhatTheSunShinesOn) {
    expect_no_specks();
}

TEST_F(ShadowGl, CascadesShowTheSameShadowNearAndFar) {
    // The camera is 60 m up: of four cascades to 300 m the ground lies in the second, of two to
    // 80 m in the last.
    const auto one = draw(frame_);
    for (const auto& [cascades, distance_m] :
         {std::pair{2U, 80.0F}, {2U, 290.0F}, {3U, 100.0F}, {4U, 300.0F}}) {
        frame_.sun_shadow =
            SunShadow{.size_px = 2048, .distance_m = distance_m, .cascades = cascades};
        const auto image = draw(frame_);
        for (const float x : {-3.0F, 1.3F, 2.0F, 2.6F, 3.4F, 5.0F}) {
            EXPECT_NEAR(ground(image, x, 0.0F), ground(one, x, 0.0F), 4)
                << cascades << ' ' << distance_m << ' ' << x;
        }
        EXPECT_EQ(bytes_of("sun_shadow"), std::uint64_t{2048} * 2048 * 2 * cascades);
    }
}

TEST_F(ShadowGl, FarCascadesLeaveNoSpecksEither) {
    frame_.sun_shadow = SunShadow{.size_px = 1024, .distance_m = 200.0F, .cascades = 2};
    expect_no_specks();
}

TEST_F(ShadowGl, FarCascadesFollowWhatMovesAFewFramesLater) {
    frame_.sun_shadow = SunShadow{.size_px = 512, .distance_m = 200.0F, .cascades = 2};
    draw(frame_);
    EXPECT_EQ(renderer_->stats().shadow_passes_rendered, 2U);
    int far_drawn = 0;
    for (int i = 1; i <= 12; ++i) {
        frame_.items[1].world_from_body =
            glm::translate(Mat4f{1.0F}, Vec3f{0.1F * static_cast<float>(i), 1.0F, 0.0F});
        draw(frame_);
        far_drawn += static_cast<int>(renderer_->stats().shadow_passes_rendered) - 1;
    }
    EXPECT_EQ(far_drawn, 3);
    // At rest both are kept, once the far one has caught up.
    for (int i = 0; i < 5; ++i) draw(frame_);
    EXPECT_EQ(renderer_->stats().shadow_passes_cached, 2U);
}

TEST_F(ShadowGl, EndsWithItsDistance) {
    frame_.sun_shadow->distance_m = 30.0F;  // the ground is 60 m off
    const auto image = draw(frame_);
    EXPECT_NEAR(ground(image, 2.0F, 0.0F), ground(image, -3.0F, 0.0F), 3);
}

TEST_F(PictureGl, FlashlightLightsItsConeAndCastsItsOwnShadow) {
    RenderFrame frame = wall(matt(Vec3f{0.8F}), 6.0F);
    frame.width_px = 301;
    frame.height_px = 301;
    frame.flashlight = Flashlight{.position_world = Vec3f{0.0F},
                                  .direction_world = {0.0F, 0.0F, -1.0F},
                                  .intensity = Vec3f{60.0F},
                                  .radius_m = 30.0F,
                                  .inner_rad = 0.15F,
                                  .outer_rad = 0.3F};
    const auto x_at = [](float angle_rad) {
        const float ndc = std::tan(angle_rad) / std::tan(radians_from_degrees(30.0F));
        return static_cast<std::uint32_t>((ndc * 0.5F + 0.5F) * 301.0F);
    };
    auto image = draw(frame);
    const int middle = pixel_at(image, 150, 150).r;
    EXPECT_GT(middle, 120);
    EXPECT_GT(pixel_at(image, x_at(0.1F), 150).r, 100);
    EXPECT_EQ(pixel_at(image, x_at(0.31F), 150).r, 0);
    EXPECT_EQ(pixel_at(image, x_at(-0.31F), 150).r, 0);

    // A small box half way throws a shadow twice its size. Seen from the eye, 0.3 m above the
    // hand, part of that shadow shows below the box.
    frame.flashlight->position_world = {0.0F, 0.3F, 0.0F};
    add_box(frame, Vec3f{0.3F}, {0.0F, 0.0F, -3.0F}, matt(Vec3f{0.8F}));
    image = draw(frame);
    // The shadow on the wall at 6 m: centred on y = 0.3 - 0.3 * 6 / 3 = -0.3.
    const float angle = std::atan(0.42F / 6.0F);
    const std::uint32_t below = 300 - x_at(angle);
    EXPECT_LT(pixel_at(image, 150, 300 - below).r, 20);
    EXPECT_GT(pixel_at(image, 150, below).r, 60);
}

TEST_F(PictureGl, LightAtTheEyeMakesNoSpecks) {
    // V = H exactly: the power in Schlick's term would see a negative number.
    const auto shiny = library_.add_material(
        {.name = "shiny", .base_color = Vec3f{0.9F}, .roughness = 0.05F, .metallic = 1.0F});
    RenderFrame frame = wall(shiny, 3.0F);
    frame.width_px = 201;
    frame.height_px = 201;
    frame.flashlight = Flashlight{.position_world = Vec3f{0.0F},
                                  .direction_world = {0.0F, 0.0F, -1.0F},
                                  .intensity = Vec3f{2000.0F},
                                  .outer_rad = 1.2F};
    const auto image = draw(frame);
    for (std::uint32_t y = 95; y < 106; ++y) {
        for (std::uint32_t x = 95; x < 106; ++x) EXPECT_GT(pixel_at(image, x, y).r, 100);
    }
}

TEST_F(PictureGl, PointLightFallsWithTheSquareAndEndsAtItsRadius) {
    RenderFrame frame = wall(matt(Vec3f{1.0F}), 2.0F);
    frame.lights.push_back(
        {.position_world = {0.0F, 0.0F, 0.0F}, .intensity = Vec3f{4.0F}, .radius_m = 100.0F});
    // 4 cd at 2 m: irradiance 1; a matt white wall sends out 1 / pi, and mirrors little.
    EXPECT_NEAR(center(frame).r, code_of(glm::one_over_pi<float>()), 6);
    frame.lights[0].radius_m = 1.9F;
    EXPECT_EQ(center(frame).r, 0);
}

TEST_F(PictureGl, FarLightsBeyondTheFirst256AreLeftOut) {
    RenderFrame frame = wall(matt(Vec3f{1.0F}), 2.0F);
    for (int i = 0; i < 300; ++i) {
        frame.lights.push_back({.position_world = {0.0F, 0.0F, 500.0F + static_cast<float>(i)},
                                .intensity = Vec3f{1.0F},
                                .radius_m = 10.0F});
    }
    EXPECT_EQ(center(frame).r, 0);
    frame.lights[255].position_world = Vec3f{0.0F};
    EXPECT_GT(center(frame).r, 40);
}

/// One floor seen from above, and lamps in rows over it.
class LampsGl : public PictureGl {
protected:
    static constexpr std::uint32_t kSide_px = 320;
    static constexpr float kHalf_m = 16.0F;

    RenderFrame floor_under(int side) {
        RenderFrame frame = empty_frame(kSide_px, kSide_px);
        frame.camera = camera_at({0.0F, 100.0F, 0.0F}, Vec3f{0.0F});
        frame.camera.fov_y_rad = 2.0F * std::atan(kHalf_m / 100.0F);
        add_box(frame, {60.0F, 1.0F, 60.0F}, {0.0F, -0.5F, 0.0F}, matt(Vec3f{1.0F}));
        const float step_m = 2.0F * kHalf_m / static_cast<float>(side);
        for (int z = 0; z < side; ++z) {
            for (int x = 0; x < side; ++x) {
                frame.lights.push_back(
                    {.position_world = {(static_cast<float>(x) + 0.5F) * step_m - kHalf_m,
                                        0.5F,
                                        (static_cast<float>(z) + 0.5F) * step_m - kHalf_m},
                     .intensity = Vec3f{0.6F},
                     .radius_m = 0.48F * step_m});
            }
        }
        return frame;
    }
    /// Under a lamp 0.5 m up: intensity / 0.25, what the window leaves of it, by pi.
    static float under_lamp(const LocalLight& light) {
        const float share = 0.25F / (light.radius_m * light.radius_m);
        const float window = 1.0F - share * share;
        return light.intensity.x * window * window / 0.25F * glm::one_over_pi<float>();
    }
};

TEST_F(LampsGl, EveryLampOverOneFloorLightsIt) {
    for (const int side : {5, 16}) {
        const RenderFrame frame = floor_under(side);
        const auto image = draw(frame);
        for (const LocalLight& light : frame.lights) {
            const auto pixel = [](float at_m) {
                return static_cast<std::uint32_t>((at_m + kHalf_m) / (2.0F * kHalf_m) * kSide_px);
            };
            const Vec3f& at = light.position_world;
            const int seen = pixel_at(image, pixel(at.x), pixel(at.z)).r;
            ASSERT_NEAR(seen, code_of(under_lamp(light)), 9) << side << ": " << at.x << ' ' << at.z;
        }
        // Half way between four lamps none reaches.
        EXPECT_EQ(pixel_at(image, side == 5 ? 128 : 160, side == 5 ? 128 : 160).r, 0);
    }
}

TEST_F(LampsGl, LampsAddUp) {
    // 200 lamps at one place are as bright as one 200 times as strong.
    RenderFrame many = floor_under(1);
    many.lights.front().radius_m = 20.0F;
    many.lights.front().intensity = Vec3f{0.0005F};
    RenderFrame one = many;
    one.lights.front().intensity *= 200.0F;
    many.lights.resize(200, many.lights.front());
    const int together = pixel_at(draw(many), 160, 160).r;
    EXPECT_GT(together, 40);
    EXPECT_NEAR(together, pixel_at(draw(one), 160, 160).r, 1);
}

}  // namespace
}  // namespace plumbline::render
