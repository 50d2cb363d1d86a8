// What our pre-checks leave of a model file: only what has been checked, rewritten from scratch,
// so that assimp meets nothing else. Private to engine/assets.
#pragma once

#include "engine/assets/material_data.h"
#include "engine/assets/model_references.h"
#include "engine/core/result.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::assets {

struct CheckedModel {
    std::string main_name;                     ///< "model.gltf" or "model.obj"
    std::map<std::string, std::string> files;  ///< main_name and its buffers, by plain name
    /// Complete, with resolved maps. Meshes name materials by index: glTF by their own number,
    /// OBJ by "usemtl N".
    std::vector<MaterialData> materials;
};

/// `name` is the file as the person knows it, for messages. Warnings go to the log.
Result<CheckedModel> check_gltf(std::string_view bytes,
                                const std::string& name,
                                ModelReferences& references);
Result<CheckedModel> check_obj(std::string_view bytes,
                               const std::string& name,
                               ModelReferences& references);

/// Whether a mesh's colours are its albedo. By convention that is said by the material's name,
/// vcol or vcol_SOMETHING: in the garden's trees the same attribute carries wind weights.
bool has_vertex_colors(const MaterialData& material);

/// "model NAME is refused: WHY".
Error model_error(const std::string& name, std::string_view why);

}  // namespace plumbline::assets
