// What the program returns to the shell. A contract: scripts and CI read it.
#pragma once

namespace plumbline {

enum class ExitCode {
    Good = 0,
    RunFailed = 1,
    BadUsage = 2,   ///< bad option or config
    NoDisplay = 3,  ///< no display, or no usable OpenGL
    Refused = 4,    ///< scene or asset refused
    Differs = 5,    ///< a hash or expectation differs
    OutOfMemory = 6,
    Interrupted = 130
};

}  // namespace plumbline
