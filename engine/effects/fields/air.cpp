#include "engine/effects/fields/air.h"

#include "engine/scene/environment/wind_field.h"

namespace plumbline::effects {

Air::Air(const scene::Simulation& simulation) {
    const scene::SceneDescription& scene = simulation.description();
    const bool has_wind = scene.wind.has_value() || !scene.forces.wind_zones.empty();
    if (has_wind && simulation.switches.is_on("wind", true)) scene_ = &scene;
}

Vec3d Air::at(const Vec3d& place, double time_s, double in_wind) const {
    Vec3d air_mps{0, 0, 0};
    if (!blows()) return air_mps;
    const Vec3 at(place);
    for (const scene::WindZone& zone : scene_->forces.wind_zones) {
        if (glm::any(glm::lessThan(at, zone.min_m)) || glm::any(glm::greaterThan(at, zone.max_m)))
            continue;
        air_mps += Vec3d(zone.velocity_mps);
        in_wind *= static_cast<double>(zone.wind_share);
    }
    if (scene_->wind && in_wind > 0)
        air_mps += Vec3d(scene::wind_at(*scene_->wind, at, time_s)) * in_wind;
    return air_mps;
}

}  // namespace plumbline::effects
