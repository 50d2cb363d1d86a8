#include "engine/study/engines/other_engine.h"

#include "engine/study/engines/neutral_scene.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>

namespace plumbline::study {

OtherEngine::OtherEngine(EngineProcess& process, scene::Simulation& simulation)
    : process_(process),
      simulation_(simulation),
      gravity_mps2_(simulation.physics.def().gravity_mps2) {
    for (const scene::MovingBody& moving : simulation.moving_bodies()) {
        if (moving.kind == physics::BodyKind::Dynamic) bodies_.push_back(moving.body);
    }
    // Of velocities a scene handed over says nothing: the first steps set all.
    known_.assign(bodies_.size() * kNumbersOfBody, std::numeric_limits<double>::quiet_NaN());
    simulation.stepped_elsewhere = [this] { ++pending_; };
}

OtherEngine::~OtherEngine() {
    simulation_.stepped_elsewhere = nullptr;
}

Result<std::unique_ptr<OtherEngine>> OtherEngine::create(const EngineSetting& setting,
                                                         EngineProcess& process,
                                                         PlayedScene& scene) {
    if (const std::vector<std::string> names = not_handed(scene); !names.empty())
        return Error{.message = fmt::format("the scene has what no other engine is handed: {}",
                                            fmt::join(names, ", ")),
                     .exit_code = ExitCode::Refused};
    std::unique_ptr<OtherEngine> made(new OtherEngine(process, scene.simulation()));
    NeutralScene handed = neutral_scene(scene.simulation(), made->bodies_, setting);
    made->places_ = std::move(handed.places);
    const Result<Done> done = process.make(handed.text);
    if (!done) return done.error();
    return made;
}

/// What the simulation says that the engine does not know: a shift, an event of a hard case.
EngineSteps OtherEngine::steps_since() {
    EngineSteps steps{.steps = pending_};
    now_ = states_of(simulation_.physics, bodies_);
    const std::span<const double> now(now_);
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        if (!simulation_.physics.contains(bodies_[i])) continue;  // the engine may keep it
        const std::span<const double> own = now.subspan(i * kNumbersOfBody, kNumbersOfBody);
        if (!std::ranges::equal(own, std::span(known_).subspan(i * kNumbersOfBody, kNumbersOfBody)))
            steps.set.emplace_back(places_[i], own);
    }
    const Vec3& gravity = simulation_.physics.def().gravity_mps2;
    if (gravity != gravity_mps2_)
        steps.gravity_mps2 = {static_cast<double>(gravity.x),
                              static_cast<double>(gravity.y),
                              static_cast<double>(gravity.z)};
    return steps;
}

Result<EngineMoved> OtherEngine::catch_up(double limit_s) {
    const EngineSteps steps = steps_since();
    pending_ = 0;
    gravity_mps2_ = simulation_.physics.def().gravity_mps2;
    Result<EngineMoved> moved = process_.advance(steps, limit_s);
    if (!moved) return moved;
    if (moved->states.size() != known_.size())
        return Error{.message = "it answers with other bodies", .exit_code = ExitCode::Refused};
    if (!moved->is_finite) return moved;
    set_states(simulation_.physics, bodies_, moved->states);
    known_ = states_of(simulation_.physics, bodies_);
    return moved;
}

physics::PoseFaults OtherEngine::faults() {
    return physics::pose_faults(simulation_.physics);
}

}  // namespace plumbline::study
