// assimp's scene to ModelData. Private to engine/assets.
#pragma once

#include "engine/assets/checked_model.h"
#include "engine/assets/model_data.h"

#include <assimp/matrix4x4.h>

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

struct aiMesh;
struct aiNode;
struct aiScene;

namespace plumbline::assets {

/// assimp keeps rows, GLM columns.
Mat4f matrix_of(const aiMatrix4x4& m);

/// Nodes and triangles; `name` is the file's, for warnings about meshes that are left out. Meshes
/// whose material is called by a number of `materials` wear that one, others a plain one. Normals
/// that are missing stay zero.
ModelData convert_scene(const aiScene& scene,
                        std::vector<MaterialData> materials,
                        const std::string& name);

/// As above with what formats have that assimp alone reads: its materials and images (maps in files
/// stay as the file writes them), bones and animations.
ModelData convert_foreign_scene(const aiScene& scene, const std::string& name);

/// A scene and where its parts went.
struct ConvertedScene {
    ModelData model;
    std::map<const aiNode*, std::uint32_t> places;     ///< ModelData::nodes
    std::vector<std::optional<std::uint32_t>> meshes;  ///< by assimp's number; none: left out
};
/// `material_of` tells the number of a mesh's material; past the end stands for a plain one.
ConvertedScene convert_tree(const aiScene& scene,
                            std::vector<MaterialData> materials,
                            const std::function<std::size_t(const aiMesh&)>& material_of,
                            const std::string& name);

}  // namespace plumbline::assets
