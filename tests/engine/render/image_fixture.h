// Images whose colours can be computed by hand.
#pragma once

#include "tests/engine/render/display_color.h"
#include "tests/engine/render/gl_fixture.h"

#include <cmath>

namespace plumbline::render {

inline int code_of(float light) {
    return static_cast<int>(std::lround(srgb_from_linear(Vec3f{light}).x * 255.0F));
}

inline void expect_near(const Pixel& pixel, const Vec3f& code, int tolerance) {
    EXPECT_NEAR(pixel.r, code.x * 255.0F, tolerance);
    EXPECT_NEAR(pixel.g, code.y * 255.0F, tolerance);
    EXPECT_NEAR(pixel.b, code.z * 255.0F, tolerance);
}

class ImageGl : public GlTest {
protected:
    /// A wall 2 m ahead that fills the image.
    RenderFrame wall(assets::MaterialId material, float distance_m = 2.0F) {
        RenderFrame frame = empty_frame(33, 33);
        frame.camera = camera_at(Vec3f{0.0F}, {0.0F, 0.0F, -1.0F});
        const float size_m = distance_m * 4.0F;
        add_box(frame, {size_m, size_m, 1.0F}, {0.0F, 0.0F, -distance_m - 0.5F}, material);
        return frame;
    }
    Pixel center(const RenderFrame& frame) { return pixel_at(draw(frame), 16, 16); }
};

}  // namespace plumbline::render
