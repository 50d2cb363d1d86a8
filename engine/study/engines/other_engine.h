// Another engine in the place of a simulation's own solver: the scene is handed over as it stands, and every step takes the
// poses that come back. Everything that looks at the simulation looks at that engine then.
#pragma once

#include "engine/physics/world_copy.h"
#include "engine/study/engine_setting.h"
#include "engine/study/engines/engine_process.h"
#include "engine/study/played_scene.h"

#include <string>
#include <vector>

namespace plumbline::study {

class OtherEngine {
public:
    /// Of a scene that has started, at the engine's rate. Both outlive it, and the scene is stepped through it from now on.
    /// Refused: a scene that holds what no engine is handed, or what this one lacks.
    static Result<std::unique_ptr<OtherEngine>> create(const EngineSetting& setting,
                                                       EngineProcess& process,
                                                       PlayedScene& scene);
    ~OtherEngine();
    OtherEngine(const OtherEngine&) = delete;
    OtherEngine& operator=(const OtherEngine&) = delete;

    /// Lets the engine do the steps since the last call, and puts the bodies where it has them, unless a state is not finite.
    /// Refused: it failed, or took longer than `limit_s`.
    Result<EngineMoved> catch_up(double limit_s);
    /// Of the poses that it has now.
    physics::PoseFaults faults();

private:
    OtherEngine(EngineProcess& process, scene::Simulation& simulation);
    EngineSteps steps_since();

    EngineProcess& process_;
    scene::Simulation& simulation_;
    std::vector<physics::BodyId> bodies_;
    std::vector<std::size_t> places_;  ///< of `bodies_` among all that were handed over
    std::vector<double> known_;        ///< states that the engine has
    std::vector<double> now_;          ///< and those of the simulation
    Vec3 gravity_mps2_;
    int pending_{0};  ///< steps that the engine has still to do
};

}  // namespace plumbline::study
