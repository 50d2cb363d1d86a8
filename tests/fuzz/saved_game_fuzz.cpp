// Saved games: docs/SAVED-GAMES.md. The bytes are what stands behind the checksum.
#include "engine/core/io/saved_file.h"
#include "engine/core/log.h"
#include "engine/effects/advance.h"
#include "engine/effects/saved_game.h"
#include "engine/scene/extract.h"
#include "engine/scene/open_scene.h"
#include "game/rules/rules.h"
#include "tests/fuzz/fuzz_target.h"

#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <memory>

namespace plumbline::fuzz {
namespace {

namespace fs = std::filesystem;

const fs::path kRepository = PL_SOURCE_DIR;

const scene::OpenedScene& workshop() {
    static const scene::OpenedScene opened = [] {
        Diagnostics faults;
        Result<scene::OpenedScene> read =
            scene::open_scene(kRepository / "tests/fuzz/workshop.toml",
                              {.folders = {.assets = kRepository / "assets",
                                           .shaders = kRepository / "shaders",
                                           .config = kRepository / "config"}},
                              faults);
        if (!read) {
            for (const Diagnostic& fault : faults.list()) log_error("{}", to_string(fault));
            std::abort();
        }
        return std::move(*read);
    }();
    return opened;
}

/// The scene with a person in it, or as `simulate` runs it.
struct Sitting {
    std::unique_ptr<scene::Simulation> simulation;
    std::unique_ptr<effects::EffectRuntime> effects;
    std::unique_ptr<scene::Game> game;

    Sitting(std::string_view kind, const scene::OpenedScene& opened) {
        static assets::AssetLibrary library;
        auto built = opened.build(library);
        if (!built) std::abort();
        simulation = std::move(*built);
        effects = std::make_unique<effects::EffectRuntime>(*simulation, effects::ServedDomains{});
        if (kind == scene::NoGame(scene::CameraDescription{}).kind())
            game = std::make_unique<scene::NoGame>(scene::CameraDescription{});
        else
            game = std::make_unique<game::PlaygroundGame>(*simulation, kRepository / "assets");
    }
    void step(const Actions& actions = {}) const {
        effects::advance(*simulation, *effects, *game, actions);
    }
    effects::RunningGame running(const scene::OpenedScene& opened) const {
        return {.opened = opened, .simulation = *simulation, .effects = *effects, .game = *game};
    }
};

Actions press(Action action) {
    Actions actions;
    actions.held[index_of(action)] = true;
    actions.pressed[index_of(action)] = 1;
    actions.amount[index_of(action)] = 1;
    return actions;
}

std::string saved(std::string_view kind, physics::Solver solver, int steps) {
    scene::OpenedScene opened = workshop();
    opened.description.accuracy.solver = solver;
    const Sitting sitting(kind, opened);
    for (int i = 0; i < steps; ++i) {
        // Things are thrown, taken and carried; more fall asleep.
        const bool throws = i % 40 == 10;
        const bool grabs = i % 40 > 15;
        sitting.step(throws ? press(Action::Throw) : grabs ? press(Action::Grab) : Actions{});
    }
    const fs::path file = fs::temp_directory_path() / ("fuzz-" + std::to_string(getpid()));
    if (!effects::save_game(file, sitting.running(opened), static_cast<std::uint64_t>(steps)))
        std::abort();
    std::ifstream stream(file, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    fs::remove(file);
    return std::string(*unshelled(bytes, file));
}

}  // namespace

std::vector<std::string> seeds() {
    const std::string_view playground = "the playground";
    std::vector<std::string> files;
    for (const physics::Solver solver : {physics::Solver::SmallStep, physics::Solver::BulletSi}) {
        files.push_back(saved("no game", solver, 20));
        files.push_back(saved(playground, solver, 110));
        files.push_back(saved(playground, solver, 400));
    }
    return files;
}

}  // namespace plumbline::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace plumbline;
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes as libFuzzer gives them
    const std::string_view content(reinterpret_cast<const char*>(data), size);
    const Result<effects::SavedGame> saved =
        effects::saved_game_from(shelled(content), "mutant.save");
    if (!saved) return saved.error().exit_code == ExitCode::Refused ? 0 : 1;
    const fuzz::Sitting sitting(saved->game, fuzz::workshop());
    const Result<Done> there =
        effects::put_back(*saved, "mutant.save", sitting.running(fuzz::workshop()));
    if (!there) return there.error().exit_code == ExitCode::Refused ? 0 : 1;
    fuzz::note_taken();
    for (int i = 0; i < 6; ++i) sitting.step(i == 3 ? fuzz::press(Action::Throw) : Actions{});
    const scene::Simulation& simulation = *sitting.simulation;
    simulation.state_hash();
    return 0;
}
