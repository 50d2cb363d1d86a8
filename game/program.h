// What both programs do around their commands.
#pragma once

namespace plumbline::game {

/// Runs `commands(argc, argv)`, which gives an exit code. Memory that is refused, and output that
/// could not be written, become one line and an exit code; a closed pipe is no signal.
int run_program(int (*commands)(int, char**), int argc, char** argv);

}  // namespace plumbline::game
