// What both programs understand besides their commands: --version, --data, and the hidden command
// help-data that prints the manual page and the shells' completion.
#pragma once

#include <string>

namespace CLI {  // NOLINT(readability-identifier-naming): the library has it
class App;
}

namespace plumbline::game {

/// "plumbline 0.1.0 (float32)".
std::string version_text();

/// Added last: help-data describes what `app` holds when it is parsed. --data is said to the program
/// and to the workers that it starts by setting PLUMBLINE_DATA.
void add_program_words(CLI::App& app);

}  // namespace plumbline::game
