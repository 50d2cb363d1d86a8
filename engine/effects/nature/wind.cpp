// The wind as the image shows it: what has wind weights sways.
#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"
#include "engine/scene/environment/wind_field.h"

namespace plumbline::effects {
namespace {

void show_wind(const scene::Simulation& simulation, render::RenderFrame& frame) {
    const scene::WindDescription& wind = *simulation.description().wind;
    const Vec3f mean(wind.direction * wind.speed_mps);
    frame.wind = render::Wind{.mean_mps = {mean.x, mean.z}};
    const auto waves = scene::waves_at(wind, static_cast<double>(frame.time_s));
    for (std::size_t i = 0; i < waves.size(); ++i) {
        const scene::GustWave& wave = waves[i];
        frame.wind->gusts[i] = {.number_radpm = Vec2f(wave.number_radpm),
                                .phase_rad = static_cast<float>(wave.phase_rad),
                                .speed_mps = static_cast<float>(wave.speed_mps)};
    }
}

Callers callers_of_wind(const scene::Simulation& simulation) {
    const auto& wind = simulation.description().wind;
    if (!wind || !simulation.switches.is_on("wind", true)) return {};
    return {setting("[wind]", wind->location)};
}

}  // namespace

EffectRow wind() {
    return with_effect<FrameEffect<&show_wind>>({.called_for_by = &callers_of_wind});
}

}  // namespace plumbline::effects
