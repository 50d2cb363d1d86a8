#include "engine/app/live_config.h"

#include "engine/core/files.h"

#include <fmt/format.h>

#include <utility>

namespace plumbline::app {
namespace {
constexpr std::string_view kWrittenFile = "app.ui.toml";
}

LiveConfig::LiveConfig(const std::filesystem::path& shipped_folder,
                       std::filesystem::path user_folder)
    : user_folder_(std::move(user_folder)) {
    std::vector<std::filesystem::path> files;
    if (!shipped_folder.empty()) files.push_back(shipped_folder / "app.toml");
    if (!user_folder_.empty()) files.push_back(user_folder_ / "app.toml");
    Diagnostics said_below;
    below_ = load_app_config(files, said_below);
    if (!user_folder_.empty()) files.push_back(user_folder_ / kWrittenFile);
    current_ = load_app_config(files, faults_);
}

Result<Done> LiveConfig::change(const AppConfig& wanted) {
    if (wanted == current_) return Done{};
    if (wanted.picture_level != current_.picture_level) stored_level_.reset();
    current_ = wanted;
    AppConfig stored = wanted;
    stored.picture_level = stored_level_.value_or(wanted.picture_level);
    return write_user_setting(user_folder_, kWrittenFile, ui_config_text(below_, stored));
}

void LiveConfig::put_level(PictureLevel level) {
    stored_level_ = current_.picture_level;
    current_.picture_level = level;
}

Result<Done> write_user_setting(const std::filesystem::path& user_folder,
                                std::string_view name,
                                std::string_view text) {
    const auto not_stored = [](std::string_view why) {
        return Error{.message = fmt::format("changes last for this session: {}", why)};
    };
    if (user_folder.empty()) return not_stored("there is no folder for your settings");
    const Result<Done> written = write_file_and_folder(user_folder / name, text);
    if (!written) return not_stored(written.error().message);
    return Done{};
}

}  // namespace plumbline::app
