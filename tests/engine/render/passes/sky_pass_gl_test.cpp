// How a sky of six faces is seen.
#include "tests/engine/render/display_color.h"
#include "tests/engine/render/sky/sky_fixture.h"

#include <cmath>

namespace plumbline::render {
namespace {

class SkyPassGl : public SkyGl {};

TEST_F(SkyPassGl, FogHidesTheHorizonAndLeavesTheSkyOverhead) {
    for (const char* face : {"px", "nx", "py", "ny", "pz", "nz"}) write_face(face, {255, 255, 255});
    RenderFrame frame = looking({0.0F, 1.0F, 0.0F});
    frame.camera.fov_y_rad = 0.02F;
    frame.fog = Fog{.color = Vec3f{0.0F}, .density_per_m = 0.02F};
    // 30 m of it: exp(-0.36) of the sky's light gets through.
    const Pixel above = pixel_at(draw(frame), 32, 32);
    EXPECT_NEAR(above.r, srgb_from_linear(Vec3f{std::exp(-0.36F)}).x * 255.0F, 2.0F);
    frame.camera = camera_at(Vec3f{0.0F}, {1.0F, 0.0F, 0.0F});
    frame.camera.fov_y_rad = 0.02F;
    EXPECT_EQ(pixel_at(draw(frame), 32, 32).r, 0);
}

TEST_F(SkyPassGl, EachFaceIsSeenAlongItsAxisUpright) {
    const std::vector<std::pair<std::string, Pixel>> faces{{"px", {200, 0, 0}},
                                                           {"nx", {80, 0, 0}},
                                                           {"py", {0, 200, 0}},
                                                           {"ny", {0, 80, 0}},
                                                           {"pz", {0, 0, 200}},
                                                           {"nz", {0, 0, 80}}};
    for (const auto& [name, color] : faces) write_face(name, color);
    const std::vector<Vec3f> axes{{1.0F, 0.0F, 0.0F},
                                  {-1.0F, 0.0F, 0.0F},
                                  {0.0F, 1.0F, 0.0F},
                                  {0.0F, -1.0F, 0.0F},
                                  {0.0F, 0.0F, 1.0F},
                                  {0.0F, 0.0F, -1.0F}};
    for (std::size_t i = 0; i < axes.size(); ++i) {
        const auto image = draw(looking(axes[i]));
        // OpenGL numbers a face's pixels as seen from outside the cube, so from inside the upper left
        // quarter is on the right. Looking down, the test's camera has -z at the top, the face +z.
        const bool down = i == 3;
        expect_color(down ? pixel_at(image, 16, 48) : pixel_at(image, 48, 16), {255, 255, 255});
        expect_color(down ? pixel_at(image, 48, 16) : pixel_at(image, 16, 48), faces[i].second);
        expect_color(pixel_at(image, 48, 40), faces[i].second);
    }
}

TEST_F(SkyPassGl, HidesBehindWhatIsThereAndGoesWithTheFrameThatAsked) {
    for (const char* name : {"px", "nx", "py", "ny", "pz", "nz"}) write_face(name, {0, 0, 200});
    RenderFrame frame = looking({0.0F, 0.0F, -1.0F});
    add_box(frame, Vec3f{1.0F}, {0.0F, 0.0F, -2.0F}, unlit({1.0F, 0.0F, 0.0F}));
    const auto image = draw(frame);
    expect_color(pixel_at(image, 32, 32), {255, 0, 0});
    expect_color(pixel_at(image, 60, 60), {0, 0, 200});
    frame.sky.reset();
    draw(frame);
    EXPECT_EQ(bytes_of("sky"), 0U);
}

}  // namespace
}  // namespace plumbline::render
