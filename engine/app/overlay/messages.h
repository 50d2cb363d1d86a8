// Lines for the person that fade after some seconds. Longer ones stay longer.
#pragma once

#include "engine/app/ui/hud_layout.h"

#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::app {

class Messages {
public:
    /// Shown from the next frame on. A line that is still up is renewed, not stacked.
    void say(std::string line);
    /// The same, in place of a line that begins the same as far as the first digit: "light: 80 %".
    void say_latest(std::string line);

    /// Once a frame: what is shown now, oldest first; forgets what has faded.
    std::vector<ui::HudLine> lines(double now_s, bool reduce_motion);

private:
    struct Message {
        std::string text;
        double until_s{0};  ///< 0: counts from the next frame on
    };
    std::deque<Message> messages_;
};

}  // namespace plumbline::app
