#include "engine/render/passes/scene_target.h"

#include <fmt/format.h>
#include <glad/gl.h>

namespace plumbline::render {

Result<Done> SceneTarget::resize(const PixelSize& size_px, gl::TargetFormat light) {
    const auto [width_px, height_px] = size_px;
    if (framebuffer_ && color_.width() == width_px && color_.height() == height_px) return Done{};
    framebuffer_ = {};
    color_ = gl::Texture::target(light, width_px, height_px, gl::Filter::Linear);
    depth_ =
        gl::Texture::target(gl::TargetFormat::Depth24, width_px, height_px, gl::Filter::Nearest);
    framebuffer_ = gl::Framebuffer{&color_, &depth_};
    if (framebuffer_.complete()) return Done{};
    *this = {};
    return Error{
        fmt::format("the driver has no memory for a picture of {} x {}", width_px, height_px)};
}

std::size_t SceneTarget::bytes_for(const PixelSize& size_px, gl::TargetFormat light) {
    return std::size_t{size_px.width} * size_px.height *
           (gl::bytes_per_pixel(light) + gl::bytes_per_pixel(gl::TargetFormat::Depth24));
}

void SceneTarget::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glViewport(0, 0, static_cast<GLsizei>(color_.width()), static_cast<GLsizei>(color_.height()));
}

}  // namespace plumbline::render
