// What a driver is asked before anything is drawn.
#include "engine/render/gl_device.h"
#include "tests/engine/render/gl_fixture.h"

namespace plumbline::render {
namespace {

class GlDeviceGl : public GlTest {};

TEST_F(GlDeviceGl, LimitsAreTheDriversUnlessLowerOnesAreAskedFor) {
    const auto whole = load_device(context_->gl_loader(), PresentTarget::Window, {});
    ASSERT_TRUE(whole.ok());
    EXPECT_GE(whole->device.limits.texture_px, 1024U);
    EXPECT_GE(whole->device.limits.texture_px, whole->device.limits.map_px);
    EXPECT_FALSE(whole->device.is_offscreen);
    const auto less = load_device(context_->gl_loader(),
                                  PresentTarget::Offscreen,
                                  {.texture_px = 512, .map_px = 2048, .half_float_targets = false});
    ASSERT_TRUE(less.ok());
    EXPECT_EQ(less->device.limits.texture_px, 512U);
    EXPECT_EQ(less->device.limits.map_px, 512U);
    EXPECT_FALSE(less->device.limits.half_float_targets);
    EXPECT_TRUE(less->device.is_offscreen);
}

TEST_F(GlDeviceGl, WithoutFunctionsThereIsNoDevice) {
    EXPECT_FALSE(load_device(nullptr, PresentTarget::Offscreen, {}).ok());
}

}  // namespace
}  // namespace plumbline::render
