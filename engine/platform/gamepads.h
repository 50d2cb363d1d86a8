// The gamepad in use among those plugged in. Needs GLFW to be running.
#pragma once

#include "engine/platform/device_events.h"

#include <span>
#include <string>

namespace plumbline::platform {

/// Which pad to read: the one at `index` if it still is the one called `guid`, else where that one is
/// now, else the first; -1 without any. `guids`: by index, empty where there is no gamepad.
int pad_to_read(std::span<const std::string> guids, int index, const std::string& guid);

class Gamepads {
public:
    /// Gives GLFW the mapping lines of SDL_GAMECONTROLLERCONFIG and of gamecontrollerdb.txt in the
    /// user's data folder, after our own check; logs how many were taken and what is wrong with
    /// the others.
    static void load_mappings();

    /// The pad that was used last if it is still there, else the first; a pad that comes back under
    /// another index is known by its GUID.
    PadReading read();

private:
    int find_pad();

    int index_{-1};
    std::string guid_;
    bool was_present_{false};
};

}  // namespace plumbline::platform
