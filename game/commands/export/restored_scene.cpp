#include "game/commands/export/restored_scene.h"

#include "engine/core/io/files.h"
#include "engine/effects/saved_game.h"
#include "engine/study/scene_start.h"
#include "game/rules/rules.h"

namespace plumbline::game {

Result<std::unique_ptr<RestoredScene>> restored_scene(const std::filesystem::path& scene,
                                                      const std::filesystem::path& saved_game) {
    const Result<DataFolders> folders = find_data_folders();
    if (!folders) return folders.error();
    Result<effects::SavedGame> saved = effects::SavedGame{};
    if (!saved_game.empty()) saved = effects::read_saved_game(saved_game);
    if (!saved) return saved.error();
    Result<scene::OpenedScene> opened = study::open_for_study(scene);
    if (!opened) return opened.error();
    auto restored = std::make_unique<RestoredScene>(folders->assets);
    restored->opened = std::move(*opened);
    if (!saved_game.empty()) restored->opened.description.accuracy.fidelity = saved->fidelity;
    Result<std::unique_ptr<scene::Simulation>> built = restored->opened.build(restored->library);
    if (!built) return built.error();
    restored->simulation = std::move(*built);
    scene::Simulation& simulation = *restored->simulation;
    restored->game = std::make_unique<scene::NoGame>(simulation.description().camera);
    if (!saved_game.empty() && saved->game != restored->game->kind())
        restored->game = std::make_unique<PlaygroundGame>(simulation, folders->assets);
    restored->effects =
        std::make_unique<effects::EffectRuntime>(simulation, effects::ServedDomains{});
    if (saved_game.empty()) return restored;
    const Result<Done> there = effects::put_back(*saved,
                                                 saved_game,
                                                 {.opened = restored->opened,
                                                  .simulation = simulation,
                                                  .effects = *restored->effects,
                                                  .game = *restored->game});
    if (!there) return there.error();
    return restored;
}

}  // namespace plumbline::game
