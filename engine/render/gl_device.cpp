#include "engine/render/gl_device.h"

#include "engine/core/log.h"
#include "engine/render/gl/framebuffer.h"

#include <fmt/format.h>
#include <glad/gl.h>

#include <algorithm>
#include <string_view>

namespace plumbline::render {
namespace {

// In builds without NDEBUG, and where the context has KHR_debug: driver errors go to the log.
#ifdef NDEBUG

void listen_to_driver() {}

#else

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

void listen_to_driver() {
    if (GLAD_GL_KHR_debug == 0) return;
    glEnable(GL_DEBUG_OUTPUT);
    // Errors are then reported inside the call that made them: a breakpoint shows who.
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(on_message, nullptr);
}

#endif

std::string gl_text(GLenum name) {
    const auto* text = reinterpret_cast<const char*>(glGetString(name));
    return text != nullptr ? text : "unknown";
}

Result<GlInfo> load_gl(GlLoader loader) {
    const int version = loader != nullptr ? gladLoadGL(loader) : 0;
    if (version == 0) {
        return Error{"the driver hands out no OpenGL functions", ExitCode::NoDisplay};
    }
    GlInfo info{gl_text(GL_VENDOR), gl_text(GL_RENDERER), gl_text(GL_VERSION)};
    if (version < GLAD_MAKE_VERSION(3, 3)) {
        return Error{fmt::format("OpenGL 3.3 is needed; found {} ({}, {})",
                                 info.version,
                                 info.vendor,
                                 info.renderer),
                     ExitCode::NoDisplay};
    }
    return info;
}

/// Mesa's renderers that draw on the CPU: there every shadow lookup costs milliseconds.
bool is_software(const GlInfo& info) {
    return info.renderer.find("llvmpipe") != std::string::npos ||
           info.renderer.find("softpipe") != std::string::npos;
}

/// The driver's report of lost devices, by the name under which it has one; null: it has none.
ResetStatus reset_status_of(GlLoader loader) {
    const auto named = [&](const char* name) {
        return reinterpret_cast<ResetStatus>(loader(name));
    };
    GLint major = 0;
    GLint minor = 0;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    glGetIntegerv(GL_MINOR_VERSION, &minor);
    if (major * 10 + minor >= 45) return named("glGetGraphicsResetStatus");
    GLint count = 0;
    glGetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLint i = 0; i < count; ++i) {
        const auto* name =
            reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i)));
        if (name != nullptr && std::string_view(name) == "GL_ARB_robustness")
            return named("glGetGraphicsResetStatusARB");
    }
    return nullptr;
}

// More than a window has pixels; larger images only cost a software driver its memory.
constexpr std::uint32_t kSoftwareMap_px = 4096;

GpuLimits within_driver(GpuLimits limits, bool is_software_gl) {
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    const auto driver_px = static_cast<std::uint32_t>(std::max(largest, 1024));
    limits.texture_px = limits.texture_px == 0 ? driver_px : std::min(limits.texture_px, driver_px);
    if (limits.map_px == 0) limits.map_px = is_software_gl ? kSoftwareMap_px : limits.texture_px;
    limits.map_px = std::min(limits.map_px, limits.texture_px);
    const auto half_floats =
        gl::Texture::target(gl::TargetFormat::HdrColor, 4, 4, gl::Filter::Nearest);
    limits.half_float_targets =
        limits.half_float_targets && gl::Framebuffer{&half_floats, nullptr}.complete();
    if (!limits.half_float_targets)
        log_warning(
            "the driver draws into no half floats: light is cut at white, without bloom "
            "and exposure that adapts");
    return limits;
}

}  // namespace

Result<GlDevice> load_device(GlLoader loader, PresentTarget target, const GpuLimits& limits) {
    auto info = load_gl(loader);
    if (!info) return info.error();
    listen_to_driver();
    const bool is_software_gl = is_software(*info);
    return GlDevice{.device = {.limits = within_driver(limits, is_software_gl),
                               .is_software_gl = is_software_gl,
                               .is_offscreen = target == PresentTarget::Offscreen},
                    .info = std::move(*info),
                    .reset_status = reset_status_of(loader)};
}

}  // namespace plumbline::render
