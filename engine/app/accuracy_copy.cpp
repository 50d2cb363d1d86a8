// "Adopt": the panel's setting in a copy of the scene file.
#include "engine/app/accuracy_control.h"
#include "engine/core/files.h"
#include "engine/core/limits.h"

#include <fmt/format.h>

#include <sstream>

namespace plumbline::app {
namespace {

bool begins_table(const std::string& line) {
    return !line.empty() && line.front() == '[';
}

/// The text with other keys under [accuracy]; the table is appended where there is none.
std::string with_accuracy(const std::string& text, const std::string& keys) {
    std::istringstream in(text);
    std::string result;
    bool skipping = false;
    bool written = false;
    for (std::string line; std::getline(in, line);) {
        if (begins_table(line)) {
            skipping = line.starts_with("[accuracy]");
            if (skipping && !written) {
                result += fmt::format("[accuracy]\n{}\n", keys);
                written = true;
            }
        }
        if (!skipping) result += fmt::format("{}\n", line);
    }
    if (!written) result += fmt::format("\n[accuracy]\n{}", keys);
    return result;
}

}  // namespace

Result<std::filesystem::path> write_adopted_copy(const std::filesystem::path& scene,
                                                 const study::Setting& setting) {
    if (scene.extension() != ".toml")
        return Error{.message = fmt::format("{} is no scene file: there is no [accuracy] to write",
                                            scene.filename().string())};
    const Result<std::string> text = read_file(scene, limits::kSceneFileBytes);
    if (!text) return text.error();
    const std::filesystem::path copy =
        scene.parent_path() / fmt::format("{}-adopted.toml", scene.stem().string());
    const Result<Done> written =
        write_file_atomically(copy, with_accuracy(*text, study::accuracy_lines(setting)));
    if (!written) return written.error();
    return copy;
}

}  // namespace plumbline::app
