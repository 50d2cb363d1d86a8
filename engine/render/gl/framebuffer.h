// Where drawing goes.
#pragma once

#include "engine/render/gl/object.h"
#include "engine/render/gl/texture.h"

namespace plumbline::render::gl {

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

}  // namespace plumbline::render::gl
