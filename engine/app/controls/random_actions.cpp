#include "engine/app/controls/action_tape.h"

namespace plumbline::app {

Actions RandomActions::next() {
    for (std::uint8_t& presses : now_.pressed) presses = 0;
    now_.look_yaw_rad = random_.below(4) == 0 ? random_.uniform(-0.2F, 0.2F) : 0.0F;
    now_.look_pitch_rad = random_.below(4) == 0 ? random_.uniform(-0.1F, 0.1F) : 0.0F;
    for (int change = 0; change < 2; ++change) {
        const std::size_t index = random_.below(static_cast<std::uint32_t>(kActionCount));
        const bool down = !now_.held[index];
        now_.held[index] = down;
        now_.amount[index] = down ? 1.0F : 0.0F;
        if (down) now_.pressed[index] = 1;
    }
    return now_;
}

}  // namespace plumbline::app
