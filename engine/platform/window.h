// A window with an OpenGL 3.3 core context. The only user of GLFW.
#pragma once

#include "engine/core/input_snapshot.h"
#include "engine/core/result.h"

#include <cstdint>
#include <memory>
#include <string>

struct GLFWwindow;

namespace plumbline::platform {

struct WindowDef {
    std::string title{"Plumbline"};
    int width{1280};  ///< screen coordinates
    int height{720};
    bool vsync{true};
    bool visible{true};
};

struct PixelSize {
    int width{0};
    int height{0};
};

using GlLoader = void (*(*)(const char*))();

class Window {
public:
    /// Tries GL 4.5, 4.3, then 3.3 core. No display: exit code 3 and the variable to set.
    static Result<std::unique_ptr<Window>> open(const WindowDef& def);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    /// Takes what the devices did since the last call; spans nothing, copies everything. Losing
    /// the focus frees the pointer.
    InputSnapshot poll_input();
    /// Shows what was drawn; while iconified it waits for events, at most 0.1 s, instead.
    void present();
    double now_s() const;

    PixelSize framebuffer_size() const;  ///< 0 x 0 while iconified
    PixelSize window_size() const;
    float content_scale() const;
    bool iconified() const;

    /// Hides and captures the pointer, with raw motion where available. Drops the first delta after
    /// capture and single reports above DeviceEvents::kJump_counts.
    void capture_pointer(bool captured);
    bool pointer_captured() const;
    void set_fullscreen(bool fullscreen);
    bool fullscreen() const;
    void set_vsync(bool vsync);
    void set_title(const std::string& title);
    /// Shows a window that was opened with `visible` false; sizes in screen coordinates, at most the
    /// monitor's.
    void show(const std::string& title, int width, int height);
    /// Pointer reports dropped because the window system, not a person, moved the pointer.
    std::uint64_t pointer_jumps_dropped() const;

    GlLoader gl_loader() const;
    GLFWwindow* handle() const;  ///< for Dear ImGui's back end only

private:
    struct Impl;
    explicit Window(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

/// What the key in this place prints in the user's layout ("w", "z" on a French keyboard), now; the
/// name on the key for those that print nothing ("Space", "Keypad 1"). GLFW key code; empty for
/// unknown ones. Without a window: the US layout.
std::string printed_key_name(int key);

}  // namespace plumbline::platform
