#include "game/command_line/shard_option.h"

#include "engine/core/io/files.h"
#include "engine/study/workers/shard.h"

#include <CLI/CLI.hpp>

namespace plumbline::game {
namespace {

constexpr std::size_t kTableBytes = std::size_t{256} << 20U;

}  // namespace

void add_shard_options(CLI::App& command,
                       CLI::Option& out,
                       std::optional<study::Shard>& shard,
                       std::vector<std::filesystem::path>& merge) {
    CLI::Option* part = command.add_option_function<std::string>(
        "--shard",
        [&shard](const std::string& text) { shard = study::shard_from(text); },
        "Run only part I of N (I/N); combine the parts with --merge");
    part->check([](const std::string& text) {
        return study::shard_from(text)
                   ? std::string()
                   : "expected I/N, for example 2/4 for the second of four parts";
    });
    part->needs(&out);
    command
        .add_option("--merge",
                    merge,
                    "Combine the result folders of all parts into one report; runs nothing")
        ->excludes(part)
        ->needs(&out);
}

Result<std::vector<std::string>> read_shards(const std::vector<std::filesystem::path>& folders,
                                             const std::string& name) {
    std::vector<std::string> texts;
    for (const std::filesystem::path& folder : folders) {
        Result<std::string> text = read_file(folder / name, kTableBytes);
        if (!text) return text.error();
        texts.push_back(std::move(*text));
    }
    return texts;
}

}  // namespace plumbline::game
