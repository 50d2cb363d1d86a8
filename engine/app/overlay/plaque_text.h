// What a plaque says, line by line.
#pragma once

#include "engine/app/ui/hud_layout.h"
#include "engine/scene/environment/plaque.h"

#include <vector>

namespace plumbline::app {

/// `cost_ms`: of a step, by its effect or, where it names none, by the rigid bodies.
std::vector<ui::HudLine> plaque_lines(const scene::PlaqueReading& reading, double cost_ms);

}  // namespace plumbline::app
