#include "engine/render/gl/framebuffer.h"

#include <glad/gl.h>

namespace plumbline::render::gl {
namespace {

void attach(GLenum place, const Texture& texture) {
    const GLenum kind = texture.samples() > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
    glFramebufferTexture2D(GL_FRAMEBUFFER, place, kind, texture.name(), 0);
}

}  // namespace

Framebuffer::Framebuffer(const Texture* color, const Texture* depth) {
    GLuint name = 0;
    glGenFramebuffers(1, &name);
    object_ = FramebufferObject{name};
    glBindFramebuffer(GL_FRAMEBUFFER, name);
    if (color != nullptr) {
        attach(GL_COLOR_ATTACHMENT0, *color);
    } else {
        glDrawBuffer(GL_NONE);
        glReadBuffer(GL_NONE);
    }
    if (depth != nullptr) {
        attach(GL_DEPTH_ATTACHMENT, *depth);
    }
    complete_ = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

void draw_into(unsigned int framebuffer, std::uint32_t width, std::uint32_t height) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, static_cast<GLsizei>(width), static_cast<GLsizei>(height));
}

void copy(const Framebuffer& from,
          const PixelRect& rect,
          const Framebuffer& to,
          const PixelRect& into,
          unsigned int buffers) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, from.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to.name());
    glBlitFramebuffer(rect.left,
                      rect.bottom,
                      rect.right,
                      rect.top,
                      into.left,
                      into.bottom,
                      into.right,
                      into.top,
                      buffers,
                      GL_NEAREST);
}

}  // namespace plumbline::render::gl
