// The parent's side of foreign_import.h. Private to engine/assets.
#pragma once

#include "engine/assets/model/model_references.h"
#include "engine/assets/model_data.h"
#include "engine/core/result.h"

#include <cstddef>

namespace plumbline::assets {

/// Who reads, and what he may take.
struct ForeignReader {
    std::filesystem::path
        program{};  ///< empty: the plumbline beside this program, itself as a rule
    std::size_t most_bytes{2ULL << 30U};
    double most_s{90.0};  ///< of wall time
};

/// Starts the worker for the file and resolves the images that it names.
Result<ModelData> import_foreign(const std::filesystem::path& file,
                                 std::string_view bytes,
                                 const std::string& name,
                                 ModelReferences& references,
                                 const ForeignReader& reader = {});

}  // namespace plumbline::assets
