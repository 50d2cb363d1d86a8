// Model files to ModelData: glTF 2 (.gltf, .glb) and OBJ (.obj with its .mtl), through assimp with
// only those two importers registered, behind our own pre-check and confined file access.
#pragma once

#include "engine/assets/model_data.h"
#include "engine/core/result.h"

#include <filesystem>

namespace plumbline::assets {

/// `root`: files that the model names must lie inside it (links followed).
/// Faults of single meshes (NaN, indices out of range) drop that mesh with a warning; a file that
/// is unsafe or not what its name says is refused as a whole.
Result<ModelData> import_model(const std::filesystem::path& file,
                               const std::filesystem::path& root);

}  // namespace plumbline::assets
