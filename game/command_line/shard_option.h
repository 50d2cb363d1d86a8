// --shard I/N and --merge DIR…, which `study` and `stability` share.
#pragma once

#include "engine/core/result.h"
#include "engine/study/findings/findings.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): the library has it
class App;
class Option;
}  // namespace CLI

namespace plumbline::game {

/// Adds both to a command that has --out, which both need.
void add_shard_options(CLI::App& command,
                       CLI::Option& out,
                       std::optional<study::Shard>& shard,
                       std::vector<std::filesystem::path>& merge);

/// The file `name` of every folder. Refused: one that cannot be read.
Result<std::vector<std::string>> read_shards(const std::vector<std::filesystem::path>& folders,
                                             const std::string& name);

}  // namespace plumbline::game
