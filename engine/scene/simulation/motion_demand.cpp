#include "engine/scene/simulation/motion_demand.h"

#include "engine/scene/simulation.h"

#include <algorithm>

namespace plumbline::scene {
namespace {

/// Below the share of its inner radius at which the physics sweeps a body: what speeds up within
/// the step is still seen.
constexpr Real kSweptShare = 0.9_r;
/// Slower turning than this the physics leaves without gyroscopic torque too.
constexpr Real kSpinning_radps = 1e-3_r;

}  // namespace

MotionDemand motion_demand_of(const Simulation& simulation) {
    // small_step looks for contacts once a step, bullet_* in each of its parts.
    const physics::WorldDef& world = simulation.physics.def();
    const int looks = world.solver == physics::Solver::SmallStep ? 1 : world.substeps;
    const auto substep_s = static_cast<Real>(simulation.step_s() / looks);
    MotionDemand demand;
    const MotionDemand& before = simulation.motion_demand;
    // Who is named stays named while it qualifies, so that the callers' list does not flicker.
    const auto name = [](ecs::Entity& named, ecs::Entity earlier, ecs::Entity entity) {
        if (!named || entity == earlier) named = entity;
    };
    Real fastest_mps{0};
    Real second_mps{0};
    ecs::Entity fastest{};
    for (const MovingBody& moving : simulation.moving_bodies()) {
        if (!simulation.physics.contains(moving.body)) continue;
        const bool is_dynamic = moving.kind == physics::BodyKind::Dynamic;
        if (is_dynamic && moving.ccd == physics::ContinuousCollision::On) {
            name(demand.swept, before.swept, moving.entity);
        }
        if (!moving.awake) continue;
        const physics::BodyState state = simulation.physics.state(moving.body);
        const Real speed_mps = glm::length(state.velocity_mps);
        if (speed_mps > fastest_mps) {
            second_mps = fastest_mps;
            fastest_mps = speed_mps;
            fastest = moving.entity;
        } else {
            second_mps = std::max(second_mps, speed_mps);
        }
        if (!is_dynamic) continue;
        if (moving.ccd == physics::ContinuousCollision::Auto &&
            speed_mps * substep_s > kSweptShare * moving.inner_radius_m) {
            name(demand.swept, before.swept, moving.entity);
        }
        if (!moving.spherical_inertia &&
            glm::length(state.angular_velocity_radps) > kSpinning_radps) {
            name(demand.spinning, before.spinning, moving.entity);
        }
    }
    // A light body that a heavy one strikes leaves at up to twice its speed, within the same step.
    for (const MovingBody& moving : simulation.moving_bodies()) {
        if (moving.kind != physics::BodyKind::Dynamic) continue;
        if (moving.ccd != physics::ContinuousCollision::Auto) continue;
        const Real other_mps = moving.entity == fastest ? second_mps : fastest_mps;
        if (Real{2} * other_mps * substep_s > kSweptShare * moving.inner_radius_m) {
            name(demand.swept, before.swept, moving.entity);
        }
    }
    return demand;
}

}  // namespace plumbline::scene
