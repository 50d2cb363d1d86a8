// The command-line words of `simulate`, the same in plumbline and plumbline-f64.
#pragma once

#include "game/commands/simulate_command.h"

#include <optional>
#include <string>

namespace CLI {  // NOLINT(readability-identifier-naming): the library has it
class App;
}

namespace plumbline::game {

/// The solver of that name; throws a CLI::ValidationError that names the nearest one.
void take_solver(const std::string& name, std::optional<physics::Solver>& solver);

/// Adds the subcommand; parsing fills `options`, which must live as long as `app`.
CLI::App* add_simulate(CLI::App& app, SimulateOptions& options);

}  // namespace plumbline::game
