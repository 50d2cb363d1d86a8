// Waves on boxes of water.
#include "engine/core/io/archive.h"
#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"
#include "engine/scene/environment/wave_field.h"

namespace plumbline::effects {
namespace {

bool has_waves(const scene::WaterDescription& water) {
    return water.surface == scene::WaterSurface::Waves;
}

/// Along each side.
int modes_of(const scene::Simulation& simulation) {
    return by_fidelity(simulation.description().forces.fidelity.water, std::array{16, 32, 64});
}

/// Steps the waves after the bodies have given them what they displaced.
class Water final : public Effect {
public:
    explicit Water(scene::Simulation& simulation) : simulation_(simulation) {
        const int modes = modes_of(simulation);
        const auto gravity_mps2 =
            std::max(-static_cast<double>(simulation.physics.def().gravity_mps2.y), 0.0);
        for (const scene::WaterDescription& water : simulation.description().forces.waters)
            simulation.waves.push_back(
                has_waves(water) ? std::make_unique<scene::WaveField>(water, modes, gravity_mps2)
                                 : nullptr);
    }
    ~Water() override { simulation_.waves.clear(); }
    Water(const Water&) = delete;
    Water& operator=(const Water&) = delete;

    void after_step(scene::Simulation& simulation, const scene::Game&) override {
        for (auto& waves : simulation.waves) {
            if (!waves || waves->is_asleep()) continue;
            waves->advance(simulation.step_s());
            ++work_.calls;
        }
    }

    void serialize(Archive& archive) override {
        for (auto& waves : simulation_.waves) {
            if (waves) waves->serialize(archive);
        }
    }

    std::uint64_t bytes_held() const override {
        const int modes = modes_of(simulation_);
        return simulation_.waves.size() * static_cast<std::uint64_t>(modes * modes) * 32;
    }

private:
    scene::Simulation& simulation_;
};

Callers callers_of_water(const scene::Simulation& simulation) {
    if (!simulation.switches.is_on("water", true)) return {};
    Callers callers;
    for (const scene::WaterDescription& water : simulation.description().forces.waters) {
        if (has_waves(water)) callers.push_back(setting("[[water]] " + water.name, water.location));
    }
    return callers;
}

}  // namespace

EffectRow water() {
    return with_effect<Water>({.called_for_by = &callers_of_water});
}

}  // namespace plumbline::effects
