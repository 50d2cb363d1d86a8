// The settings in force, and the file that the settings pages write.
#pragma once

#include "engine/app/app_config.h"
#include "engine/core/result.h"

#include <filesystem>
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
    const Diagnostics& faults() const { return faults_; }

    /// Puts the values in force and writes them at once. The error says why they are not stored;
    /// they hold for this session all the same.
    Result<Done> change(const AppConfig& wanted);
    /// The command line's: in force until change() brings another, and never stored.
    void put_level(PictureLevel level);

private:
    std::filesystem::path user_folder_;
    Diagnostics faults_;
    AppConfig below_;
    AppConfig current_;
    std::optional<PictureLevel> stored_level_;  ///< while the command line's is in force
};

/// Writes a file of the user's settings folder, made where it is missing. The error is one line for
/// the person: what they changed lasts for this session only, and why.
Result<Done> write_user_setting(const std::filesystem::path& user_folder,
                                std::string_view name,
                                std::string_view text);

}  // namespace plumbline::app
