// How a mistake on the command line is answered; the same in both programs.
#pragma once

#include "engine/core/process/exit_code.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library has it
class App;
class ParseError;
}  // namespace CLI

namespace plumbline::game {

/// Prints help or the one-line complaint, naming the nearest option for an unknown word.
ExitCode answer_parse_error(const CLI::App& app, const CLI::ParseError& error);

}  // namespace plumbline::game
