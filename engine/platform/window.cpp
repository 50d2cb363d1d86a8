#include "engine/platform/window.h"

#include "engine/core/log.h"
#include "engine/platform/gamepads.h"
#include "engine/platform/offscreen.h"
#include "engine/platform/physical_keys.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <clocale>
#include <cstdlib>

namespace plumbline::platform {
namespace {

constexpr int kSmallestSide = 64;     // screen coordinates
constexpr int kLargestSide = 16'384;  // beyond every texture limit of today
constexpr double kHiddenFrame_s = 0.1;

struct GlVersion {
    int major;
    int minor;
};
constexpr auto kGlVersions = std::to_array<GlVersion>({{4, 5}, {4, 3}, {3, 3}});

// GLFW is one library for the whole process, and the last window to go ends it.
int open_window_count = 0;

struct Rectangle {
    int x{0};
    int y{0};
    int width{0};
    int height{0};
};

std::string last_glfw_words() {
    const char* words = nullptr;
    glfwGetError(&words);
    return words == nullptr ? "no reason given" : words;
}

Error no_display_error(const std::string& words) {
    const char* display = std::getenv("DISPLAY");
    const std::string state = display == nullptr || *display == '\0'
                                  ? std::string{"DISPLAY is not set"}
                                  : fmt::format("DISPLAY={} does not answer", display);
    return {.message = fmt::format("no display: {} ({}). Set DISPLAY, or draw without a screen: "
                                   "./play renders a tour into out/, plumbline render SCENE "
                                   "--out FILE.png one image",
                                   state,
                                   words),
            .exit_code = ExitCode::NoDisplay};
}

/// "vendor, renderer, OpenGL version" of whatever context the driver gives when asked for nothing.
std::string describe_any_context() {
    using GetString = const unsigned char* (*)(unsigned int);
    glfwDefaultWindowHints();
    // A driver that can tell of a lost device does; others do not mind.
    glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS, GLFW_LOSE_CONTEXT_ON_RESET);
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    GLFWwindow* probe = glfwCreateWindow(16, 16, "", nullptr, nullptr);
    if (probe == nullptr) return "no OpenGL";
    glfwMakeContextCurrent(probe);
    std::string found = "a context without version information";
    const auto get_string = reinterpret_cast<GetString>(glfwGetProcAddress("glGetString"));
    if (get_string != nullptr) {
        constexpr std::array<unsigned int, 3> kNames{0x1F00, 0x1F01, 0x1F02};
        std::array<std::string, 3> texts;
        for (std::size_t i = 0; i < kNames.size(); ++i) {
            const unsigned char* text = get_string(kNames[i]);
            if (text != nullptr) texts[i] = reinterpret_cast<const char*>(text);
        }
        found = fmt::format("{}, {}, OpenGL {}", texts[0], texts[1], texts[2]);
    }
    glfwDestroyWindow(probe);
    return found;
}

Error no_gl_error(const std::string& words) {
    const std::string found = describe_any_context();
    std::string hint = "LIBGL_ALWAYS_SOFTWARE=1 draws on the CPU";
    if (words.find("swrast") != std::string::npos || words.find("fbconfig") != std::string::npos ||
        words.find("FBConfig") != std::string::npos) {
        hint +=
            "; if OpenGL worked before, driver and kernel module may differ: reboot or "
            "reinstall Mesa or the vendor's driver";
    }
    return {.message = fmt::format(
                "no usable OpenGL: 3.3 core is needed, found {} ({}). {}", found, words, hint),
            .exit_code = ExitCode::NoDisplay};
}

void set_hints(const WindowDef& def, GlVersion version) {
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, version.major);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, version.minor);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_VISIBLE, def.visible ? GLFW_TRUE : GLFW_FALSE);
    glfwWindowHintString(GLFW_X11_CLASS_NAME, "plumbline");
    glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "plumbline");
}

Rectangle rectangle_of(GLFWwindow* window) {
    Rectangle area;
    glfwGetWindowPos(window, &area.x, &area.y);
    glfwGetWindowSize(window, &area.width, &area.height);
    return area;
}

/// The monitor that shows most of the window, else the primary one; null when there is none.
GLFWmonitor* monitor_of(const Rectangle& window) {
    int count = 0;
    GLFWmonitor** monitors = glfwGetMonitors(&count);
    GLFWmonitor* best = glfwGetPrimaryMonitor();
    int best_area = 0;
    for (int i = 0; i < count; ++i) {
        const GLFWvidmode* mode = glfwGetVideoMode(monitors[i]);
        if (mode == nullptr) continue;
        int x = 0;
        int y = 0;
        glfwGetMonitorPos(monitors[i], &x, &y);
        const int width =
            std::min(window.x + window.width, x + mode->width) - std::max(window.x, x);
        const int height =
            std::min(window.y + window.height, y + mode->height) - std::max(window.y, y);
        if (width <= 0 || height <= 0 || width * height <= best_area) continue;
        best_area = width * height;
        best = monitors[i];
    }
    return best;
}

