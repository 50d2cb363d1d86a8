#include "engine/core/text/split.h"
#include "engine/core/text/text_case.h"
#include "engine/platform/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <array>
#include <string_view>

namespace plumbline::platform {
namespace {

/// Names of keys whose codes follow one another.
struct KeyRow {
    int first;
    std::string_view names;  ///< with a comma between two
};

// Keys that print nothing, and the keypad: GLFW says "1" for both 1 and keypad 1.
constexpr auto kKeyRows = std::to_array<KeyRow>({
    {GLFW_KEY_SPACE, "Space"},
    {GLFW_KEY_ESCAPE, "Escape,Enter,Tab,Backspace,Insert,Delete,Right,Left,Down,Up"},
    {GLFW_KEY_PAGE_UP, "Page Up,Page Down,Home,End"},
    {GLFW_KEY_CAPS_LOCK, "Caps Lock,Scroll Lock,Num Lock,Print Screen,Pause"},
    {GLFW_KEY_KP_DECIMAL, "Keypad .,Keypad /,Keypad *,Keypad -,Keypad +,Keypad Enter,Keypad ="},
    {GLFW_KEY_LEFT_SHIFT, "Left Shift,Left Ctrl,Left Alt,Left Super"},
    {GLFW_KEY_RIGHT_SHIFT, "Right Shift,Right Ctrl,Right Alt,Right Super,Menu"},
});

/// Empty for keys that are named by what they print.
std::string_view name_in_rows(int key) {
    for (const KeyRow& row : kKeyRows) {
        int code = row.first;
        for (std::string_view rest = row.names; !rest.empty(); ++code) {
            const std::string_view name = cut_part(rest, ',');
            if (code == key) return name;
        }
    }
    return {};
}

}  // namespace

std::string printed_key_name(int key) {
    if (const std::string_view named = name_in_rows(key); !named.empty()) return std::string{named};
    if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F25)
        return "F" + std::to_string(key - GLFW_KEY_F1 + 1);
    if (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_9)
        return "Keypad " + std::to_string(key - GLFW_KEY_KP_0);
    if (key < 0) return {};
    const char* printed = glfwGetKeyName(key, 0);
    if (printed != nullptr && *printed != '\0') return printed;
    // Without a window system there is no layout to ask: the US letter, which is GLFW's code.
    const bool prints_ascii = key > GLFW_KEY_SPACE && key <= GLFW_KEY_GRAVE_ACCENT;
    if (!prints_ascii) return {};
    return std::string(1, to_lower(static_cast<char>(key)));
}

}  // namespace plumbline::platform
