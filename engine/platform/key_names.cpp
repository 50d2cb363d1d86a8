#include "engine/core/text/text_case.h"
#include "engine/platform/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace plumbline::platform {
namespace {

struct NamedKey {
    int key;
    std::string_view name;
};

// Keys that print nothing, and the keypad: GLFW says "1" for both 1 and keypad 1.
constexpr auto kNamedKeys = std::to_array<NamedKey>({
    {GLFW_KEY_SPACE, "Space"},
    {GLFW_KEY_ESCAPE, "Escape"},
    {GLFW_KEY_ENTER, "Enter"},
    {GLFW_KEY_TAB, "Tab"},
    {GLFW_KEY_BACKSPACE, "Backspace"},
    {GLFW_KEY_INSERT, "Insert"},
    {GLFW_KEY_DELETE, "Delete"},
    {GLFW_KEY_RIGHT, "Right"},
    {GLFW_KEY_LEFT, "Left"},
    {GLFW_KEY_DOWN, "Down"},
    {GLFW_KEY_UP, "Up"},
    {GLFW_KEY_PAGE_UP, "Page Up"},
    {GLFW_KEY_PAGE_DOWN, "Page Down"},
    {GLFW_KEY_HOME, "Home"},
    {GLFW_KEY_END, "End"},
    {GLFW_KEY_CAPS_LOCK, "Caps Lock"},
    {GLFW_KEY_SCROLL_LOCK, "Scroll Lock"},
    {GLFW_KEY_NUM_LOCK, "Num Lock"},
    {GLFW_KEY_PRINT_SCREEN, "Print Screen"},
    {GLFW_KEY_PAUSE, "Pause"},
    {GLFW_KEY_KP_DECIMAL, "Keypad ."},
    {GLFW_KEY_KP_DIVIDE, "Keypad /"},
    {GLFW_KEY_KP_MULTIPLY, "Keypad *"},
    {GLFW_KEY_KP_SUBTRACT, "Keypad -"},
    {GLFW_KEY_KP_ADD, "Keypad +"},
    {GLFW_KEY_KP_ENTER, "Keypad Enter"},
    {GLFW_KEY_KP_EQUAL, "Keypad ="},
    {GLFW_KEY_LEFT_SHIFT, "Left Shift"},
    {GLFW_KEY_LEFT_CONTROL, "Left Ctrl"},
    {GLFW_KEY_LEFT_ALT, "Left Alt"},
    {GLFW_KEY_LEFT_SUPER, "Left Super"},
    {GLFW_KEY_RIGHT_SHIFT, "Right Shift"},
    {GLFW_KEY_RIGHT_CONTROL, "Right Ctrl"},
    {GLFW_KEY_RIGHT_ALT, "Right Alt"},
    {GLFW_KEY_RIGHT_SUPER, "Right Super"},
    {GLFW_KEY_MENU, "Menu"},
});

}  // namespace

std::string printed_key_name(int key) {
    const auto* const named = std::ranges::find(kNamedKeys, key, &NamedKey::key);
    if (named != kNamedKeys.end()) return std::string{named->name};
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