/// No larger than the monitor's work area: what lies outside cannot be seen, and without a window
/// manager nobody can move the window.
PixelSize fitted(int width, int height) {
    PixelSize size{std::clamp(width, kSmallestSide, kLargestSide),
                   std::clamp(height, kSmallestSide, kLargestSide)};
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    if (monitor == nullptr) return size;
    PixelSize room;
    glfwGetMonitorWorkarea(monitor, nullptr, nullptr, &room.width, &room.height);
    if (room.width >= kSmallestSide) size.width = std::min(size.width, room.width);
    if (room.height >= kSmallestSide) size.height = std::min(size.height, room.height);
    return size;
}

}  // namespace

struct Window::Impl {
    GLFWwindow* window{nullptr};
    DeviceEvents events;
    Gamepads gamepads;
    Rectangle windowed;  ///< where the window was before full screen
    bool vsync{true};
    bool visible{true};  ///< is meant to be
    bool captured{false};
    bool iconified{false};
    bool wants_fullscreen{false};

    static Impl& of(GLFWwindow* window) {
        return *static_cast<Impl*>(glfwGetWindowUserPointer(window));
    }

    void install_callbacks();
    void follow_iconify();
    void apply_vsync() const { glfwSwapInterval(vsync ? 1 : 0); }
    void leave_fullscreen() const;
};

void Window::Impl::install_callbacks() {
    glfwSetWindowUserPointer(window, this);
    glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int, int action, int) {
        if (action != GLFW_REPEAT) of(w).events.on_key(key, action == GLFW_PRESS);
    });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int) {
        of(w).events.on_mouse_button(button, action == GLFW_PRESS);
    });
    glfwSetScrollCallback(
        window, [](GLFWwindow* w, double left, double up) { of(w).events.on_scroll(-left, up); });
    glfwSetCursorPosCallback(
        window, [](GLFWwindow* w, double x, double y) { of(w).events.on_cursor(x, y); });
    glfwSetWindowFocusCallback(
        window, [](GLFWwindow* w, int focused) { of(w).events.on_focus(focused == GLFW_TRUE); });
    glfwSetWindowCloseCallback(window, [](GLFWwindow* w) {
        glfwSetWindowShouldClose(w, GLFW_FALSE);  // whoever reads the snapshot decides
        of(w).events.on_close();
    });
    glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** paths) {
        for (int i = 0; i < count; ++i) of(w).events.on_drop(paths[i]);
    });
}

// Without a window manager a window is hidden by unmapping alone, which GLFW does not report: both
// are asked for.
void Window::Impl::follow_iconify() {
    const bool is_unmapped = visible && glfwGetWindowAttrib(window, GLFW_VISIBLE) != GLFW_TRUE;
    const bool now = is_unmapped || glfwGetWindowAttrib(window, GLFW_ICONIFIED) == GLFW_TRUE;
    if (now == iconified) return;
    iconified = now;
    events.on_iconify(now);
}

void Window::Impl::leave_fullscreen() const {
    const int width = std::max(windowed.width, kSmallestSide);
    const int height = std::max(windowed.height, kSmallestSide);
    glfwSetWindowMonitor(window, nullptr, windowed.x, windowed.y, width, height, GLFW_DONT_CARE);
}

