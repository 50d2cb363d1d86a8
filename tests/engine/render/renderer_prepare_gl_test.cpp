// All that a frame needs is there before it is drawn.
#include "tests/engine/render/renderer_fixture.h"

#include <vector>

namespace plumbline::render {
namespace {

class RendererPrepareGl : public RendererGl {};

TEST_F(RendererPrepareGl, TheFirstFrameUploadsNothingMore) {
    RenderFrame frame = sunny_box();
    frame.flashlight = Flashlight{};
    std::vector<float> told;
    renderer_->prepare(frame, [&](float share) { told.push_back(share); });
    const auto meshes = bytes_of("meshes");
    EXPECT_GT(meshes, 0U);
    const auto prepared = draw(frame);
    EXPECT_EQ(bytes_of("meshes"), meshes);
    // Two meshes, and a shader for each of their two looks.
    ASSERT_FALSE(told.empty());
    EXPECT_TRUE(std::ranges::is_sorted(told));
    EXPECT_GT(told.front(), 0.0F);
    EXPECT_LE(told.back(), 1.0F);
    make_renderer(PL_SOURCE_DIR "/shaders");
    EXPECT_EQ(draw(frame).bytes, prepared.bytes) << "and prepared or not it looks the same";
}

TEST_F(RendererPrepareGl, AFacetedThingSharesTheShaderOfASmoothOne) {
    RenderFrame frame = sunny_box();
    const auto ball = library_.add_mesh("ball", assets::sphere_mesh(0.5F));
    add_item(
        frame, ball, matt({0.2F, 0.3F, 0.8F}), glm::translate(Mat4f{1.0F}, {1.5F, 0.5F, 0.0F}));
    const auto of_its_own = draw(frame);
    const auto programs = renderer_->stats().new_programs;
    make_renderer(PL_SOURCE_DIR "/shaders");
    renderer_->prepare(frame);
    const auto shared = draw(frame);
    EXPECT_EQ(renderer_->stats().new_programs, programs - 1);
    ASSERT_EQ(shared.bytes.size(), of_its_own.bytes.size());
    for (std::size_t i = 0; i < shared.bytes.size(); ++i)
        ASSERT_NEAR(shared.bytes[i], of_its_own.bytes[i], 1) << i;
}

TEST_F(RendererPrepareGl, AFrameWithoutPixelsOrThingsNeedsNothing) {
    RenderFrame frame = sunny_box();
    frame.width_px = 0;
    bool told = false;
    renderer_->prepare(frame, [&](float) { told = true; });
    EXPECT_FALSE(told);
    EXPECT_EQ(bytes_of("meshes"), 0U);
    renderer_->prepare(empty_frame(8, 8), [&](float) { told = true; });
    EXPECT_FALSE(told);
    frame.width_px = 64;
    frame.items[0].mesh = {};
    frame.items[1].mesh = {};
    renderer_->prepare(frame);
    EXPECT_EQ(bytes_of("meshes"), 0U) << "items without a mesh are passed over";
}

}  // namespace
}  // namespace plumbline::render
