// assimp's scene to ModelData. Private to engine/assets.
#pragma once

#include "engine/assets/checked_model.h"
#include "engine/assets/model_data.h"

#include <string>

struct aiScene;

namespace plumbline::assets {

/// Nodes and triangles; `name` is the file's, for warnings about meshes that are left out. Meshes
/// whose material is called by a number of `materials` wear that one, others a plain one. Normals
/// that are missing stay zero.
ModelData convert_scene(const aiScene& scene,
                        std::vector<MaterialData> materials,
                        const std::string& name);

}  // namespace plumbline::assets
