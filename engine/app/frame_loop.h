// The frame: what happens, in order, while a window is open. Read frame_loop.cpp first.
#pragma once

#include "engine/app/frame/play_def.h"
#include "engine/platform/window.h"

namespace plumbline::app {

/// Plays the session in the window until it closes, another scene was opened, the replay or the time
/// ends, or Ctrl-C.
PlayEnd run(platform::Window& window, const Play& play);

}  // namespace plumbline::app
