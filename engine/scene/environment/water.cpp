#include "engine/scene/environment/water.h"

namespace plumbline::scene {

double own_rise_m(const SceneWater& water, const Displaced& felt) {
    if (!water.waves || felt.gained_m3 == 0) return 0;
    return 0.5 * felt.gained_m3 *
           water.waves->response_pm2(felt.place_m.x, felt.place_m.z, kFeltOfRadius * felt.radius_m);
}

double felt_rise_m(const SceneWater& water,
                   const Displaced& felt,
                   const Vec3d& place_m,
                   double own_m) {
    if (!water.waves) return 0;
    return water.waves->height_m(place_m.x, place_m.z, kFeltOfRadius * felt.radius_m) + own_m;
}

void displace(std::span<SceneWater> waters, Displaced& before, const Displaced& now) {
    const auto waves_of = [waters](const Displaced& of) -> WaveField* {
        const auto number = static_cast<std::size_t>(of.water);
        return of.water >= 0 && number < waters.size() ? waters[number].waves.get() : nullptr;
    };
    const auto lift = [](WaveField* waves, const Displaced& of, double volume_m3) {
        if (waves != nullptr && volume_m3 != 0)
            waves->displace(of.place_m, kFeltOfRadius * of.radius_m, volume_m3);
    };
    const auto raise = [](WaveField* waves, double volume_m3) {
        if (waves != nullptr && volume_m3 != 0) waves->raise_level(volume_m3);
    };
    WaveField* const from = waves_of(before);
    WaveField* const to = waves_of(now);
    const double gained_m3 = now.volume_m3 - before.volume_m3;
    lift(from, before, -before.volume_m3);
    if (from != to) raise(from, -before.volume_m3);
    lift(to, now, now.volume_m3);
    raise(to, from == to ? gained_m3 : now.volume_m3);
    before = now;
    before.gained_m3 = gained_m3;
}

}  // namespace plumbline::scene
