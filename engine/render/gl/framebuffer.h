// Where drawing goes.
#pragma once

#include "engine/render/gl/object.h"
#include "engine/render/gl/texture.h"

#include <cstdint>

namespace plumbline::render::gl {

/// Pixels, from the left and from the bottom; the last ones are outside.
struct PixelRect {
    int left{0};
    int bottom{0};
    int right{0};
    int top{0};

    bool empty() const { return left >= right || bottom >= top; }
    bool overlaps(const PixelRect& other) const {
        return left < other.right && other.left < right && bottom < other.top && other.bottom < top;
    }
};

class Framebuffer {
public:
    Framebuffer() = default;
    /// Either may be null, not both. The textures must outlive it. Check complete() before use:
    /// a driver out of memory says so there.
    Framebuffer(const Texture* color, const Texture* depth);

    unsigned int name() const { return object_.name(); }
    explicit operator bool() const { return static_cast<bool>(object_); }
    bool complete() const { return complete_; }

private:
    FramebufferObject object_;
    bool complete_{false};
};

/// Makes it what is drawn into, all of it; 0: the window's.
void draw_into(unsigned int framebuffer, std::uint32_t width, std::uint32_t height);
/// `buffers`: GL's bits. Afterwards neither is what is drawn into.
void copy(const Framebuffer& from,
          const PixelRect& rect,
          const Framebuffer& to,
          const PixelRect& into,
          unsigned int buffers);

}  // namespace plumbline::render::gl
