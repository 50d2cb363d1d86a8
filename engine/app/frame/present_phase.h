// The end of a frame: what it cost, how long until the next one, and whether there is one.
#pragma once

#include "engine/app/frame/frame_state.h"
#include "engine/app/frame/view_phase.h"
#include "engine/platform/window.h"

#include <optional>
#include <string>

namespace plumbline::app {

class PresentPhase {
public:
    /// State and window must outlive it.
    PresentPhase(FrameState& state, platform::Window& window);

    /// Shows the image. Waits where frames come too fast.
    void present(double frame_start_s, ViewPhase& view);
    void end_with(ExitCode code) {
        ends_ = true;
        code_ = code;
    }
    /// Somebody asked for it, its time is over, or it cannot go on.
    bool ended() const;
    ExitCode code() const { return code_; }  ///< not good: why it cannot go on
    double seconds() const { return window_.now_s() - start_s_; }

private:
    void fail(ExitCode code, const std::string& why);

    FrameState& state_;
    platform::Window& window_;
    double start_s_;
    std::optional<bool> vsync_;  ///< as the window has it
    bool ends_{false};
    ExitCode code_{ExitCode::Good};
};

}  // namespace plumbline::app
