#include "engine/platform/physical_keys.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <dlfcn.h>

#include <array>

namespace plumbline::platform {
namespace {

// Xlib by name, not by header: a GLFW for Wayland has none of it, and then there is nothing to ask.
using GetDisplay = void* (*)();
using QueryKeymap = int (*)(void* display, char* keys32);
using DefaultRootWindow = unsigned long (*)(void* display);
using QueryPointer = int (*)(void* display,
                             unsigned long window,
                             unsigned long* root,
                             unsigned long* child,
                             int* root_x,
                             int* root_y,
                             int* window_x,
                             int* window_y,
                             unsigned int* mask);

template <class Function>
Function find_function(const char* name) {
    return reinterpret_cast<Function>(dlsym(RTLD_DEFAULT, name));
}

}  // namespace

std::optional<PhysicalKeys> read_physical_keys() {
    static const auto kGetDisplay = find_function<GetDisplay>("glfwGetX11Display");
    static const auto kQueryKeymap = find_function<QueryKeymap>("XQueryKeymap");
    static const auto kRootWindow = find_function<DefaultRootWindow>("XDefaultRootWindow");
    static const auto kQueryPointer = find_function<QueryPointer>("XQueryPointer");
    if (kGetDisplay == nullptr || kQueryKeymap == nullptr || kRootWindow == nullptr ||
        kQueryPointer == nullptr)
        return std::nullopt;
    void* display = kGetDisplay();
    if (display == nullptr) return std::nullopt;

    PhysicalKeys down;
    std::array<char, 32> bits{};  // one bit for each key code of X, which is GLFW's scancode
    kQueryKeymap(display, bits.data());
    for (int key = GLFW_KEY_SPACE; key <= GLFW_KEY_LAST; ++key) {
        const int code = glfwGetKeyScancode(key);
        if (code < 0 || code > 255) continue;
        const auto byte = static_cast<unsigned char>(bits[static_cast<std::size_t>(code / 8)]);
        down.keys[static_cast<std::size_t>(key)] = ((byte >> (code % 8)) & 1) != 0;
    }
    unsigned long root = 0;
    unsigned long child = 0;
    std::array<int, 4> unused{};
    unsigned int mask = 0;
    kQueryPointer(display,
                  kRootWindow(display),
                  &root,
                  &child,
                  &unused[0],
                  &unused[1],
                  &unused[2],
                  &unused[3],
                  &mask);
    down.buttons[GLFW_MOUSE_BUTTON_LEFT] = (mask & (1U << 8)) != 0;
    down.buttons[GLFW_MOUSE_BUTTON_MIDDLE] = (mask & (1U << 9)) != 0;
    down.buttons[GLFW_MOUSE_BUTTON_RIGHT] = (mask & (1U << 10)) != 0;
    return down;
}

}  // namespace plumbline::platform
