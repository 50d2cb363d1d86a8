// The frame: what happens, in order, while a window is open. Read frame_loop.cpp first.
#pragma once

#include "engine/app/controls/live_bindings.h"
#include "engine/app/session.h"
#include "engine/app/settings/live_config.h"
#include "engine/app/stepper.h"
#include "engine/platform/window.h"
#include "engine/render/renderer.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace plumbline::app {

/// What a session is told on the command line, and by the scenes before in it.
struct PlayDef {
    /// Opens what is chosen in the menu or dropped on the window.
    std::function<Result<std::unique_ptr<Session>>(const std::filesystem::path&)> open_scene;
    /// When the first frame of a scene is on the screen.
    std::function<void(const Session&, const render::GlInfo&)> after_first_frame{};
    std::filesystem::path shader_folder;
    std::filesystem::path user_data_folder;  ///< images, recordings, what was said already
    std::filesystem::path thumbnails;        ///< folder of images of scenes
    bool start_page{false};                  ///< the menu first
    bool unattended{false};                  ///< nobody to say hints to
    std::string first_message;               ///< said at once; empty: nothing
    std::filesystem::path camera_path;       ///< played at once; empty: none
    bool sound{true};
    std::string audio_device;
    std::optional<double> seconds{};           ///< ends after so much wall time
    std::filesystem::path record;              ///< recording, written as it grows
    std::filesystem::path report;              ///< report written at the end
    std::optional<std::string> expect_hash{};  ///< of the last scene's state at the end
    StepperDef steps{};
    std::optional<double> chosen_s{};  ///< by wall_s(), when another scene was
    std::string report_before;         ///< of the scene before; empty: there was none
};

/// How the time with a scene ended.
struct PlayEnd {
    ExitCode code{ExitCode::Good};
    std::unique_ptr<Session> next{};  ///< another scene was chosen, and is open; null: the end
    double chosen_s{0};               ///< when, by wall_s()
    double seconds{0};                ///< with this scene
    std::uint64_t steps{0};
    std::string report;  ///< empty where none was asked for
};

/// What holds for the next scene of the session: its time runs on, the report tells of both, a
/// replay was of the scene before. A recording is of one scene, the first in which time went on.
void go_on(PlayDef& def, const PlayEnd& end);

/// Runs the session in the window until it closes, another scene was opened, the replay or the time
/// ends, or Ctrl-C.
PlayEnd run(platform::Window& window,
            Session& session,
            LiveBindings& bindings,
            LiveConfig& config,
            const PlayDef& def);

}  // namespace plumbline::app
