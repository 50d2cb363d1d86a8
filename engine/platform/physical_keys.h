// What is really down, asked of the X server. After a stall the window library may have missed
// releases (a desktop switch without a focus event), or the program was merely slow and the person
// still holds the key: only the server knows.
#pragma once

#include "engine/core/input_snapshot.h"

#include <optional>

namespace plumbline::platform {

struct PhysicalKeys {
    std::bitset<kKeyCount> keys;
    std::bitset<kMouseButtonCount> buttons;  ///< left, right and middle; others read as up
};

/// Needs GLFW to be running. Nothing where GLFW does not use X11.
std::optional<PhysicalKeys> read_physical_keys();

}  // namespace plumbline::platform
