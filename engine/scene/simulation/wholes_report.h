// What a state file says of ropes, vehicles, cloth, soft bodies, water and what broke.
#pragma once

#include "engine/physics/contact.h"
#include "engine/scene/formats/json_text.h"
#include "engine/scene/simulation.h"

#include <span>

namespace plumbline::scene {

/// `contacts`: all of the latest step. A key each.
void add_wholes(JsonText& json,
                const Simulation& simulation,
                std::span<const physics::ContactEvent> contacts);

}  // namespace plumbline::scene