Window::Window(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

Window::~Window() {
    glfwDestroyWindow(impl_->window);
    if (--open_window_count == 0) glfwTerminate();
}

Result<std::unique_ptr<Window>> Window::open(const WindowDef& def) {
    if (Result<Done> room = check_memory_for_opengl(); !room) return room.error();
    // Names of keys come in the user's encoding; numbers keep their point.
    std::setlocale(LC_CTYPE, "");
    if (glfwInit() != GLFW_TRUE) return no_display_error(last_glfw_words());

    const PixelSize size = fitted(def.width, def.height);
    GLFWwindow* window = nullptr;
    std::string words;
    for (const GlVersion version : kGlVersions) {
        set_hints(def, version);
        window = glfwCreateWindow(size.width, size.height, def.title.c_str(), nullptr, nullptr);
        if (window != nullptr) {
            log_debug("window: OpenGL {}.{} core", version.major, version.minor);
            break;
        }
        words = last_glfw_words();
        log_debug("window: no OpenGL {}.{} core: {}", version.major, version.minor, words);
    }
    if (window != nullptr) glfwMakeContextCurrent(window);
    if (window == nullptr || glfwGetProcAddress("glGetString") == nullptr) {
        Error error =
            no_gl_error(window == nullptr ? words : "the OpenGL functions cannot be loaded");
        if (window != nullptr) glfwDestroyWindow(window);
        if (open_window_count == 0) glfwTerminate();
        return error;
    }

    ++open_window_count;
    auto impl = std::make_unique<Impl>();
    impl->window = window;
    impl->vsync = def.vsync;
    impl->visible = def.visible;
    impl->windowed = rectangle_of(window);
    impl->apply_vsync();
    impl->install_callbacks();
    Gamepads::load_mappings();
    return std::unique_ptr<Window>(new Window(std::move(impl)));
}

InputSnapshot Window::poll_input() {
    glfwPollEvents();
    impl_->follow_iconify();
    const PixelSize in_pixels = framebuffer_size();
    const PixelSize in_units = window_size();
    if (in_pixels.width > 0 && in_units.width > 0 && in_units.height > 0) {
        impl_->events.set_pixel_ratio(
            static_cast<double>(in_pixels.width) / static_cast<double>(in_units.width),
            static_cast<double>(in_pixels.height) / static_cast<double>(in_units.height));
    }
    const double polled_s = now_s();
    if (impl_->events.is_stalled(polled_s)) {
        if (const auto down = read_physical_keys())
            impl_->events.confirm_down(down->keys, down->buttons);
    }
    InputSnapshot snapshot = impl_->events.take(polled_s, impl_->gamepads.read());
    if (snapshot.lost_focus) capture_pointer(false);
    if (impl_->wants_fullscreen && !fullscreen()) {
        // GLFW took the window off a monitor that went away.
        log_note("the fullscreen monitor was disconnected: switched to windowed mode");
        impl_->wants_fullscreen = false;
        impl_->leave_fullscreen();
    }
    return snapshot;
}

void Window::present() {
    // A hidden window has nothing to show, and nobody waits for its frames.
    if (iconified()) {
        glfwWaitEventsTimeout(kHiddenFrame_s);
    } else {
        glfwSwapBuffers(impl_->window);
    }
}

double Window::now_s() const {
    return glfwGetTime();
}

PixelSize Window::framebuffer_size() const {
    if (impl_->iconified) return {};
    PixelSize size;
    glfwGetFramebufferSize(impl_->window, &size.width, &size.height);
    if (size.width <= 0 || size.height <= 0) return {};
    return size;
}

PixelSize Window::window_size() const {
    PixelSize size;
    glfwGetWindowSize(impl_->window, &size.width, &size.height);
    return size;
}

float Window::content_scale() const {
    float x = 1.0F;
    float y = 1.0F;
    glfwGetWindowContentScale(impl_->window, &x, &y);
    constexpr float kSmallest = 0.5F;
    constexpr float kLargest = 4.0F;
    return std::clamp(std::max(x, y), kSmallest, kLargest);
}

bool Window::iconified() const {
    return framebuffer_size().width == 0;
}

void Window::capture_pointer(bool captured) {
    if (impl_->captured == captured) return;
    impl_->captured = captured;
    glfwSetInputMode(
        impl_->window, GLFW_CURSOR, captured ? GLFW_CURSOR_DISABLED : GLFW_CURSOR_NORMAL);
    if (glfwRawMouseMotionSupported() == GLFW_TRUE)
        glfwSetInputMode(impl_->window, GLFW_RAW_MOUSE_MOTION, captured ? GLFW_TRUE : GLFW_FALSE);
    impl_->events.set_captured(captured);
}

bool Window::pointer_captured() const {
    return impl_->captured;
}

void Window::set_fullscreen(bool fullscreen_wanted) {
    if (fullscreen_wanted == fullscreen()) return;
    if (fullscreen_wanted) {
        const Rectangle area = rectangle_of(impl_->window);
        GLFWmonitor* monitor = monitor_of(area);
        const GLFWvidmode* mode = monitor == nullptr ? nullptr : glfwGetVideoMode(monitor);
        if (mode == nullptr) {
            log_warning("no monitor for fullscreen: staying in windowed mode");
            return;
        }
        impl_->windowed = area;
        glfwSetWindowMonitor(
            impl_->window, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
    } else {
        impl_->leave_fullscreen();
    }
    impl_->wants_fullscreen = fullscreen_wanted;
    impl_->apply_vsync();
}

void Window::set_vsync(bool vsync) {
    if (impl_->vsync == vsync) return;
    impl_->vsync = vsync;
    impl_->apply_vsync();
}

bool Window::fullscreen() const {
    return glfwGetWindowMonitor(impl_->window) != nullptr;
}

void Window::show(const std::string& title, int width, int height) {
    set_title(title);
    const PixelSize size = fitted(width, height);
    glfwSetWindowSize(impl_->window, size.width, size.height);
    glfwShowWindow(impl_->window);
    impl_->visible = true;
    impl_->windowed = rectangle_of(impl_->window);
}

void Window::set_title(const std::string& title) {
    glfwSetWindowTitle(impl_->window, title.c_str());
}

std::uint64_t Window::pointer_jumps_dropped() const {
    return impl_->events.jumps_dropped();
}

GlLoader Window::gl_loader() const {
    return glfwGetProcAddress;
}

GLFWwindow* Window::handle() const {
    return impl_->window;
}

}  // namespace plumbline::platform
