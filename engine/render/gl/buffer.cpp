#include "engine/render/gl/buffer.h"

#include <glad/gl.h>

#include <array>

namespace plumbline::render::gl {
namespace {

// By BufferUse.
constexpr std::array<GLenum, 4> kTargets{
    GL_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER, GL_UNIFORM_BUFFER, GL_PIXEL_PACK_BUFFER};

BufferObject new_buffer() {
    GLuint name = 0;
    glGenBuffers(1, &name);
    return BufferObject{name};
}

}  // namespace

Buffer::Buffer(BufferUse use, BufferLife life) : object_(new_buffer()), use_(use), life_(life) {}

void Buffer::upload(const void* bytes, std::size_t size) {
    // Index buffers are part of the bound vertex array's state; going through GL_ARRAY_BUFFER
    // leaves whichever is bound alone.
    const GLenum target =
        use_ == BufferUse::Indices ? GL_ARRAY_BUFFER : kTargets[static_cast<std::size_t>(use_)];
    glBindBuffer(target, object_.name());
    glBufferData(target,
                 static_cast<GLsizeiptr>(size),
                 bytes,
                 life_ == BufferLife::Kept ? GL_STATIC_DRAW : GL_STREAM_DRAW);
    size_ = size;
}

void bind_uniforms(unsigned int binding,
                   const Buffer& buffer,
                   std::size_t offset,
                   std::size_t size) {
    glBindBufferRange(GL_UNIFORM_BUFFER,
                      binding,
                      buffer.name(),
                      static_cast<GLintptr>(offset),
                      static_cast<GLsizeiptr>(size));
}

void float_attribute(unsigned int location,
                     int count,
                     std::size_t stride,
                     std::size_t offset,
                     unsigned int divisor) {
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location,
                          count,
                          GL_FLOAT,
                          GL_FALSE,
                          static_cast<GLsizei>(stride),
                          reinterpret_cast<const void*>(offset));
    glVertexAttribDivisor(location, divisor);
}

}  // namespace plumbline::render::gl
