// Surfaces that move along themselves: belts and turntables that stand still.
#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"

namespace plumbline::effects {
namespace {

/// Switches belts on while it lives. What friction on them costs is the friction's.
class Conveyor final : public Effect {
public:
    explicit Conveyor(scene::Simulation& simulation) : simulation_(simulation) { set(true); }
    ~Conveyor() override { set(false); }
    Conveyor(const Conveyor&) = delete;
    Conveyor& operator=(const Conveyor&) = delete;

    void after_step(scene::Simulation& simulation, const scene::Game&) override {
        work_.calls += simulation.physics.report().cost.belts;
    }

private:
    void set(bool on) {
        physics::WorldFeatures features = simulation_.features();
        features.belts = on;
        simulation_.set_features(features);
    }

    scene::Simulation& simulation_;
};

Callers callers_of_conveyor(const scene::Simulation& simulation) {
    if (!simulation.switches.is_on("conveyor", true)) return {};
    return entities_with<scene::Belt>(simulation);
}

}  // namespace

EffectRow conveyor() {
    return with_effect<Conveyor>({.called_for_by = &callers_of_conveyor});
}

}  // namespace plumbline::effects
