// What our pre-check leaves of an OBJ file: only what has been checked, rewritten from scratch, so
// that assimp meets nothing else; and the readers that need no assimp. Private to engine/assets.
#pragma once

#include "engine/assets/model_data.h"
#include "engine/assets/model_references.h"
#include "engine/core/result.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::assets {

struct CheckedModel {
    std::string main_name;                     ///< "model.obj"
    std::map<std::string, std::string> files;  ///< main_name and what belongs to it, by plain name
    std::vector<MaterialData> materials;       ///< complete; meshes name them by "usemtl N"
};

/// `name` is the file as the person knows it, for messages. Warnings go to the log.
Result<CheckedModel> check_obj(std::string_view bytes,
                               const std::string& name,
                               ModelReferences& references);
/// Everything but the merged mesh.
Result<ModelData> read_gltf(std::string_view bytes,
                            const std::string& name,
                            ModelReferences& references);

/// "model NAME is refused: WHY".
Error model_error(const std::string& name, std::string_view why);

}  // namespace plumbline::assets
