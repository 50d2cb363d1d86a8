// Which bodies need an optional part of the physics in the next step.
#pragma once

#include "engine/ecs/registry.h"

namespace plumbline::scene {

class Simulation;

/// One of each, or null.
struct MotionDemand {
    /// Asks for sweeps, or may move more than its inner radius in a substep: by its own speed, or
    /// struck by the fastest of the others.
    ecs::Entity swept{};
    ecs::Entity spinning{};  ///< turns, and its inertia is not the same about every axis

    friend bool operator==(const MotionDemand&, const MotionDemand&) = default;
};

/// Of the next step: a function of the state alone. Who `simulation.motion_demand` names stays named
/// while it qualifies.
MotionDemand motion_demand_of(const Simulation& simulation);

}  // namespace plumbline::scene
