// An OpenGL 3.3 core context without a window: EGL surfaceless, no X server needed; a hidden GLFW
// window where EGL cannot.
#pragma once

#include "engine/core/result.h"
#include "engine/platform/window.h"

#include <memory>

namespace plumbline::platform {

/// Drivers crash where memory is refused to them later on. The error, with exit code 3, is for a limit
/// (ulimit -v) that leaves less than a large scene takes.
Result<Done> check_memory_for_opengl();

/// The context is current in the calling thread from creation to destruction. There is no default
/// framebuffer to draw into: the renderer draws into its own.
class OffscreenContext {
public:
    static Result<std::unique_ptr<OffscreenContext>> create();
    ~OffscreenContext();
    OffscreenContext(const OffscreenContext&) = delete;
    OffscreenContext& operator=(const OffscreenContext&) = delete;

    GlLoader gl_loader() const;

private:
    struct Impl;
    explicit OffscreenContext(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace plumbline::platform
