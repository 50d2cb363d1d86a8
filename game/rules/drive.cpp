#include "game/rules/drive.h"

#include "engine/physics/query.h"
#include "game/rules/camera_rig.h"

#include <algorithm>
#include <cmath>

namespace plumbline::game {
namespace {

constexpr Real kUpright = 0.7_r;  ///< least height of its up
constexpr Real kAbove_m = 10;     ///< from where its top is looked for
constexpr double kMostSteer_rad = 0.6;
/// At this speed it is steered by half as much.
constexpr double kFast_mps = 8;
constexpr double kStands_mps = 0.3;

std::optional<std::size_t> vehicle_of(const scene::Simulation& simulation, const Looked& looked) {
    if (!simulation.registry.alive(looked.entity)) return {};
    const auto* part = simulation.registry.find<scene::PartOf>(looked.entity);
    if (part != nullptr && part->whole == scene::PartOf::Whole::Vehicle) return part->index;
    const auto vehicles = simulation.vehicles();
    for (std::size_t i = 0; i < vehicles.size(); ++i) {
        if (vehicles[i].chassis == looked.body) return i;
    }
    return {};
}

}  // namespace

std::optional<DriverSeat> driver_seat_at(const scene::Simulation& simulation,
                                         const Looked& looked,
                                         physics::BodyId own_body) {
    const auto vehicle = vehicle_of(simulation, looked);
    if (!vehicle) return {};
    const physics::BodyId chassis = simulation.vehicles()[*vehicle].chassis;
    if (!simulation.physics.contains(chassis)) return {};
    const Pose at = simulation.physics.state(chassis).world_from_body;
    const Vec3 up = at.orientation * Vec3{0, 1, 0};
    if (up.y < kUpright) return {};
    const auto top = physics::cast_ray(
        simulation.physics, at.position + up * kAbove_m, at.position, {.ignored = own_body});
    if (!top || top->body != chassis) return {};
    return DriverSeat{.vehicle = *vehicle, .seat_m = top->point_world};
}

void Driver::leave(scene::Simulation& simulation) {
    if (!vehicle_) return;
    simulation.vehicles()[*vehicle_].controls = {.throttle = 0, .brake = 1, .steer_rad = 0};
    vehicle_.reset();
}

void Driver::act(scene::Simulation& simulation, const Actions& actions) {
    if (!vehicle_) return;
    const double ahead =
        static_cast<double>(travel_of(actions, Action::Forward) - travel_of(actions, Action::Back));
    const double left =
        static_cast<double>(travel_of(actions, Action::Left) - travel_of(actions, Action::Right));
    const auto speed = static_cast<double>(speed_mps(simulation));
    scene::VehicleControls& controls = simulation.vehicles()[*vehicle_].controls;
    const bool stands = std::abs(speed) < kStands_mps;
    const bool against = ahead * speed < 0 && !stands;
    controls.throttle = against ? 0 : ahead;
    controls.brake = against ? std::abs(ahead) : (ahead == 0 && stands ? 1.0 : 0.0);
    if (actions.is_held(Action::Jump)) controls = {.throttle = 0, .brake = 1};
    const double slower = speed / kFast_mps;
    controls.steer_rad = left * kMostSteer_rad / (1 + slower * slower);
    simulation.physics.wake(simulation.vehicles()[*vehicle_].chassis);
}

Real Driver::speed_mps(const scene::Simulation& simulation) const {
    if (!vehicle_) return 0;
    const physics::BodyState chassis =
        simulation.physics.state(simulation.vehicles()[*vehicle_].chassis);
    return glm::dot(chassis.velocity_mps, chassis.world_from_body.orientation * Vec3{0, 0, -1});
}

void Driver::forget_gone(const scene::Simulation& simulation) {
    if (!vehicle_) return;
    const auto vehicles = simulation.vehicles();
    if (*vehicle_ >= vehicles.size() || !simulation.physics.contains(vehicles[*vehicle_].chassis))
        vehicle_.reset();
}

}  // namespace plumbline::game
