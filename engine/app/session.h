// A scene being run: what is loaded once, and what reset and reload build anew.
#pragma once

#include "engine/core/diagnostics.h"
#include "engine/core/files.h"
#include "engine/effects/advance.h"
#include "engine/scene/game.h"
#include "engine/scene/scene_file.h"
#include "engine/scene/simulation.h"
#include "engine/study/gallery/hard_case_judge.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace plumbline::app {

/// Makes the rules of a freshly built simulation.
using GameFactory = std::function<std::unique_ptr<scene::Game>(scene::Simulation&)>;

struct SessionDef {
    std::filesystem::path scene;
    DataFolders folders;
    scene::SimulationOverrides overrides{};
    effects::ServedDomains served{};
    GameFactory make_game;
};

/// Owns the loaded assets and the running world. Members are destroyed in reverse: effects and game
/// before the simulation they know.
class Session {
public:
    /// Loads and builds. Faults of the scene file are logged; errors refuse the scene (exit code 4).
    static Result<std::unique_ptr<Session>> open(const SessionDef& def);

    /// The same description from its start. Assets stay loaded.
    Result<Done> reset();
    /// Reads the file again. On an error the running scene stays.
    Result<Done> reload();

    assets::AssetLibrary library;
    scene::SurfaceTable surfaces;
    scene::SceneDescription description;
    std::unique_ptr<scene::Simulation> simulation;
    std::unique_ptr<scene::Game> game;
    std::unique_ptr<effects::EffectRuntime> effects;
    std::unique_ptr<study::HardCaseJudge> judge;  ///< null for a scene without [hard_case]

private:
    explicit Session(SessionDef def) : def_(std::move(def)) {}
    Result<Done> build();

    SessionDef def_;
};

}  // namespace plumbline::app
