#include "engine/render/passes/scene_target.h"

#include <fmt/format.h>
#include <glad/gl.h>

namespace plumbline::render {

Result<Done> SceneTarget::resize(const PixelSize& size_px,
                                 gl::TargetFormat light,
                                 std::uint32_t samples) {
    const auto [width_px, height_px] = size_px;
    if (framebuffer_ && color_.width() == width_px && color_.height() == height_px &&
        asked_samples_ == samples)
        return Done{};
    *this = {};
    asked_samples_ = samples;
    color_ = gl::Texture::target(light, width_px, height_px, gl::Filter::Linear);
    depth_ =
        gl::Texture::target(gl::TargetFormat::Depth24, width_px, height_px, gl::Filter::Nearest);
    framebuffer_ = gl::Framebuffer{&color_, &depth_};
    bool complete = framebuffer_.complete();
    if (samples > 1) {
        color_samples_ = gl::Texture::multisampled(light, width_px, height_px, samples);
        depth_samples_ = gl::Texture::multisampled(
            gl::TargetFormat::Depth24, width_px, height_px, color_samples_.samples());
        samples_framebuffer_ = gl::Framebuffer{&color_samples_, &depth_samples_};
        complete = complete && samples_framebuffer_.complete();
    }
    if (complete) return Done{};
    *this = {};
    return Error{
        fmt::format("the driver has no memory for an image of {} x {}", width_px, height_px)};
}

std::size_t SceneTarget::bytes_for(const PixelSize& size_px,
                                   gl::TargetFormat light,
                                   std::uint32_t samples) {
    return std::size_t{size_px.width} * size_px.height * (samples > 1 ? samples + 1 : 1) *
           (gl::bytes_per_pixel(light) + gl::bytes_per_pixel(gl::TargetFormat::Depth24));
}

void SceneTarget::bind() const {
    const gl::Framebuffer& drawn = samples_framebuffer_ ? samples_framebuffer_ : framebuffer_;
    gl::draw_into(drawn.name(), color_.width(), color_.height());
}

void SceneTarget::bind_light() {
    if (!light_framebuffer_) {
        const gl::Texture& light = samples_framebuffer_ ? color_samples_ : color_;
        light_framebuffer_ = gl::Framebuffer{&light, nullptr};
    }
    if (samples_framebuffer_) resolve(GL_DEPTH_BUFFER_BIT);
    glBindFramebuffer(GL_FRAMEBUFFER, light_framebuffer_.name());
}

void SceneTarget::copy(const SceneTarget& from, const Vec2f& first_px, const Vec2f& last_px) const {
    const gl::Framebuffer& drawn =
        from.samples_framebuffer_ ? from.samples_framebuffer_ : from.framebuffer_;
    const glm::ivec2 low{first_px};
    const glm::ivec2 high = glm::ivec2{last_px} + 1;
    const gl::PixelRect rect{low.x, low.y, high.x, high.y};
    gl::copy(drawn, rect, framebuffer_, rect, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void SceneTarget::resolve() const {
    if (samples_framebuffer_) resolve(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void SceneTarget::resolve(unsigned int buffers) const {
    const gl::PixelRect all{
        0, 0, static_cast<int>(color_.width()), static_cast<int>(color_.height())};
    gl::copy(samples_framebuffer_, all, framebuffer_, all, buffers);
}

}  // namespace plumbline::render
