// Collada and FBX, read by assimp, as glTF. Private to engine/assets.
#pragma once

#include "engine/core/result.h"

#include <string>
#include <string_view>

struct aiScene;

namespace plumbline::assets {

/// Why the content is not one that assimp is asked to read; empty when it is.
std::string foreign_model_fault(std::string_view bytes);

/// A .glb of the model in metres; images that lie in files are named as the file names them. For a
/// confined process: assimp's importers are not hardened.
Result<std::string> glb_of_foreign_model(std::string_view bytes, const std::string& name);

/// The same of what assimp read; the scene is changed.
Result<std::string> glb_of_scene(aiScene& scene, const std::string& name);

}  // namespace plumbline::assets
