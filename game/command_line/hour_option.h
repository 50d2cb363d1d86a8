// The option --hour of play and render.
#pragma once

#include "engine/scene/simulation.h"
#include "engine/scene/simulation/sun_hour.h"
#include "game/command_line/refuse.h"

#include <optional>

namespace plumbline::game {

/// Sets the sun as the option says; without one it stands as the scene has it.
inline Result<Done> set_hour(const std::optional<double>& hour, scene::Simulation& simulation) {
    if (!hour) return Done{};
    if (!hour_of(simulation))
        return Error{.message = "--hour: the scene has no [time], so its sun does not move",
                     .exit_code = ExitCode::BadUsage};
    set_hour(simulation, *hour);
    return Done{};
}

}  // namespace plumbline::game
