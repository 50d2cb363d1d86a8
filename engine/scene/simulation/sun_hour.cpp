#include "engine/scene/simulation/sun_hour.h"

#include "engine/scene/environment/sun_path.h"

namespace plumbline::scene {

void set_hour(Simulation& simulation, double hour) {
    const auto& time = simulation.description().time;
    if (time) simulation.switches.sun_direction = Vec3f(-to_sun_at(*time, hour));
}

std::optional<double> hour_of(const Simulation& simulation) {
    const auto& time = simulation.description().time;
    if (!time) return {};
    return hour_of_sun(*time, -simulation.switches.sun_direction);
}

}  // namespace plumbline::scene
