#include "engine/app/settings/live_config.h"

#include "engine/core/io/files.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace plumbline::app {
namespace {

constexpr std::string_view kSettingsFile = "app.ui.toml";

bool is_there(const std::filesystem::path& file) {
    std::error_code ignored;
    return std::filesystem::exists(file, ignored);
}

std::string text_of(const Diagnostics& faults) {
    std::string text;
    for (const Diagnostic& fault : faults.list()) text += to_string(fault) + '\n';
    return text;
}

}  // namespace

LiveConfig::LiveConfig(const std::filesystem::path& shipped_folder,
                       std::filesystem::path user_folder)
    : user_folder_(std::move(user_folder)) {
    if (!shipped_folder.empty()) by_hand_.push_back(shipped_folder / "app.toml");
    if (!user_folder_.empty()) by_hand_.push_back(user_folder_ / "app.toml");
    load();
    std::vector<std::filesystem::path> watched = by_hand_;
    if (!user_folder_.empty()) watched.push_back(user_folder_ / kSettingsFile);
    watch_ = std::make_unique<platform::FileWatch>(std::move(watched));
}

void LiveConfig::load() {
    faults_ = {};
    std::vector<std::filesystem::path> files = by_hand_;
    Diagnostics said_already;
    const AppConfig below = load_app_config(files, said_already);
    if (!user_folder_.empty()) files.push_back(user_folder_ / kSettingsFile);
    const AppConfig read = load_app_config(files, faults_);
    const auto there = static_cast<std::size_t>(std::ranges::count_if(files, is_there));
    // A file that is half written, broken or gone for a moment must not throw the person back to
    // the defaults: what was in force stays until a whole file is there again.
    if (files_there_ > 0 && (faults_.has_errors() || there < files_there_)) return;
    files_there_ = there;
    below_ = below;
    const QualityLevel put = current_.quality_level;
    current_ = read;
    if (!stored_level_) return;
    stored_level_ = read.quality_level;
    current_.quality_level = put;
}

bool LiveConfig::reload_if_changed(double now_s) {
    if (watch_->take_changed(now_s).empty()) return false;
    const AppConfig before = current_;
    const std::string said_before = text_of(faults_);
    load();
    return current_ != before || text_of(faults_) != said_before;
}

Result<Done> LiveConfig::change(const AppConfig& wanted) {
    if (wanted == current_) return Done{};
    if (wanted.quality_level != current_.quality_level) stored_level_.reset();
    current_ = wanted;
    AppConfig stored = wanted;
    stored.quality_level = stored_level_.value_or(wanted.quality_level);
    return write_user_setting(user_folder_, kSettingsFile, ui_config_text(below_, stored));
}

void LiveConfig::put_level(QualityLevel level) {
    stored_level_ = current_.quality_level;
    current_.quality_level = level;
}

Result<Done> write_user_setting(const std::filesystem::path& user_folder,
                                std::string_view name,
                                std::string_view text) {
    const auto not_stored = [](std::string_view why) {
        return Error{.message = fmt::format(
                         "settings cannot be saved and last for this session only: {}", why)};
    };
    if (user_folder.empty())
        return not_stored("no user settings folder (XDG_CONFIG_HOME and HOME are not set)");
    const Result<Done> written = write_file_and_folder(user_folder / name, text);
    if (!written) return not_stored(written.error().message);
    return Done{};
}

}  // namespace plumbline::app
