// A scene being run: what is loaded once, and what reset and reload build anew.
#pragma once

#include "engine/app/world_request.h"
#include "engine/core/io/files.h"
#include "engine/core/text/diagnostics.h"
#include "engine/effects/advance.h"
#include "engine/effects/saved_game.h"
#include "engine/scene/game.h"
#include "engine/scene/open_scene.h"
#include "engine/scene/warning_log.h"
#include "engine/study/gallery/hard_case_judge.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace plumbline::app {

/// Makes the rules of a freshly built simulation.
using GameFactory = std::function<std::unique_ptr<scene::Game>(scene::Simulation&)>;

struct SessionDef {
    std::filesystem::path scene;
    DataFolders folders;
    scene::SimulationOverrides overrides{};
    std::optional<double> hour{};  ///< with [time]: at every start, instead of the scene's own
    effects::ServedDomains served{};
    GameFactory make_game;
};

/// Owns the loaded assets and the running world. Members are destroyed in reverse: effects and game
/// before the simulation they know.
class Session {
public:
    /// Loads and builds. Faults of the scene file are logged; errors refuse the scene (exit code 4).
    static Result<std::unique_ptr<Session>> open(const SessionDef& def);

    /// Does what was asked for, between two steps. On an error, and where std::bad_alloc leaves it, the
    /// running scene stays.
    Result<Done> apply(const WorldRequest& request);
    /// Reads all files again; the accuracy is the scene's own again. As apply().
    Result<Done> reload();
    /// Written atomically; `steps`: of the session, for read_saved_game().
    Result<Done> save(const std::filesystem::path& file, std::uint64_t steps);
    /// Builds the scene anew and goes on from a saved game; the steps of its session. As apply().
    Result<std::uint64_t> load(const std::filesystem::path& file);

    /// What the running world was built from.
    const scene::OpenedScene& opened() const { return scene_; }
    /// As the world runs now.
    study::Setting accuracy() const;
    /// Where SetAccuracy or a loaded game chose another accuracy than the scene's: StartAgain keeps it.
    const std::optional<study::Setting>& chosen_accuracy() const { return chosen_accuracy_; }
    /// Another number for each world that was built: ids of the one before mean nothing in it.
    std::uint64_t generation() const { return generation_; }

    /// Starts decoding what the first frame needs, on worker threads.
    void prefetch_images();
    /// Starts decoding what bodies may sound like when they touch, on a thread.
    void prefetch_sounds();
    const scene::SceneDescription& description() const { return scene_.description; }
    const DataFolders& folders() const { return def_.folders; }
    /// What the running scene was read from; after a failed reload also what that one stumbled over.
    const std::vector<scene::FileStamp>& files() const { return files_; }

    assets::AssetLibrary library;
    std::unique_ptr<scene::Simulation> simulation;
    std::unique_ptr<scene::Game> game;
    std::unique_ptr<effects::EffectRuntime> effects;
    scene::WarningLog warning_log;
    std::unique_ptr<study::HardCaseJudge> judge;  ///< null for a scene without [hard_case]

private:
    explicit Session(SessionDef def) : library(def.folders.assets), def_(std::move(def)) {}
    /// What is done to a new world before it replaces the running one.
    using Prepare = std::function<Result<Done>(const effects::RunningGame&)>;
    /// Replaces the running world, unless the new one is refused. `accuracy`: in place of the scene's.
    Result<Done> build(const scene::OpenedScene& opened,
                       const std::optional<study::Setting>& accuracy,
                       const Prepare& prepare = {});
    Result<Done> set_accuracy(const study::Setting& setting);
    Result<scene::OpenedScene> open_scene();
    void watch(const std::filesystem::path& file, scene::FileUse use);

    SessionDef def_;
    scene::OpenedScene scene_;
    std::vector<scene::FileStamp> files_;
    std::optional<study::Setting> chosen_accuracy_;
    std::uint64_t generation_{0};
};

}  // namespace plumbline::app
