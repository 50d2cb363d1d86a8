// What a renderer promises besides pretty pictures: sizes, caching, freeing, errors.
#include "engine/core/files.h"
#include "tests/engine/render/gl_fixture.h"

#include <filesystem>

namespace plumbline::render {
namespace {

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

TEST_F(RendererGl, TellsWhatDraws) {
    EXPECT_FALSE(renderer_->gl().vendor.empty());
    EXPECT_FALSE(renderer_->gl().renderer.empty());
    EXPECT_FALSE(renderer_->gl().version.empty());
}

TEST_F(RendererGl, LoaderWithoutFunctionsIsAnErrorNotACrash) {
    const auto nothing = Renderer::create([](const char*) -> void (*)() { return nullptr; },
                                          PresentTarget::Offscreen,
                                          PL_SOURCE_DIR "/shaders",
                                          library_);
    ASSERT_FALSE(nothing.ok());
    EXPECT_EQ(nothing.error().exit_code, ExitCode::NoDisplay);
}

TEST_F(RendererGl, SurvivesSizesOfZero) {
    RenderFrame frame = sunny_box();
    for (const auto& [width, height] : {std::pair{0U, 0U}, {64U, 0U}, {0U, 48U}}) {
        frame.width_px = width;
        frame.height_px = height;
        EXPECT_TRUE(draw(frame).bytes.empty());
        EXPECT_TRUE(renderer_->stats().passes.empty());
    }
    frame.width_px = 64;
    frame.height_px = 48;
    EXPECT_EQ(draw(frame).bytes.size(), 64U * 48U * 3U);
}

TEST_F(RendererGl, FollowsTheFramesSize) {
    RenderFrame frame = sunny_box();
    frame.post = Post{.exposure = 1.0F, .bloom = 0.1F};
    for (const std::uint32_t side : {16U, 200U, 33U, 1U, 128U}) {
        frame.width_px = side;
        frame.height_px = side;
        EXPECT_EQ(draw(frame).width, side);
        EXPECT_EQ(bytes_of("targets"), std::uint64_t{side} * side * 8);
    }
    // Twice the same size costs the same memory: nothing leaks.
    const std::uint64_t before = bytes_of("post");
    draw(frame);
    EXPECT_EQ(bytes_of("post"), before);
}

TEST_F(RendererGl, DrawsShadowsAgainOnlyWhenSomethingMoved) {
    RenderFrame frame = sunny_box();
    draw(frame);
    EXPECT_EQ(renderer_->stats().shadow_passes_rendered, 1U);
    EXPECT_EQ(renderer_->stats().shadow_passes_cached, 0U);
    draw(frame);
    EXPECT_EQ(renderer_->stats().shadow_passes_rendered, 0U);
    EXPECT_EQ(renderer_->stats().shadow_passes_cached, 1U);

    frame.camera.position_world.x += 0.05F;  // far less than the map's step
    draw(frame);
    EXPECT_EQ(renderer_->stats().shadow_passes_cached, 1U);

    frame.items[1].world_from_body =
        glm::translate(frame.items[1].world_from_body, Vec3f{0.0F, 0.01F, 0.0F});
    draw(frame);
    EXPECT_EQ(renderer_->stats().shadow_passes_rendered, 1U);

    frame.sun->direction_world = glm::normalize(Vec3f{-0.41F, -1.0F, -0.3F});
    draw(frame);
    EXPECT_EQ(renderer_->stats().shadow_passes_rendered, 1U);
}

TEST_F(RendererGl, ThingsThatCastNoShadowMayMoveForFree) {
    RenderFrame frame = sunny_box();
    frame.items[1].casts_shadow = false;
    draw(frame);
    frame.items[1].world_from_body =
        glm::translate(frame.items[1].world_from_body, Vec3f{0.0F, 0.5F, 0.0F});
    draw(frame);
    EXPECT_EQ(renderer_->stats().shadow_passes_cached, 1U);
}

TEST_F(RendererGl, WhatAFrameDoesNotAskForHoldsNoMemory) {
    RenderFrame frame = sunny_box();
    frame.flashlight = Flashlight{};
    frame.post = Post{.exposure = 1.0F, .bloom = 0.1F};
    draw(frame);
    EXPECT_EQ(bytes_of("sun_shadow"), 256U * 256U * 2U);
    EXPECT_EQ(bytes_of("flashlight"), 1024U * 1024U * 2U);
    EXPECT_GT(bytes_of("post"), 0U);

    frame.flashlight.reset();
    frame.sun_shadow.reset();
    frame.post.reset();
    draw(frame);
    EXPECT_EQ(bytes_of("sun_shadow"), 0U);
    EXPECT_EQ(bytes_of("flashlight"), 0U);
    EXPECT_EQ(bytes_of("post"), 0U);
    EXPECT_EQ(bytes_of("sky"), 0U);
    ASSERT_EQ(renderer_->stats().passes.size(), 1U);
    EXPECT_EQ(renderer_->stats().passes[0].name, "opaque");

    renderer_->forget_scene();
    EXPECT_EQ(bytes_of("meshes"), 0U);
}

TEST_F(RendererGl, PostWithoutBloomNeedsNoImages) {
    RenderFrame frame = sunny_box();
    frame.post = Post{};
    draw(frame);
    EXPECT_EQ(bytes_of("post"), 0U);
}

TEST_F(RendererGl, CountsInstancesAndDraws) {
    RenderFrame frame = empty_frame(64, 48);
    frame.camera = camera_at({0.0F, 0.0F, 20.0F}, Vec3f{0.0F});
    const auto material = unlit(Vec3f{1.0F});
    for (int i = 0; i < 10; ++i) {
        add_box(frame, Vec3f{1.0F}, {static_cast<float>(i) * 0.2F, 0.0F, 0.0F}, material);
    }
    draw(frame);
    EXPECT_EQ(renderer_->stats().draw_calls, 1U);
    EXPECT_EQ(renderer_->stats().instances, 10U);
    EXPECT_EQ(renderer_->stats().triangles, 120U);
}

/// A copy of the shaders that a test may break.
class BrokenShadersGl : public RendererGl {
protected:
    void SetUp() override {
        RendererGl::SetUp();
        folder_ = std::filesystem::temp_directory_path() /
                  (std::string{"plumbline_broken_"} +
                   testing::UnitTest::GetInstance()->current_test_info()->name());
        std::filesystem::remove_all(folder_);
        std::filesystem::copy(
            PL_SOURCE_DIR "/shaders", folder_, std::filesystem::copy_options::recursive);
    }
    void TearDown() override {
        renderer_.reset();
        std::filesystem::remove_all(folder_);
    }
    /// Puts a wrong line at the end of a shader file and tells its number.
    int break_file(const std::string& name) {
        auto text = read_file(folder_ / name, 1 << 20);
        EXPECT_TRUE(text.ok());
        const auto lines = std::count(text->begin(), text->end(), '\n');
        EXPECT_TRUE(write_file_atomically(folder_ / name, *text + "nonsense here;\n").ok());
        return static_cast<int>(lines) + 1;
    }

