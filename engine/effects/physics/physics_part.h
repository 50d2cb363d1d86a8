// An effect that is an optional part of the physics.
#pragma once

#include "engine/effects/effect.h"

namespace plumbline::effects {

/// Switches one part of the physics on while it lives, and books what that part did.
template <bool physics::WorldFeatures::*kFeature,
          std::uint32_t physics::FeatureUse::*kCount,
          double physics::FeatureUse::*kCost_ms>
class PhysicsPart final : public Effect {
public:
    explicit PhysicsPart(scene::Simulation& simulation) : simulation_(simulation) { set(true); }
    ~PhysicsPart() override { set(false); }
    PhysicsPart(const PhysicsPart&) = delete;
    PhysicsPart& operator=(const PhysicsPart&) = delete;

    void after_step(scene::Simulation& simulation, const scene::Game&) override {
        const physics::FeatureUse& use = simulation.physics.feature_use();
        work_.calls += use.*kCount;
        work_.cpu_ms += use.*kCost_ms;
    }
    std::uint64_t bytes_cpu() const override { return sizeof(*this); }

private:
    void set(bool on) {
        physics::WorldFeatures features = simulation_.features();
        features.*kFeature = on;
        simulation_.set_features(features);
    }

    scene::Simulation& simulation_;
};

}  // namespace plumbline::effects
