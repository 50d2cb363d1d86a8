// A scene without a window, at its start or where a saved game left it.
#pragma once

#include "engine/effects/effect_runtime.h"
#include "engine/scene/game.h"
#include "engine/scene/open_scene.h"

#include <filesystem>
#include <memory>

namespace plumbline::game {

/// Each part outlives those after it.
struct RestoredScene {
    assets::AssetLibrary library;
    scene::OpenedScene opened;
    std::unique_ptr<scene::Simulation> simulation;
    std::unique_ptr<scene::Game> game;
    std::unique_ptr<effects::EffectRuntime> effects;

    explicit RestoredScene(const std::filesystem::path& assets) : library(assets) {}
};

/// `saved_game` may be empty. Refused (exit code 4): a game that cannot be gone on from, or of another scene.
Result<std::unique_ptr<RestoredScene>> restored_scene(const std::filesystem::path& scene,
                                                      const std::filesystem::path& saved_game);

}  // namespace plumbline::game
