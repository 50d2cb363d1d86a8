#include "engine/platform/offscreen.h"

#include "engine/core/log.h"
#include "engine/core/process/process_memory.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>

#include <array>
#include <cstring>
#include <utility>

namespace plumbline::platform {

struct OffscreenContext::Impl {
    EGLDisplay display{EGL_NO_DISPLAY};
    EGLContext context{EGL_NO_CONTEXT};
    std::unique_ptr<Window> hidden_window;

    ~Impl() {
        if (display == EGL_NO_DISPLAY) return;
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
        eglTerminate(display);
    }
};

namespace {

bool has_extension(const char* list, const char* name) {
    return list != nullptr && std::strstr(list, name) != nullptr;
}

/// Displays that need no window system, likeliest first: Mesa's surfaceless platform, then the
/// first graphics device (other vendors' drivers), then whatever the system calls its default.
std::array<EGLDisplay, 3> candidate_displays() {
    std::array<EGLDisplay, 3> displays{EGL_NO_DISPLAY, EGL_NO_DISPLAY, EGL_NO_DISPLAY};
    const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    const auto get_display = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
        eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (get_display != nullptr && has_extension(extensions, "EGL_MESA_platform_surfaceless")) {
        displays[0] = get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    }
    if (get_display != nullptr && has_extension(extensions, "EGL_EXT_platform_device")) {
        const auto query_devices =
            reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
        EGLDeviceEXT device = EGL_NO_DEVICE_EXT;
        EGLint count = 0;
        if (query_devices != nullptr && query_devices(1, &device, &count) == EGL_TRUE &&
            count > 0) {
            displays[1] = get_display(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
        }
    }
    displays[2] = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    return displays;
}

EGLContext create_core_context(EGLDisplay display) {
    if (eglBindAPI(EGL_OPENGL_API) != EGL_TRUE) return EGL_NO_CONTEXT;
    const std::array<std::pair<EGLint, EGLint>, 3> versions{{{4, 5}, {4, 3}, {3, 3}}};
    for (const auto& [major, minor] : versions) {
        const std::array<EGLint, 7> attributes{EGL_CONTEXT_MAJOR_VERSION,
                                               major,
                                               EGL_CONTEXT_MINOR_VERSION,
                                               minor,
                                               EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                               EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                               EGL_NONE};
        EGLContext context =
            eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.data());
        if (context != EGL_NO_CONTEXT) return context;
    }
    return EGL_NO_CONTEXT;
}

bool open_on(EGLDisplay display, EGLContext& context) {
    if (display == EGL_NO_DISPLAY) return false;
    if (eglInitialize(display, nullptr, nullptr) != EGL_TRUE) return false;
    context = create_core_context(display);
    if (context != EGL_NO_CONTEXT &&
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE) {
        return true;
    }
    if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
    context = EGL_NO_CONTEXT;
    eglTerminate(display);
    return false;
}

}  // namespace

Result<Done> check_memory_for_opengl() {
    constexpr std::size_t kMiB = 1024 * 1024;
    constexpr std::size_t kMost = 1536;
    if (may_still_map(kMost * kMiB)) return Done{};
    return Error{
        .message = fmt::format("drawing takes up to {} MiB of address space, and the limit on "
                               "it (ulimit -v) leaves less",
                               kMost),
        .exit_code = ExitCode::NoDisplay};
}

Result<std::unique_ptr<OffscreenContext>> OffscreenContext::create() {
    if (Result<Done> room = check_memory_for_opengl(); !room) return room.error();
    auto impl = std::make_unique<Impl>();
    for (EGLDisplay display : candidate_displays()) {
        if (!open_on(display, impl->context)) continue;
        impl->display = display;
        return std::unique_ptr<OffscreenContext>(new OffscreenContext(std::move(impl)));
    }
    auto hidden = Window::open({.vsync = false, .visible = false});
    if (hidden) {
        impl->hidden_window = std::move(*hidden);
        return std::unique_ptr<OffscreenContext>(new OffscreenContext(std::move(impl)));
    }
    return Error{
        "no off-screen OpenGL 3.3 context: EGL offers none here (install libegl-mesa0 and "
        "libgl1-mesa-dri for software drawing) and a hidden window failed too: " +
            hidden.error().message,
        ExitCode::NoDisplay};
}

OffscreenContext::OffscreenContext(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
OffscreenContext::~OffscreenContext() = default;

GlLoader OffscreenContext::gl_loader() const {
    if (impl_->hidden_window) return impl_->hidden_window->gl_loader();
    return [](const char* name) { return eglGetProcAddress(name); };
}

}  // namespace plumbline::platform
