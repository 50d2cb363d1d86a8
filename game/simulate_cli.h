// The command-line words of `simulate`, the same in plumbline and plumbline-f64.
#pragma once

#include "game/simulate_command.h"

#include <string>

namespace CLI {
class App;
}

namespace plumbline::game {

/// "plumbline 0.1.0 (float32)".
std::string version_text();

/// Adds the subcommand; parsing fills `options`, which must live as long as `app`.
CLI::App* add_simulate(CLI::App& app, SimulateOptions& options);

}  // namespace plumbline::game
