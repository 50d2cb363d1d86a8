#include "engine/render/gl/debug.h"

#include "engine/core/log.h"

#include <glad/gl.h>

namespace plumbline::render::gl {

#ifdef NDEBUG

void listen_to_driver() {}

#else

namespace {

void GLAD_API_PTR on_message(GLenum /*source*/,
                             GLenum type,
                             GLuint /*id*/,
                             GLenum severity,
                             GLsizei /*length*/,
                             const GLchar* message,
                             const void* /*user*/) {
    if (severity == GL_DEBUG_SEVERITY_NOTIFICATION) return;
    if (type == GL_DEBUG_TYPE_ERROR) {
        log_error("OpenGL: {}", message);
    } else {
        log_debug("OpenGL: {}", message);
    }
}

}  // namespace

void listen_to_driver() {
    if (GLAD_GL_KHR_debug == 0) return;
    glEnable(GL_DEBUG_OUTPUT);
    // Errors are then reported inside the call that made them: a breakpoint shows who.
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(on_message, nullptr);
}

#endif

}  // namespace plumbline::render::gl
