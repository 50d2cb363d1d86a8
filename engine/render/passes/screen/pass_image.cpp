#include "engine/render/passes/screen/pass_image.h"

namespace plumbline::render {

bool PassImage::resize(gl::TargetFormat format, const PixelSize& wanted_px) {
    if (framebuffer && size_px() == wanted_px) return true;
    framebuffer = {};
    image = gl::Texture::target(format, wanted_px.width, wanted_px.height, gl::Filter::Linear);
    framebuffer = gl::Framebuffer{&image, nullptr};
    return framebuffer.complete();
}

void PassImage::bind() const {
    gl::draw_into(framebuffer.name(), image.width(), image.height());
}

}  // namespace plumbline::render
