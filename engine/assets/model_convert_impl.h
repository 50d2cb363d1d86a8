// assimp's scene to ModelData. Private to engine/assets.
#pragma once

#include "engine/assets/checked_model.h"
#include "engine/assets/model_data.h"

struct aiScene;

namespace plumbline::assets {

/// Applies node transforms, merges everything, checks every number. Meshes that are no good are
/// left out with a warning; the error is for a model of which nothing is left.
Result<ModelData> convert_scene(const aiScene& scene,
                                std::vector<MaterialData> materials,
                                const std::string& name);

}  // namespace plumbline::assets
