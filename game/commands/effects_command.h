// `plumbline study --effects SCENE`: what each effect that a scene calls for costs.
#pragma once

#include "engine/core/process/exit_code.h"

#include <filesystem>
#include <optional>

namespace plumbline::game {

/// Prints a table. Without a usable GL the effects of the image are left out, and a line says so.
ExitCode run_effects_study(const std::filesystem::path& scene, std::optional<double> seconds);

}  // namespace plumbline::game
