// What a renderer promises besides pretty images: sizes, caching, freeing, errors.
#include "engine/assets/image/image_import.h"
#include "engine/core/io/files.h"
#include "tests/engine/render/renderer_fixture.h"

#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

namespace plumbline::render {
namespace {

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

/// The driver's functions, but that it tells of a reset when it is asked to.
GlLoader driver = nullptr;
bool device_is_lost = false;

void (*with_resets(const char* name))() {
    if (!std::string_view(name).starts_with("glGetGraphicsResetStatus")) return driver(name);
    const auto status = []() -> unsigned int { return device_is_lost ? 0x8255U : 0U; };
    return reinterpret_cast<void (*)()>(static_cast<unsigned int (*)()>(status));
}

/// The driver's functions, but that it names none of its extensions.
const unsigned char* no_extension(unsigned int, unsigned int) {
    return reinterpret_cast<const unsigned char*>("GL_PL_none");
}

void (*without_extensions(const char* name))() {
    if (std::string_view(name) != "glGetStringi") return driver(name);
    return reinterpret_cast<void (*)()>(&no_extension);
}

// EXPERIENCE A5: a driver with 3.3 and nothing beside it does.
TEST_F(RendererGl, WithoutTheOptionalFeaturesTheImageIsTheSame) {
    const auto whole = draw(sunny_box());
    driver = context_->gl_loader();
    auto made = Renderer::create(
        without_extensions, PresentTarget::Offscreen, PL_SOURCE_DIR "/shaders", library_);
    ASSERT_TRUE(made.ok()) << made.error().message;
    renderer_ = std::move(*made);
    for (int i = 0; i < 4; ++i) EXPECT_EQ(draw(sunny_box()).bytes, whole.bytes);
}

// EXPERIENCE A15
TEST_F(RendererGl, ADeviceThatWasResetIsTold) {
    driver = context_->gl_loader();
    device_is_lost = false;
    auto made =
        Renderer::create(with_resets, PresentTarget::Offscreen, PL_SOURCE_DIR "/shaders", library_);
    ASSERT_TRUE(made.ok()) << made.error().message;
    renderer_ = std::move(*made);
    draw(sunny_box());
    EXPECT_FALSE(renderer_->device_lost());
    device_is_lost = true;
    draw(sunny_box());
    EXPECT_TRUE(renderer_->device_lost());
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
    const int line = break_file("include/lighting.glsl");
    const auto made =
        Renderer::create(context_->gl_loader(), PresentTarget::Offscreen, folder_, library_);
    ASSERT_FALSE(made.ok());
    EXPECT_NE(made.error().message.find("include/lighting.glsl:" + std::to_string(line)),
              std::string::npos)
        << made.error().message;
    EXPECT_EQ(made.error().exit_code, ExitCode::NoDisplay);
}

// Missing files are one error with one exit code, whichever is missing and whether or not the
// first frame would need it.
TEST_F(BrokenShadersGl, MissingFilesAreOneErrorAtTheStart) {
    for (const char* name : {"mesh.vert",
                             "mesh.frag",
                             "depth.vert",
                             "depth.frag",
                             "sky.frag",
                             "line.vert",
                             "bloom_up.frag",
                             "smooth_edges.frag",
                             "scale_up.frag",
                             "include/shadow.glsl"}) {
        std::filesystem::rename(folder_ / name, folder_ / "away");
        const auto made =
            Renderer::create(context_->gl_loader(), PresentTarget::Offscreen, folder_, library_);
        ASSERT_FALSE(made.ok()) << name;
        EXPECT_EQ(made.error().exit_code, ExitCode::NoDisplay) << name;
        EXPECT_NE(made.error().message.find(name), std::string::npos) << made.error().message;
        std::filesystem::rename(folder_ / "away", folder_ / name);
    }
}

// EXPERIENCE A8
TEST_F(BrokenShadersGl, VaryingThatTheStagesDisagreeAboutIsAnErrorAndOnReloadKeepsTheImage) {
    make_renderer(folder_);
    const RenderFrame frame = sunny_box();
    const auto before = draw(frame);
    auto text = read_file(folder_ / "mesh.vert", 1 << 20);
    ASSERT_TRUE(text.ok());
    const std::string varying = "out vec3 surface_color;";
    std::string without = *text;
    without.replace(without.find(varying), varying.size(), "flat out vec3 surface_color;");
    ASSERT_TRUE(write_file_atomically(folder_ / "mesh.vert", without).ok());
    const auto reloaded = renderer_->reload_shaders();
    ASSERT_FALSE(reloaded.ok());
    EXPECT_NE(reloaded.error().message.find("mesh.vert + mesh.frag"), std::string::npos);
    EXPECT_NE(reloaded.error().message.find("surface_color"), std::string::npos);
    EXPECT_EQ(draw(frame).bytes, before.bytes);
    const auto made =
        Renderer::create(context_->gl_loader(), PresentTarget::Offscreen, folder_, library_);
    ASSERT_FALSE(made.ok());
    EXPECT_EQ(made.error().exit_code, ExitCode::NoDisplay);
    // A uniform that nobody declares any more is skipped.
    const std::string uniform = "uniform float opacity;";
    auto line = read_file(folder_ / "line.frag", 1 << 20);
    ASSERT_TRUE(line.ok());
    line->replace(line->find(uniform), uniform.size(), "const float opacity = 1.0;");
    ASSERT_TRUE(write_file_atomically(folder_ / "line.frag", *line).ok());
    ASSERT_TRUE(write_file_atomically(folder_ / "mesh.vert", *text).ok());
    EXPECT_TRUE(renderer_->reload_shaders().ok());
    RenderFrame with_lines = frame;
    with_lines.lines.add({-5, 1, 0}, {5, 1, 0}, {1, 0, 0});
    EXPECT_NE(draw(with_lines).bytes, before.bytes);
}

TEST_F(BrokenShadersGl, OnReloadLeaveTheImageAsItWas) {
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
