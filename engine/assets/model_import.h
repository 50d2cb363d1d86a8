// Model files to ModelData: glTF 2 (.gltf, .glb) by a reader of our own, OBJ (.obj with its .mtl)
// through assimp behind our own pre-check and confined file access.
#pragma once

#include "engine/assets/model_data.h"
#include "engine/core/result.h"

#include <filesystem>

namespace plumbline::assets {

/// `root`: the file, and the files that it names, must lie inside it (links followed); what it
/// names must also lie in its own folder or below. Faults of single meshes (NaN, indices out of
/// range) or animations drop those with a warning; a file that is unsafe or not what its name says
/// is refused as a whole.
///
/// Material names are kept: scenes replace materials by name.
Result<ModelData> import_model(const std::filesystem::path& file,
                               const std::filesystem::path& root);

}  // namespace plumbline::assets
