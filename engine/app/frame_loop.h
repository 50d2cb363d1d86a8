// The frame: what happens, in order, while a window is open. Read frame_loop.cpp first.
#pragma once

#include "engine/app/live_bindings.h"
#include "engine/app/live_config.h"
#include "engine/app/session.h"
#include "engine/app/stepper.h"
#include "engine/platform/window.h"
#include "engine/scene/scene_list.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace plumbline::app {

/// What one sitting is told on the command line.
struct PlayDef {
    std::filesystem::path shader_folder;
    std::filesystem::path user_data_folder;  ///< pictures, recordings, what was said already
    std::filesystem::path thumbnails;        ///< folder of pictures of scenes
    std::vector<scene::ListedScene> scenes;  ///< to choose from in the menu
    bool start_page{false};                  ///< the menu first
    bool unattended{false};                  ///< nobody to say hints to
    std::string first_message;               ///< said at once; empty: nothing
    bool sound{true};
    std::string audio_device;
    std::optional<double> seconds{};           ///< ends after so much wall time
    std::filesystem::path record;              ///< recording written at the end
    std::filesystem::path report;              ///< report written at the end
    std::optional<std::string> expect_hash{};  ///< of the state at the end
    StepperDef steps{};
};

/// How a sitting ended.
struct PlayEnd {
    ExitCode code{ExitCode::Good};
    std::filesystem::path next_scene;  ///< chosen in the menu: to be opened now; empty: none
};

/// Runs the session in the window until it closes, another scene is chosen, the replay or the time
/// ends, or Ctrl-C.
PlayEnd run(platform::Window& window,
            Session& session,
            LiveBindings& bindings,
            LiveConfig& config,
            const PlayDef& def);

}  // namespace plumbline::app
