#include "engine/study/played_scene.h"

#include "engine/core/io/files.h"
#include "engine/effects/advance.h"
#include "engine/study/gallery/case_events.h"

namespace plumbline::study {

Result<scene::OpenedScene> open_for_study(const std::filesystem::path& file,
                                          const scene::SimulationOverrides& overrides) {
    const Result<DataFolders> folders = find_data_folders();
    if (!folders) return folders.error();
    Diagnostics faults;
    return scene::open_scene(file, {.folders = *folders, .overrides = overrides}, faults);
}

PlayedScene::PlayedScene(std::unique_ptr<scene::Simulation> simulation)
    : simulation_(std::move(simulation)), game_(simulation_->description().camera) {
    play_case_events(*simulation_);
}

std::set<physics::BodyId> rope_pieces(const scene::Simulation& simulation) {
    std::set<physics::BodyId> pieces;
    for (const scene::Rope& rope : simulation.ropes())
        pieces.insert(rope.pieces.begin(), rope.pieces.end());
    return pieces;
}

Result<PlayedScene> PlayedScene::create(const scene::OpenedScene& scene,
                                        assets::AssetLibrary& library) {
    Result<std::unique_ptr<scene::Simulation>> built = scene.build(library);
    if (!built) return built.error();
    return PlayedScene(std::move(*built));
}

void PlayedScene::start(const effects::ServedDomains& served) {
    effects_ = std::make_unique<effects::EffectRuntime>(*simulation_, served);
}

void PlayedScene::step() {
    effects::advance(*simulation_, *effects_, game_, {});
}

}  // namespace plumbline::study
