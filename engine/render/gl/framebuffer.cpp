#include "engine/render/gl/framebuffer.h"

#include <glad/gl.h>

namespace plumbline::render::gl {

Framebuffer::Framebuffer(const Texture* color, const Texture* depth) {
    GLuint name = 0;
    glGenFramebuffers(1, &name);
    object_ = FramebufferObject{name};
    glBindFramebuffer(GL_FRAMEBUFFER, name);
    if (color != nullptr) {
        glFramebufferTexture2D(
            GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color->name(), 0);
    } else {
        glDrawBuffer(GL_NONE);
        glReadBuffer(GL_NONE);
    }
    if (depth != nullptr) {
        glFramebufferTexture2D(
            GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth->name(), 0);
    }
    complete_ = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

}  // namespace plumbline::render::gl
