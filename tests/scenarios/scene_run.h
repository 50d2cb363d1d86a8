// The scene files that ship, loaded and stepped as the programs do it.
#pragma once

#include "engine/effects/advance.h"
#include "engine/effects/saved_game.h"
#include "engine/scene/open_scene.h"
#include "engine/study/gallery/case_events.h"

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <string>

namespace plumbline::test {

inline std::filesystem::path repository() {
    return PL_SOURCE_DIR;
}

struct SceneRun {
    assets::AssetLibrary library;
    std::optional<scene::OpenedScene> opened;
    std::unique_ptr<scene::Simulation> simulation;
    std::unique_ptr<effects::EffectRuntime> effects;
    scene::NoGame game{scene::CameraDescription{}};

    explicit SceneRun(const std::string& name,
                      const scene::SimulationOverrides& overrides = {},
                      const effects::ServedDomains& served = {}) {
        Diagnostics faults;
        const std::filesystem::path assets = repository() / "assets";
        Result<scene::OpenedScene> read =
            scene::open_scene(assets / "scenes" / name,
                              {.folders = {.assets = assets,
                                           .shaders = repository() / "shaders",
                                           .config = repository() / "config"},
                               .overrides = overrides},
                              faults);
        for (const Diagnostic& fault : faults.list()) ADD_FAILURE() << to_string(fault);
        if (!read) return;
        opened = std::move(*read);
        auto built = opened->build(library);
        EXPECT_TRUE(built.ok()) << (built.ok() ? "" : built.error().message);
        if (!built) return;
        simulation = std::move(*built);
        study::play_case_events(*simulation);
        effects = std::make_unique<effects::EffectRuntime>(*simulation, served);
    }

    void step(std::uint64_t count) {
        for (std::uint64_t i = 0; i < count; ++i) {
            effects::advance(*simulation, *effects, game, {});
        }
    }
    effects::RunningGame running() {
        return {.opened = *opened, .simulation = *simulation, .effects = *effects, .game = game};
    }
    physics::BodyState state(const std::string& name) const {
        const ecs::Entity entity = simulation->find(name);
        return simulation->physics.state(simulation->registry.get<scene::BodyRef>(entity).body);
    }
};

}  // namespace plumbline::test
