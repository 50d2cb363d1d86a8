// A model file's content: one mesh in one frame, its materials, and its nodes by name.
#pragma once

#include "engine/assets/material_data.h"
#include "engine/assets/mesh_data.h"

#include <string>
#include <vector>

namespace plumbline::assets {

/// All meshes of the file merged into the file's own frame (node transforms applied).
struct ModelData {
    MeshData mesh;
    std::vector<MaterialData> materials;  ///< at least one when there are triangles
};

}  // namespace plumbline::assets
