// Lamps as shaders get them.
#include "tests/engine/render/image_fixture.h"

namespace plumbline::render {
namespace {

class GpuLightsGl : public ImageGl {};

TEST_F(GpuLightsGl, PointLightFallsWithTheSquareAndEndsAtItsRadius) {
    RenderFrame frame = wall(matt(Vec3f{1.0F}), 2.0F);
    frame.lights.push_back(
        {.position_world = {0.0F, 0.0F, 0.0F}, .intensity = Vec3f{4.0F}, .radius_m = 100.0F});
    // 4 cd at 2 m: irradiance 1; a matt white wall sends out 1 / pi, and mirrors little.
    EXPECT_NEAR(center(frame).r, code_of(glm::one_over_pi<float>()), 6);
    frame.lights[0].radius_m = 1.9F;
    EXPECT_EQ(center(frame).r, 0);
}

TEST_F(GpuLightsGl, FarLightsBeyondTheFirst256AreLeftOut) {
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

}  // namespace
}  // namespace plumbline::render
