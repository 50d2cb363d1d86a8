// A scene as every job of the study steps it: with its own events and effects, and no game.
#pragma once

#include "engine/effects/effect_runtime.h"
#include "engine/scene/game.h"
#include "engine/scene/open_scene.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <set>

namespace plumbline::study {

/// Opens a scene file with the installed data. Refused: what scene::open_scene() refuses.
Result<scene::OpenedScene> open_for_study(const std::filesystem::path& file,
                                          const scene::SimulationOverrides& overrides = {});

/// Of all ropes. Their number depends on the fidelity of ropes, so no two runs are compared by them.
std::set<physics::BodyId> rope_pieces(const scene::Simulation& simulation);

class PlayedScene {
public:
    /// The simulation at its start; its effects come with start(). `library` must outlive it. Refused:
    /// what OpenedScene::build() refuses.
    static Result<PlayedScene> create(const scene::OpenedScene& scene,
                                      assets::AssetLibrary& library);

    /// Makes the effects. Whatever changes the first state comes before.
    void start(const effects::ServedDomains& served = {});
    /// One step, with its effects. Only after start().
    void step();

    scene::Simulation& simulation() const { return *simulation_; }
    effects::EffectRuntime& effects() const { return *effects_; }
    scene::NoGame& game() { return game_; }

private:
    explicit PlayedScene(std::unique_ptr<scene::Simulation> simulation);

    std::unique_ptr<scene::Simulation> simulation_;
    scene::NoGame game_;
    std::unique_ptr<effects::EffectRuntime> effects_;
};

}  // namespace plumbline::study
