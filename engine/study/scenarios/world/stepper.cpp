#include "engine/study/scenarios/world/stepper.h"

#include <algorithm>
#include <cmath>

namespace plumbline::study {
namespace {

// Nothing in the scenarios moves nearly as fast, and what is stepped once does not get there.
constexpr double kExploded_mps = 1e3;

RunStatus status_of(const ScenarioWorld& world) {
    if (world.broken()) return RunStatus::NotFinite;
    for (const physics::BodyId id : world.movers) {
        if (glm::length(world.velocity(id)) > kExploded_mps) return RunStatus::Exploded;
    }
    return RunStatus::Done;
}

}  // namespace

void Stepper::run(ScenarioWorld& world, double seconds, const Hooks& hooks) {
    const double step_s = world.step_s();
    const int steps = static_cast<int>(std::lround(seconds / step_s));
    bodies_ = std::max(bodies_, world.movers.size());
    const bool is_timed = mode_ == Mode::Time;
    const std::span<physics::ForceField* const> fields(&hooks.field,
                                                       hooks.field != nullptr ? 1 : 0);
    if (is_timed) meter_.resume();
    for (int i = 0; i < steps; ++i) {
        if (hooks.before) hooks.before(i);
        world.physics.step(fields);
        if (is_timed) {
            meter_.stepped(world.physics.report().cost, step_s);
        } else if (hooks.after) {
            hooks.after(i);
        }
        if (hooks.until && hooks.until()) break;
    }
    if (is_timed) meter_.pause();
    const RunStatus found = status_of(world);
    if (status_ == RunStatus::Done) status_ = found;
}

}  // namespace plumbline::study
