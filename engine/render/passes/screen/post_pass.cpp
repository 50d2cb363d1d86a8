#include "engine/render/passes/screen/post_pass.h"

#include "engine/render/shader_blocks.h"

#include <glad/gl.h>

#include <algorithm>

namespace plumbline::render {
namespace {

// From half the screen down; six levels glow about a tenth of the screen wide.
constexpr std::size_t kBloomLevels = 6;
constexpr std::uint32_t kSmallestSide_px = 4;

/// Depth is only written while the test is on.
void write_depth(bool keeps_depth) {
    if (!keeps_depth) {
        glDisable(GL_DEPTH_TEST);
        return;
    }
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    glDepthMask(GL_TRUE);
}

}  // namespace

bool PostPass::resize_bloom(const ImagePlan& plan) {
    std::size_t level = 0;
    PixelSize size_px = plan.scene_px;
    while (plan.bloom && level < kBloomLevels) {
        size_px = {std::max(size_px.width / 2, 1U), std::max(size_px.height / 2, 1U)};
        if (std::min(size_px.width, size_px.height) < kSmallestSide_px) break;
        if (level == bloom_levels_.size()) bloom_levels_.emplace_back();
        if (!bloom_levels_[level].resize(gl::TargetFormat::HdrColor, size_px)) return false;
        ++level;
    }
    bloom_levels_.resize(level);
    return true;
}

Result<Done> PostPass::resize(const ImagePlan& plan) {
    bool complete = resize_bloom(plan);
    if (plan.fxaa) {
        complete = complete && toned_.resize(gl::TargetFormat::Rgba8, plan.image_px);
    } else {
        toned_ = {};
    }
    if (plan.is_scaled()) {
        complete = complete && smooth_.resize(gl::TargetFormat::Rgba8, plan.image_px);
    } else {
        smooth_ = {};
    }
    if (complete) return Done{};
    *this = {};
    return Error{"the driver has no memory for the images after the scene's"};
}

std::size_t PostPass::bloom_bytes() const {
    std::size_t bytes = 0;
    for (const PassImage& level : bloom_levels_) bytes += level.image.bytes();
    return bytes;
}

void PostPass::render_bloom(const SceneLight& light, PassContext context) {
    const gl::Program* down = context.program(kBloomDownShader);
    const gl::Program* up = context.program(kBloomUpShader);
    if (down == nullptr || up == nullptr || bloom_levels_.empty()) return;
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    down->use();
    const gl::Texture* source = light.image;
    for (const PassImage& level : bloom_levels_) {
        level.bind();
        gl::bind_texture(kSourceUnit, *source);
        context.draw_triangle();
        source = &level.image;
    }
    up->use();
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    for (std::size_t i = bloom_levels_.size() - 1; i > 0; --i) {
        const PassImage& target = bloom_levels_[i - 1];
        target.bind();
        gl::bind_texture(kSourceUnit, bloom_levels_[i].image);
        context.draw_triangle();
    }
    glDisable(GL_BLEND);
}

void PostPass::render_image(const SceneLight& light,
                            const gl::Texture& depth,
                            const ImagePlan& plan,
                            unsigned int present_framebuffer,
                            PassContext context) const {
    struct Step {
        ShaderPair shader;
        FeatureSet features;
        const gl::Texture& source;
        const gl::Framebuffer* target;  ///< null: the present target
    };
    const gl::Framebuffer* before_scaling = plan.is_scaled() ? &smooth_.framebuffer : nullptr;
    std::vector<Step> steps;
    steps.push_back({kToneMapShader,
                     light.features | screen_feature::kToneMap.when(plan.tone_curve) |
                         screen_feature::kFxaa.when(plan.fxaa) |
                         screen_feature::kFourSamples.when(plan.has_samples()) |
                         screen_feature::kBloom.when(!bloom_levels_.empty()),
                     *light.image,
                     plan.fxaa ? &toned_.framebuffer : before_scaling});
    if (plan.fxaa) {
        steps.push_back({kSmoothEdgesShader,
                         screen_feature::kFxaa | screen_feature::kSharpen.when(plan.is_scaled()),
                         toned_.image,
                         before_scaling});
    }
    if (plan.is_scaled()) steps.push_back({kScaleUpShader, 0, smooth_.image, nullptr});

    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    gl::bind_texture(kDepthUnit, depth);
    if (!bloom_levels_.empty()) {
        gl::bind_texture(kBloomUnit, bloom_levels_.front().image);
    }
    for (const Step& step : steps) {
        const bool is_last = step.target == nullptr;
        const bool keeps_depth = is_last && plan.keeps_depth;
        const PixelSize& size_px = is_last ? plan.present_px : plan.image_px;
        gl::draw_into(
            is_last ? present_framebuffer : step.target->name(), size_px.width, size_px.height);
        const gl::Program* program = context.program(
            step.shader, step.features | screen_feature::kKeepDepth.when(keeps_depth));
        if (program == nullptr) continue;
        program->use();
        bind_scene_light(light, *program);
        gl::bind_texture(kSourceUnit, step.source);
        write_depth(keeps_depth);
        context.draw_triangle();
    }
}

}  // namespace plumbline::render
