// Settings of the program itself: config/app.toml as shipped, then the user's own app.toml.
#pragma once

#include "engine/core/diagnostics.h"

#include <filesystem>

namespace plumbline::app {

struct AppConfig {
    int width{1280};  ///< [window]
    int height{720};
    bool vsync{true};
    int max_fps{240};  ///< when vsync does not hold the loop back
    bool pause_on_focus_loss{false};
    int max_steps_per_frame{4};  ///< [time] time beyond is lost, and shown
    float ui_scale{0.0F};        ///< [hud] 0: from the screen
    bool hints{true};
    float master_gain{1.0F};  ///< [sound] 0…1
    int voices{32};
};

/// Missing files mean defaults; bad entries cost only themselves.
AppConfig load_app_config(const std::filesystem::path& shipped_folder,
                          const std::filesystem::path& user_folder,
                          Diagnostics& faults);

}  // namespace plumbline::app
