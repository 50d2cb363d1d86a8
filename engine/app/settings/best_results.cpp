#include "engine/app/settings/best_results.h"

#include "engine/core/io/files.h"
#include "engine/core/log.h"

#include <fmt/format.h>

#include <cmath>
#include <sstream>
#include <utility>

namespace plumbline::app {
namespace {

constexpr std::size_t kMostBytes = 1 << 20;

/// A line for each scene: its name and the seconds. None where a line is anything else.
std::optional<std::map<std::string, double>> times_in(const std::string& text) {
    std::map<std::string, double> times;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string scene;
        double time_s = 0;
        if (!(words >> scene >> time_s) || !std::isfinite(time_s) || time_s < 0) return {};
        times[scene] = time_s;
    }
    return times;
}

}  // namespace

BestResults::BestResults(std::filesystem::path file) : file_(std::move(file)) {
    std::error_code ignored;
    if (file_.empty() || !std::filesystem::exists(file_, ignored)) return;
    const Result<std::string> text = read_file(file_, kMostBytes);
    auto times = text ? times_in(*text) : std::nullopt;
    if (times) {
        best_s_ = std::move(*times);
        return;
    }
    log_warning(
        "{}: not readable as best results (lines \"NAME SECONDS\"); none are kept until it is "
        "moved away",
        file_.string());
    file_.clear();
}

std::optional<double> BestResults::of(const std::string& scene) const {
    const auto found = best_s_.find(scene);
    if (found == best_s_.end()) return {};
    return found->second;
}

void BestResults::note(const std::string& scene, double time_s) {
    // Its file has a word for each name.
    if (scene.empty() || scene.find_first_of(" \t\n\r") != std::string::npos) return;
    const auto before = of(scene);
    if (before && *before <= time_s) return;
    best_s_[scene] = time_s;
    store();
}

void BestResults::store() const {
    if (file_.empty()) return;
    std::string text;
    for (const auto& [scene, time_s] : best_s_) text += fmt::format("{} {:.3f}\n", scene, time_s);
    const Result<Done> written = write_file_and_folder(file_, text);
    if (!written) log_warning("{}", written.error().message);
}

}  // namespace plumbline::app
