#include "game/commands/study/saved_start.h"

#include "engine/core/io/files.h"
#include "engine/effects/saved_game.h"
#include "game/rules/rules.h"

#include <memory>

namespace plumbline::game {

Result<study::SceneStart> saved_start(const std::filesystem::path& saved_game,
                                      const std::filesystem::path& scene) {
    const Result<DataFolders> folders = find_data_folders();
    if (!folders) return folders.error();
    const Result<effects::SavedGame> saved = effects::read_saved_game(saved_game);
    if (!saved) return saved.error();
    Result<scene::OpenedScene> opened = study::open_for_study(scene);
    if (!opened) return opened.error();
    opened->description.accuracy.fidelity = saved->fidelity;
    assets::AssetLibrary library(folders->assets);
    const Result<std::unique_ptr<scene::Simulation>> simulation = opened->build(library);
    if (!simulation) return simulation.error();
    std::unique_ptr<scene::Game> game =
        std::make_unique<scene::NoGame>((*simulation)->description().camera);
    if (saved->game != game->kind())
        game = std::make_unique<PlaygroundGame>(**simulation, folders->assets);
    effects::EffectRuntime effects(**simulation, {});
    const Result<Done> there = effects::put_back(
        *saved,
        saved_game,
        {.opened = *opened, .simulation = **simulation, .effects = effects, .game = *game});
    if (!there) return there.error();
    return study::scene_start_of(**simulation);
}

}  // namespace plumbline::game
