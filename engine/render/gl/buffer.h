// GPU memory for vertices, indices, instances and uniform blocks.
#pragma once

#include "engine/render/gl/object.h"

#include <cstddef>

namespace plumbline::render::gl {

enum class BufferUse { Vertices, Indices, Uniforms, ReadBack };
enum class BufferLife { Kept, PerFrame };

class Buffer {
public:
    Buffer() = default;
    Buffer(BufferUse use, BufferLife life);

    /// Replaces the whole content. The old storage is left to draws still under way.
    void upload(const void* bytes, std::size_t size);

    unsigned int name() const { return object_.name(); }
    std::size_t size() const { return size_; }

private:
    BufferObject object_;
    BufferUse use_{BufferUse::Vertices};
    BufferLife life_{BufferLife::Kept};
    std::size_t size_{0};
};

/// Makes `size` bytes at `offset` what the shaders' block `binding` reads.
void bind_uniforms(unsigned int binding,
                   const Buffer& buffer,
                   std::size_t offset,
                   std::size_t size);

/// A vertex attribute of the bound vertex array: `count` floats at `offset` of each vertex, or of each
/// instance where `divisor` is 1, in the buffer uploaded or bound last.
void float_attribute(unsigned int location,
                     int count,
                     std::size_t stride,
                     std::size_t offset,
                     unsigned int divisor = 0);

}  // namespace plumbline::render::gl
