// What playing a scene is told on the command line, and by the scenes before it; and how it ends.
#pragma once

#include "engine/app/controls/live_bindings.h"
#include "engine/app/session.h"
#include "engine/app/settings/live_config.h"
#include "engine/app/stepper.h"
#include "engine/render/renderer.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace plumbline::app {

struct PlayDef {
    /// Opens what is chosen in the menu or dropped on the window.
    std::function<Result<std::unique_ptr<Session>>(const std::filesystem::path&)> open_scene;
    /// When the first frame of a scene is on the screen.
    std::function<void(const Session&, const render::GlInfo&)> after_first_frame{};
    std::filesystem::path shader_folder;
    std::filesystem::path user_data_folder;  ///< images, recordings, hints that were followed
    std::filesystem::path thumbnails;        ///< folder of images of scenes
    bool start_page{false};                  ///< the menu first
    bool unattended{false};                  ///< nobody to give hints to
    std::string first_message;               ///< shown at once; empty: nothing
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

/// Makes `def` that of the next scene: the session's time runs on, the report tells of both, a replay was
/// of the scene before. A recording is of one scene, the first in which time went on.
void continue_with_next(PlayDef& def, const PlayEnd& end);

/// What a scene is played with. All of it outlives the frames.
struct Play {
    Session& session;
    LiveBindings& bindings;
    LiveConfig& config;
    const PlayDef& def;
};

/// For names of files: "garden".
inline std::string scene_name(const Session& session) {
    return session.description().file.stem().string();
}

/// Of what is kept for the person; empty where there is no place for anything.
inline std::filesystem::path in_user_data(const PlayDef& def, const char* name) {
    return def.user_data_folder.empty() ? std::filesystem::path{} : def.user_data_folder / name;
}

/// A model by itself is turned, nobody plays.
inline bool looks_at_model(const Session& session) {
    return session.description().shows_model && session.game->frees_pointer();
}

}  // namespace plumbline::app
