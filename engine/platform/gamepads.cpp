#include "engine/platform/gamepads.h"

#include "engine/core/io/files.h"
#include "engine/core/limits.h"
#include "engine/core/log.h"
#include "engine/platform/gamepad_mapping.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <array>
#include <cstdlib>
#include <filesystem>

namespace plumbline::platform {
namespace {

static_assert(kPadButtonCount == GLFW_GAMEPAD_BUTTON_LAST + 1);
static_assert(kPadAxisCount == GLFW_GAMEPAD_AXIS_LAST + 1);

constexpr std::size_t kMappingFileBytes = 4 * 1024 * 1024;

void use_mappings(std::string_view name, std::string_view text) {
    const GamepadMappings mappings = read_gamepad_mappings(text);
    for (const std::string& line : mappings.accepted) glfwUpdateGamepadMappings(line.c_str());
    for (const std::string& reason : mappings.rejected)
        log_warning("{}:{}. This gamepad mapping is left out.", name, reason);
    log_debug("{}: {} gamepad mappings taken, {} left out",
              name,
              mappings.accepted.size(),
              mappings.rejected.size());
}

std::string text_of(const char* text) {
    return text == nullptr ? std::string{} : std::string{text};
}

}  // namespace

void Gamepads::load_mappings() {
    const std::filesystem::path folder = user_data_folder();
    if (!folder.empty()) {
        const std::filesystem::path file = folder / "gamecontrollerdb.txt";
        std::error_code ignored;
        if (std::filesystem::exists(file, ignored)) {
            const Result<std::string> text = read_file(file, kMappingFileBytes);
            if (text) {
                use_mappings("gamecontrollerdb.txt", *text);
            } else {
                log_warning("{}. Its gamepad mappings are left out.", text.error().message);
            }
        }
    }
    if (const char* lines = std::getenv("SDL_GAMECONTROLLERCONFIG"); lines != nullptr)
        use_mappings("SDL_GAMECONTROLLERCONFIG", lines);
}

int pad_to_read(std::span<const std::string> guids, int index, const std::string& guid) {
    const auto is_there = [&](std::size_t i) { return !guids[i].empty() && guids[i] == guid; };
    if (index >= 0 && is_there(static_cast<std::size_t>(index))) return index;
    int first = -1;
    for (std::size_t i = 0; i < guids.size(); ++i) {
        if (is_there(i)) return static_cast<int>(i);
        if (first < 0 && !guids[i].empty()) first = static_cast<int>(i);
    }
    return first;
}

int Gamepads::find_pad() {
    std::array<std::string, GLFW_JOYSTICK_LAST + 1> guids;
    for (int i = GLFW_JOYSTICK_1; i <= GLFW_JOYSTICK_LAST; ++i)
        if (glfwJoystickIsGamepad(i) == GLFW_TRUE)
            guids[static_cast<std::size_t>(i)] = text_of(glfwGetJoystickGUID(i));
    return pad_to_read(guids, index_, guid_);
}

PadReading Gamepads::read() {
    index_ = find_pad();
    PadReading reading;
    GLFWgamepadstate state{};
    if (index_ >= 0 && glfwGetGamepadState(index_, &state) == GLFW_TRUE) {
        reading.present = true;
        for (std::size_t i = 0; i < reading.buttons.size(); ++i)
            reading.buttons[i] = state.buttons[i] == GLFW_PRESS;
        for (std::size_t i = 0; i < reading.axes.size(); ++i) reading.axes[i] = state.axes[i];
        guid_ = text_of(glfwGetJoystickGUID(index_));
    }
    if (reading.present != was_present_) {
        if (reading.present) {
            log_note("gamepad: {}", text_of(glfwGetGamepadName(index_)));
        } else {
            log_note("gamepad unplugged");
        }
        was_present_ = reading.present;
    }
    return reading;
}

}  // namespace plumbline::platform
