// A sunny box on a floor, for what a renderer promises besides pretty images.
#pragma once

#include "tests/engine/render/gl_fixture.h"

namespace plumbline::render {

class RendererGl : public GlTest {
protected:
    RenderFrame sunny_box() {
        RenderFrame frame = empty_frame(64, 48);
        frame.camera = camera_at({0.0F, 3.0F, 6.0F}, Vec3f{0.0F});
        frame.sun = DirectionalLight{.direction_world = glm::normalize(Vec3f{-0.4F, -1.0F, -0.3F})};
        frame.sun_shadow = SunShadow{.size_px = 256, .distance_m = 30.0F};
        add_box(frame, {20.0F, 1.0F, 20.0F}, {0.0F, -0.5F, 0.0F}, matt(Vec3f{0.5F}));
        add_box(frame, Vec3f{1.0F}, {0.0F, 0.5F, 0.0F}, matt({0.8F, 0.3F, 0.2F}));
        return frame;
    }
};

}  // namespace plumbline::render
