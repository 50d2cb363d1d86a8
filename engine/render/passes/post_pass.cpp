#include "engine/render/passes/post_pass.h"

#include "engine/render/shader_blocks.h"

#include <glad/gl.h>

#include <algorithm>

namespace plumbline::render {
namespace {

// From half the screen down; six levels glow about a tenth of the screen wide.
constexpr std::size_t kBloomLevels = 6;
constexpr std::uint32_t kSmallestSide_px = 4;

void set_viewport(const gl::Texture& image) {
    glViewport(0, 0, static_cast<GLsizei>(image.width()), static_cast<GLsizei>(image.height()));
}

}  // namespace

Result<Done> PostPass::resize(std::uint32_t width_px, std::uint32_t height_px) {
    using gl::Filter;
    using gl::TargetFormat;
    if (ready() && hdr_image_.width() == width_px && hdr_image_.height() == height_px) {
        return Done{};
    }
    free();
    hdr_image_ = gl::Texture::target(TargetFormat::HdrColor, width_px, height_px, Filter::Linear);
    depth_image_ = gl::Texture::target(TargetFormat::Depth24, width_px, height_px, Filter::Nearest);
    hdr_framebuffer_ = gl::Framebuffer{&hdr_image_, &depth_image_};
    bool complete = hdr_framebuffer_.complete();
    for (std::size_t i = 0; i < kBloomLevels; ++i) {
        width_px = std::max(width_px / 2, 1U);
        height_px = std::max(height_px / 2, 1U);
        if (std::min(width_px, height_px) < kSmallestSide_px) break;
        Level& level = bloom_levels_.emplace_back();
        level.image =
            gl::Texture::target(TargetFormat::HdrColor, width_px, height_px, Filter::Linear);
        level.framebuffer = gl::Framebuffer{&level.image, nullptr};
        complete = complete && level.framebuffer.complete();
    }
    if (complete) return Done{};
    free();
    return Error{"the driver has no memory for the HDR image"};
}

void PostPass::free() {
    hdr_framebuffer_ = {};
    hdr_image_ = {};
    depth_image_ = {};
    bloom_levels_.clear();
}

std::size_t PostPass::bytes() const {
    std::size_t bytes = hdr_image_.bytes() + depth_image_.bytes();
    for (const Level& level : bloom_levels_) bytes += level.image.bytes();
    return bytes;
}

void PostPass::render_bloom(const FullscreenTriangle& triangle,
                            SceneResources& resources,
                            FrameStats& stats) {
    const gl::Program* down = resources.shaders.find(kBloomDownShader, 0);
    const gl::Program* up = resources.shaders.find(kBloomUpShader, 0);
    if (down == nullptr || up == nullptr || bloom_levels_.empty()) return;
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    down->use();
    const gl::Texture* source = &hdr_image_;
    for (const Level& level : bloom_levels_) {
        glBindFramebuffer(GL_FRAMEBUFFER, level.framebuffer.name());
        set_viewport(level.image);
        gl::bind_texture(kSourceUnit, gl::TextureKind::Flat, *source);
        triangle.draw();
        ++stats.draw_calls;
        source = &level.image;
    }
    up->use();
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    for (std::size_t i = bloom_levels_.size() - 1; i > 0; --i) {
        const Level& target = bloom_levels_[i - 1];
        glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.name());
        set_viewport(target.image);
        gl::bind_texture(kSourceUnit, gl::TextureKind::Flat, bloom_levels_[i].image);
        triangle.draw();
        ++stats.draw_calls;
    }
    glDisable(GL_BLEND);
}

void PostPass::render_tone_map(const FullscreenTriangle& triangle,
                               FeatureSet features,
                               SceneResources& resources,
                               FrameStats& stats) const {
    if (bloom_levels_.empty()) features &= ~feature::kBloom;
    const gl::Program* program = resources.shaders.find(kToneMapShader, features);
    if (program == nullptr) return;
    program->use();
    gl::bind_texture(kSourceUnit, gl::TextureKind::Flat, hdr_image_);
    gl::bind_texture(kDepthUnit, gl::TextureKind::Flat, depth_image_);
    if (!bloom_levels_.empty()) {
        gl::bind_texture(kBloomUnit, gl::TextureKind::Flat, bloom_levels_.front().image);
    }
    glDisable(GL_CULL_FACE);
    // Depth is only written while the test is on.
    const bool keeps_depth = (features & feature::kKeepDepth) != 0;
    if (keeps_depth) {
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_ALWAYS);
        glDepthMask(GL_TRUE);
    } else {
        glDisable(GL_DEPTH_TEST);
    }
    triangle.draw();
    ++stats.draw_calls;
}

}  // namespace plumbline::render
