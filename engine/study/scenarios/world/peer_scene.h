// The scenes that other engines were measured on: assets/scenes/bench/peers, for scenarios and tests.
#pragma once

#include "engine/core/result.h"
#include "engine/scene/simulation.h"
#include "engine/study/scenarios/world/scenario_world.h"

#include <memory>
#include <string_view>

namespace plumbline::study {

/// A scene of that folder at a setting, built as play builds it; its physics alone is stepped.
class PeerScene {
public:
    /// `name` as in the folder, without ".toml". Refused: what open_scene() and build() refuse.
    static Result<std::unique_ptr<PeerScene>> open(std::string_view name, const Setting& setting);

    const scene::SceneDescription& description() const { return simulation_->description(); }
    /// Of an entity that the file names; asserts that it has a body.
    physics::BodyId body(std::string_view entity) const;

private:
    PeerScene(std::unique_ptr<assets::AssetLibrary> library,
              std::unique_ptr<scene::Simulation> simulation);

    std::unique_ptr<assets::AssetLibrary> library_;
    std::unique_ptr<scene::Simulation> simulation_;

public:
    ScenarioWorld world;
};

}  // namespace plumbline::study
