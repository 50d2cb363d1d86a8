// The parent's side of foreign_import.h. Private to engine/assets.
#pragma once

#include "engine/assets/checked_model.h"

namespace plumbline::assets {

/// Starts the worker for the file and resolves the images that it names.
Result<ModelData> import_foreign(const std::filesystem::path& file,
                                 std::string_view bytes,
                                 const std::string& name,
                                 ModelReferences& references);

}  // namespace plumbline::assets
