// A model as a block of bytes, from the process that reads foreign files to the one that shows them.
#pragma once

#include "engine/assets/model_data.h"
#include "engine/core/result.h"

#include <string>
#include <string_view>

namespace plumbline::assets {

/// Everything but the merged mesh and the list of files.
std::string bytes_of(const ModelData& model);
/// The error is for a block that breaks off or whose content breaks a promise of model_data.h.
Result<ModelData> model_of_bytes(std::string_view bytes);

/// Which promise of model_data.h the model breaks; empty when none.
std::string fault_of(const ModelData& model);

}  // namespace plumbline::assets
