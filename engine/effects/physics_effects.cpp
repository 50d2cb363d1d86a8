#include "engine/effects/effects.h"

namespace plumbline::effects {

namespace {

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

using ContinuousCollision = PhysicsPart<&physics::WorldFeatures::continuous_collision,
                                        &physics::FeatureUse::swept_bodies,
                                        &physics::FeatureUse::sweep_ms>;
using GyroscopicTorque = PhysicsPart<&physics::WorldFeatures::gyroscopic_torque,
                                     &physics::FeatureUse::gyro_bodies,
                                     &physics::FeatureUse::gyro_ms>;
using ContactEvents = PhysicsPart<&physics::WorldFeatures::contact_events,
                                  &physics::FeatureUse::events,
                                  &physics::FeatureUse::events_ms>;

}  // namespace

std::unique_ptr<Effect> make_continuous_collision(scene::Simulation& simulation) {
    return std::make_unique<ContinuousCollision>(simulation);
}
std::unique_ptr<Effect> make_gyroscopic_torque(scene::Simulation& simulation) {
    return std::make_unique<GyroscopicTorque>(simulation);
}
std::unique_ptr<Effect> make_contact_events(scene::Simulation& simulation) {
    return std::make_unique<ContactEvents>(simulation);
}

}  // namespace plumbline::effects
