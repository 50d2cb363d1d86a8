// Lines of SDL's gamepad database, checked by us: GLFW 3.3 reports success on garbage.
#pragma once

#include "engine/core/result.h"

#include <string>
#include <string_view>
#include <vector>

namespace plumbline::platform {

/// "03000000…,Name,a:b0,leftx:a0,platform:Linux,": the error says what is wrong with it.
Result<Done> check_gamepad_mapping(std::string_view line);

/// Mapping lines of one text that can be used, and what is wrong with the others.
struct GamepadMappings {
    std::vector<std::string> accepted;
    std::vector<std::string> rejected;  ///< "3: unknown element \"aa\"", the line's number first
};

/// Comments (#) and empty lines are skipped, lines for other platforms too.
GamepadMappings read_gamepad_mappings(std::string_view text);

}  // namespace plumbline::platform