    std::filesystem::path folder_;
};

TEST_F(BrokenShadersGl, AtTheStartAreAnErrorWithFileAndLine) {
    const int line = break_file("include/fog.glsl");
    const auto made =
        Renderer::create(context_->gl_loader(), PresentTarget::Offscreen, folder_, library_);
    ASSERT_FALSE(made.ok());
    EXPECT_NE(made.error().message.find("include/fog.glsl:" + std::to_string(line)),
              std::string::npos)
        << made.error().message;
    EXPECT_EQ(made.error().exit_code, ExitCode::NoDisplay);
}

TEST_F(BrokenShadersGl, OnReloadLeaveThePictureAsItWas) {
    make_renderer(folder_);
    const RenderFrame frame = sunny_box();
    const auto before = draw(frame);
    const int line = break_file("mesh.frag");
    const auto reloaded = renderer_->reload_shaders();
    ASSERT_FALSE(reloaded.ok());
    EXPECT_NE(reloaded.error().message.find("mesh.frag:" + std::to_string(line)), std::string::npos)
        << reloaded.error().message;
    EXPECT_EQ(draw(frame).bytes, before.bytes);

    std::filesystem::copy_file(PL_SOURCE_DIR "/shaders/mesh.frag",
                               folder_ / "mesh.frag",
                               std::filesystem::copy_options::overwrite_existing);
    EXPECT_TRUE(renderer_->reload_shaders().ok());
    EXPECT_EQ(draw(frame).bytes, before.bytes);
}

}  // namespace
}  // namespace plumbline::render
