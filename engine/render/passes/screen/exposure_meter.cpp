#include "engine/render/passes/screen/exposure_meter.h"

#include "engine/render/shader_blocks.h"
#include "shaders/shared/limits.h"

#include <glad/gl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace plumbline::render {
namespace {

constexpr std::size_t kCells = std::size_t{PL_METER_X} * PL_METER_Y;
using Cells = std::array<float, kCells>;

// The geometric mean of a sunny garden, of which scenes set their exposure.
constexpr float kDayMean = 0.2F;
constexpr float kFollows = 0.6F;
constexpr float kLeast = 0.6F;
constexpr float kMost = 5.0F;
constexpr float kBrightens_s = 1.2F;
constexpr float kDarkens_s = 0.4F;
// After a longer pause eyes have had their time.
constexpr float kLongPause_s = 1.0F;

float mean_of(const Cells& cells) {
    float sum = 0.0F;
    for (const float cell : cells) sum += cell;
    return std::exp2(sum / static_cast<float>(kCells));
}

}  // namespace

float exposure_for(float mean) {
    return std::clamp(std::pow(kDayMean / std::max(mean, 1e-6F), kFollows), kLeast, kMost);
}

float adapted(float now, float wanted, float seconds) {
    const float takes_s = wanted > now ? kBrightens_s : kDarkens_s;
    const float share = 1.0F - std::exp(-std::max(seconds, 0.0F) / takes_s);
    return now * std::pow(wanted / now, share);
}

void ExposureMeter::make() {
    if (cells_) return;
    cells_ = gl::Texture::target(
        gl::TargetFormat::HdrColor, PL_METER_X, PL_METER_Y, gl::Filter::Nearest);
    framebuffer_ = gl::Framebuffer{&cells_, nullptr};
    read_back_ = gl::Buffer{gl::BufferUse::ReadBack, gl::BufferLife::PerFrame};
    const Cells nothing{};
    read_back_.upload(nothing.data(), sizeof(nothing));
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
}

float ExposureMeter::measure(const gl::Texture& scene, Reading reading, PassContext context) {
    const gl::Program* program = context.program(kExposureShader);
    if (program == nullptr) return exposure_.value_or(1.0F);
    make();
    const bool has_before = reading == Reading::Later && copied_;
    const float before = has_before ? read_copy() : 0.0F;
    gl::draw_into(framebuffer_.name(), PL_METER_X, PL_METER_Y);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    program->use();
    gl::bind_texture(kSourceUnit, scene);
    context.draw_triangle();
    const Clock::time_point now = Clock::now();
    const float since_s = std::chrono::duration<float>(now - seen_).count();
    seen_ = now;
    if (reading == Reading::Now || !exposure_) {
        exposure_ = exposure_for(read_cells());
    } else if (has_before) {
        const float wanted = exposure_for(before);
        exposure_ = since_s > kLongPause_s ? wanted : adapted(*exposure_, wanted, since_s);
    }
    if (reading == Reading::Later) {
        glBindBuffer(GL_PIXEL_PACK_BUFFER, read_back_.name());
        glReadPixels(0, 0, PL_METER_X, PL_METER_Y, GL_RED, GL_FLOAT, nullptr);
        glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
        copied_ = true;
    }
    return *exposure_;
}

float ExposureMeter::read_cells() {
    Cells cells{};
    glReadPixels(0, 0, PL_METER_X, PL_METER_Y, GL_RED, GL_FLOAT, cells.data());
    return mean_of(cells);
}

float ExposureMeter::read_copy() {
    Cells cells{};
    glBindBuffer(GL_PIXEL_PACK_BUFFER, read_back_.name());
    glGetBufferSubData(GL_PIXEL_PACK_BUFFER, 0, sizeof(cells), cells.data());
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    return mean_of(cells);
}

}  // namespace plumbline::render
