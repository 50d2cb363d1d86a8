// The settings in force: read from their layers at the start and again whenever a file is saved; and
// the file that the settings pages write.
#pragma once

#include "engine/app/settings/app_config.h"
#include "engine/core/result.h"
#include "engine/platform/file_watch.h"

#include <filesystem>
#include <memory>
#include <optional>

namespace plumbline::app {

class LiveConfig {
public:
    /// Reads the layers. `shipped_folder` empty: built-in values only; `user_folder` empty: no files
    /// of a user's, and nowhere to write.
    LiveConfig(const std::filesystem::path& shipped_folder, std::filesystem::path user_folder);

    const AppConfig& current() const { return current_; }
    /// What holds without the settings pages: where "reset" leads back to.
    const AppConfig& below() const { return below_; }
    const Diagnostics& faults() const { return faults_; }  ///< of the last reading

    /// True when files changed and say something else now. While one of them cannot be parsed, or is
    /// gone, what was in force stays; a fault is in faults().
    bool reload_if_changed(double now_s);

    /// Puts the values in force and writes them at once. The error says why they are not stored;
    /// they hold for this session all the same.
    Result<Done> change(const AppConfig& wanted);
    /// The command line's: in force until change() brings another, and never stored.
    void put_level(QualityLevel level);

private:
    void load();

    std::vector<std::filesystem::path> by_hand_;  ///< the layers below the written one
    std::filesystem::path user_folder_;
    Diagnostics faults_;
    AppConfig below_;
    AppConfig current_;
    std::optional<QualityLevel> stored_level_;  ///< while the command line's is in force
    std::size_t files_there_{0};                ///< when they were read last
    std::unique_ptr<platform::FileWatch> watch_;
};

/// Writes a file of the user's settings folder, made where it is missing. The error is one line for
/// the person: what they changed lasts for this session only, and why.
Result<Done> write_user_setting(const std::filesystem::path& user_folder,
                                std::string_view name,
                                std::string_view text);

}  // namespace plumbline::app
