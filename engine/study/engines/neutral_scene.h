// A scene of rigid bodies as any engine understands it, in JSON.
#pragma once

#include "engine/study/engine_setting.h"
#include "engine/study/engines/engine_process.h"
#include "engine/study/played_scene.h"

#include <span>
#include <string>
#include <vector>

namespace plumbline::study {

/// What of the scene no other engine is handed: "wind", "a body on a path". Empty: it is handed whole. The scene has
/// started.
std::vector<std::string> not_handed(const PlayedScene& scene);

struct NeutralScene {
    /// One line of JSON, what EngineProcess::make() wants: gravity, the bodies and joints as they stand, in mass frames, which of
    /// them are moving, rate and knobs.
    std::string text;
    std::vector<std::size_t> places;  ///< of the moving ones among all bodies
};
NeutralScene neutral_scene(const scene::Simulation& simulation,
                           std::span<const physics::BodyId> moving,
                           const EngineSetting& setting);

/// kNumbersOfBody for each; zeros for one that is gone.
std::vector<double> states_of(const physics::PhysicsWorld& world,
                              std::span<const physics::BodyId> bodies);
/// The way back. `numbers` has as many for each; those of one that is gone are left aside.
void set_states(physics::PhysicsWorld& world,
                std::span<const physics::BodyId> bodies,
                std::span<const double> numbers);
}  // namespace plumbline::study
