// An effect that is an optional part of the physics.
#pragma once

#include "engine/effects/effect.h"
#include "engine/scene/simulation/entity_lookup.h"

namespace plumbline::effects {

/// Books what one part of the physics did in each step. Of a part that the physics decides about: there
/// while it acted in the latest step.
template <std::uint32_t physics::FeatureUse::*kCount, double physics::FeatureUse::*kCost_ms>
class PhysicsUse : public Effect {
public:
    void after_step(scene::Simulation& simulation, const scene::Game&) override {
        const physics::FeatureUse& use = simulation.physics.report().use;
        work_.calls += use.*kCount;
        work_.cpu_ms += use.*kCost_ms;
    }
};

/// Also switches the part on while it lives.
template <bool physics::WorldFeatures::*kFeature,
          std::uint32_t physics::FeatureUse::*kCount,
          double physics::FeatureUse::*kCost_ms>
class PhysicsPart final : public PhysicsUse<kCount, kCost_ms> {
public:
    explicit PhysicsPart(scene::Simulation& simulation) : simulation_(simulation) { set(true); }
    ~PhysicsPart() override { set(false); }
    PhysicsPart(const PhysicsPart&) = delete;
    PhysicsPart& operator=(const PhysicsPart&) = delete;

private:
    void set(bool on) {
        physics::WorldFeatures features = simulation_.features();
        features.*kFeature = on;
        simulation_.set_features(features);
    }

    scene::Simulation& simulation_;
};

/// What a part that the physics decides about is called for by: the first body that it acted on.
template <physics::BodyId physics::FeatureUse::*kFirst>
Callers callers_of_use(const scene::Simulation& simulation) {
    const physics::BodyId first = simulation.physics.report().use.*kFirst;
    if (!simulation.physics.contains(first)) return {};
    return {describe(simulation, entity_of_mark(simulation, simulation.physics.state(first).user))};
}

template <physics::BodyId physics::FeatureUse::*kFirst>
std::uint64_t key_of_use(const scene::Simulation& simulation) {
    const physics::BodyId first = simulation.physics.report().use.*kFirst;
    return simulation.physics.contains(first) ? simulation.physics.state(first).user + 1 : 0;
}

}  // namespace plumbline::effects
