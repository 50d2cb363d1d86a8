// `plumbline scenes`: what play takes by name.
#pragma once

#include "engine/core/process/exit_code.h"

namespace plumbline::game {

/// A line for each scene below assets/scenes, or a JSON array of objects with name, title,
/// description and file.
ExitCode run_scenes(bool as_json);

}  // namespace plumbline::game
