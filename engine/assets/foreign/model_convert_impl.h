// assimp's scene to ModelData. Private to engine/assets.
#pragma once

#include "engine/assets/model_data.h"

#include <assimp/matrix4x4.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

struct aiNode;
struct aiScene;

namespace plumbline::assets {

/// assimp keeps rows, GLM columns.
Mat4f matrix_of(const aiMatrix4x4& m);

/// All of it; `name` is the file's, for warnings about meshes that are left out. Normals that are
/// missing stay zero; maps in files stay as the file writes them.
ModelData convert_foreign_scene(const aiScene& scene, const std::string& name);

/// A scene and where its parts went.
struct ConvertedScene {
    ModelData model;
    std::map<const aiNode*, std::uint32_t> places;     ///< ModelData::nodes
    std::vector<std::optional<std::uint32_t>> meshes;  ///< by assimp's number; none: left out
};
/// Nodes and triangles. A mesh whose material's number is past the end wears a plain one.
ConvertedScene convert_tree(const aiScene& scene,
                            std::vector<MaterialData> materials,
                            const std::string& name);

}  // namespace plumbline::assets
