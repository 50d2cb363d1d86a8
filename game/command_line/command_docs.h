// The manual page and bash's completion, written from the description of the command line that
// parses it: a new option is in both, and neither has one that is gone.
#pragma once

#include <string>

namespace CLI {  // NOLINT(readability-identifier-naming): the library has it
class App;
}

namespace plumbline::game {

/// Section 1, in roff's man macros. `version` stands in its footer, as in "plumbline 0.1.0".
std::string man_page(const CLI::App& app, const std::string& version);

std::string bash_completion(const CLI::App& app);

}  // namespace plumbline::game
