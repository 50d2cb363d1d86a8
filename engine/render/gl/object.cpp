#include "engine/render/gl/object.h"

#include <glad/gl.h>

namespace plumbline::render::gl {

void delete_buffer(unsigned int name) {
    glDeleteBuffers(1, &name);
}
void delete_vertex_array(unsigned int name) {
    glDeleteVertexArrays(1, &name);
}
void delete_texture(unsigned int name) {
    glDeleteTextures(1, &name);
}
void delete_framebuffer(unsigned int name) {
    glDeleteFramebuffers(1, &name);
}
void delete_program(unsigned int name) {
    glDeleteProgram(name);
}
void delete_shader(unsigned int name) {
    glDeleteShader(name);
}
void delete_query(unsigned int name) {
    glDeleteQueries(1, &name);
}
void delete_sampler(unsigned int name) {
    glDeleteSamplers(1, &name);
}

VertexArrayObject new_vertex_array() {
    GLuint name = 0;
    glGenVertexArrays(1, &name);
    glBindVertexArray(name);
    return VertexArrayObject{name};
}

TextureObject new_texture() {
    GLuint name = 0;
    glGenTextures(1, &name);
    return TextureObject{name};
}

}  // namespace plumbline::render::gl
