// Accuracy settings to choose from: what the accuracy panel and the settings page offer.
#pragma once

#include "engine/study/setting.h"

#include <span>
#include <string_view>

namespace plumbline::app {

std::span<const int> offered_rates_hz();

/// The same rate and precision with another solver, its numbers as "balanced" has them.
study::Setting with_solver(study::Setting setting, physics::Solver solver);
/// What scene::preset_of(name) asks of the solver in use.
study::Setting with_preset(study::Setting setting, std::string_view name);

}  // namespace plumbline::app
