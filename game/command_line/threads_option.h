// The words of --threads, which `simulate` and `study` share.
#pragma once

#include <string>

namespace plumbline::game {

/// A number of threads, or "auto" as scene::kAutoThreads; throws a CLI::ValidationError.
int threads_from(const std::string& text);

}  // namespace plumbline::game
