// Gamepad axes to amounts: round dead zones, response curve, triggers.
#pragma once

#include "engine/input/bindings.h"

#include <array>

namespace plumbline::input {

/// A stick's deflection after dead zones and curve: length 0…1, same direction as the raw one.
/// The inner zone is round, so that looking about has no sticky axes; travel from its edge to the
/// outer edge is rescaled to 0…1. Non-finite axes count as 0.
std::array<float, 2> shape_stick(float x, float y, const Tuning& tuning);

inline constexpr std::size_t kTriggerAxis = 4;  ///< this one and the next are triggers

/// A trigger's travel, 0…1, from an axis that rests at -1.
float trigger_travel(float axis);

}  // namespace plumbline::input
