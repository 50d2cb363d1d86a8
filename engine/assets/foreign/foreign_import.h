// Collada and FBX: assimp reads them, in a process of its own, because its importers of these
// formats are not hardened against hostile files. The program's hidden command `model-worker` is
// that process; what it answers is checked like any other input.
#pragma once

#include "engine/assets/model_data.h"
#include "engine/core/process/exit_code.h"
#include "engine/core/result.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace plumbline::assets {

/// The worker's side: limits this process, reads the file and writes the answer to standard output.
ExitCode run_model_worker(const std::filesystem::path& file);

/// What the worker does with the bytes, in this process: for it and for tests.
Result<ModelData> read_foreign(std::string_view bytes, const std::string& name);

}  // namespace plumbline::assets
