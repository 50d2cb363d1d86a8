// GPU memory, read back.
#include "engine/render/gl/buffer.h"
#include "tests/engine/render/gl_fixture.h"

#include <glad/gl.h>

namespace plumbline::render {
namespace {

class BufferGl : public GlTest {};

TEST_F(BufferGl, HoldsWhatWasUploadedLast) {
    using enum gl::BufferUse;
    for (const gl::BufferUse use : {Vertices, Indices, Uniforms, ReadBack}) {
        gl::Buffer buffer{use, gl::BufferLife::Kept};
        EXPECT_EQ(buffer.size(), 0U);
        buffer.upload("12345678", 8);
        buffer.upload("abcd", 4);
        EXPECT_EQ(buffer.size(), 4U);
        std::string found(4, '-');
        glBindBuffer(GL_COPY_READ_BUFFER, buffer.name());
        glGetBufferSubData(GL_COPY_READ_BUFFER, 0, 4, found.data());
        EXPECT_EQ(found, "abcd");
    }
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
}

TEST_F(BufferGl, UploadingIndicesLeavesTheBoundArraysAlone) {
    GLuint array = 0;
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    const gl::Buffer kept{gl::BufferUse::Indices, gl::BufferLife::Kept};
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, kept.name());
    gl::Buffer other{gl::BufferUse::Indices, gl::BufferLife::PerFrame};
    other.upload("abcd", 4);
    GLint bound = 0;
    glGetIntegerv(GL_ELEMENT_ARRAY_BUFFER_BINDING, &bound);
    EXPECT_EQ(static_cast<unsigned int>(bound), kept.name());
    glBindVertexArray(0);
    glDeleteVertexArrays(1, &array);
}

}  // namespace
}  // namespace plumbline::render
