// Driving a vehicle: sitting on it, the keys for walking are throttle, brake and steering wheel.
#pragma once

#include "engine/core/actions.h"
#include "engine/scene/simulation.h"
#include "game/rules/hands/grab.h"

#include <optional>

namespace plumbline::game {

/// Where a person sits down to drive, and what: a number in Simulation::vehicles().
struct DriverSeat {
    std::size_t vehicle{0};
    Vec3 seat_m{0, 0, 0};  ///< world
};

/// The seat of the vehicle whose body or wheel is looked at: on the top of its body, over the body's origin. None where it lies on its
/// side or nobody fits.
std::optional<DriverSeat> driver_seat_at(const scene::Simulation& simulation,
                                         const Looked& looked,
                                         physics::BodyId own_body);

/// Who drives what.
class Driver {
public:
    void take(std::size_t vehicle) { vehicle_ = vehicle; }
    /// The vehicle stays with its brake on.
    void leave(scene::Simulation& simulation);
    bool drives() const { return vehicle_.has_value(); }
    /// One step. Against the way it rolls the keys brake, jumping locks the wheels; left alone it rolls out and stands.
    void act(scene::Simulation& simulation, const Actions& actions);
    /// m/s, forward positive.
    Real speed_mps(const scene::Simulation& simulation) const;
    void forget_gone(const scene::Simulation& simulation);
    void serialize(Archive& archive) { archive(vehicle_); }

private:
    std::optional<std::size_t> vehicle_;
};

}  // namespace plumbline::game
