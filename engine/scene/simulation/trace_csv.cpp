#include "engine/scene/simulation/trace_csv.h"

#include "engine/core/text/csv.h"

#include <fmt/format.h>

#include <iterator>

namespace plumbline::scene {

std::string trace_csv_head() {
    return "time_s,body,x_m,y_m,z_m,qw,qx,qy,qz,vx_mps,vy_mps,vz_mps,wx_radps,wy_radps,wz_radps,"
           "mass_kg,awake\n";
}

std::string trace_csv_lines(const Simulation& simulation) {
    std::string lines;
    for (const MovingBody& moving : simulation.moving_bodies()) {
        if (!simulation.physics.contains(moving.body)) continue;
        const physics::BodyState state = simulation.physics.state(moving.body);
        const Vec3& p = state.world_from_body.position;
        const Quat& q = state.world_from_body.orientation;
        const Vec3& v = state.velocity_mps;
        const Vec3& w = state.angular_velocity_radps;
        fmt::format_to(std::back_inserter(lines),
                       "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n",
                       simulation.time_s(),
                       csv_field(simulation.registry.get<Name>(moving.entity).text),
                       p.x,
                       p.y,
                       p.z,
                       q.w,
                       q.x,
                       q.y,
                       q.z,
                       v.x,
                       v.y,
                       v.z,
                       w.x,
                       w.y,
                       w.z,
                       state.mass.mass_kg,
                       state.awake ? 1 : 0);
    }
    return lines;
}

}  // namespace plumbline::scene
