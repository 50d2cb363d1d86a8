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

}  // namespace plumbline::render::gl
