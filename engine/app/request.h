// What a person asks of the program: by a key, in the menu, in a panel, by a file that was saved. Plain
// data: whoever shows a choice adds a request, and frame/apply_requests.cpp does all of them before
// the steps of a frame.
#pragma once

#include "engine/app/settings/app_config.h"
#include "engine/app/world_request.h"
#include "engine/input/bindings.h"

#include <cstdint>
#include <filesystem>
#include <variant>
#include <vector>

namespace plumbline::app {

struct ChangeConfig {
    AppConfig wanted;
};
struct ChangeBindings {
    input::Bindings wanted;
};
struct OpenScene {
    std::filesystem::path file;
};
/// The scene's files, as after a save.
struct ReloadScene {};
struct ReloadShaders {};
struct SaveGame {
    int slot{0};  ///< 0: the one used last
};
struct LoadGame {
    int slot{0};
};
/// The scene as it is now, as a scene of its own.
struct SaveLevel {};
struct SaveImage {};
struct SaveRecording {};
struct StartOrEndFilm {};
struct ToggleFullscreen {};
/// A copy of the scene with the accuracy that runs.
struct AdoptAccuracy {};

enum class GhostFrom : std::uint8_t { Here, Start };
struct StartGhost {
    study::Setting setting;
    GhostFrom from{GhostFrom::Here};
};
struct StopGhost {};
/// Of the scene that runs, from its present state.
struct StartStudy {};
struct StopStudy {};
/// Of the levels of the image, from where the game looks.
struct StartPictureStudy {};
struct StopPictureStudy {};
struct SetImageLevel {
    QualityLevel level{};
};
struct ShowHintsAgain {};
struct Quit {};

using Request = std::variant<WorldRequest,
                             ChangeConfig,
                             ChangeBindings,
                             OpenScene,
                             ReloadScene,
                             ReloadShaders,
                             SaveGame,
                             LoadGame,
                             SaveLevel,
                             SaveImage,
                             SaveRecording,
                             StartOrEndFilm,
                             ToggleFullscreen,
                             AdoptAccuracy,
                             StartGhost,
                             StopGhost,
                             StartStudy,
                             StopStudy,
                             StartPictureStudy,
                             StopPictureStudy,
                             SetImageLevel,
                             ShowHintsAgain,
                             Quit>;
using Requests = std::vector<Request>;

}  // namespace plumbline::app
