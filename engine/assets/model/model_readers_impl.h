// The readers that are ours. `name` is the file as the person knows it, for messages; warnings go to
// the log. What they give lacks the merged mesh. Private to engine/assets.
#pragma once

#include "engine/assets/model/model_references.h"
#include "engine/assets/model_data.h"
#include "engine/core/result.h"

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace plumbline::assets {

Result<ModelData> read_gltf(std::string_view bytes,
                            const std::string& name,
                            ModelReferences& references);
Result<ModelData> read_obj(std::string_view bytes,
                           const std::string& name,
                           ModelReferences& references);
Result<ModelData> read_ply(std::string_view bytes, const std::string& name);
Result<ModelData> read_stl(std::string_view bytes, const std::string& name);

/// Reads one .mtl. The error is for files outside the root; what is merely odd is logged.
Result<std::vector<MaterialData>> read_mtl(const std::filesystem::path& file,
                                           const std::string& name,
                                           ModelReferences& references);

/// "model NAME is refused: WHY".
Error model_error(const std::string& name, std::string_view why);

/// Why a file cannot be read: ends the reading, of a glTF animation that one's. Never leaves a reader.
struct ModelFault {
    std::string words;
};
template <class... Args>
[[noreturn]] void fail(fmt::format_string<Args...> format, Args&&... args) {
    throw ModelFault{fmt::format(format, std::forward<Args>(args)...)};
}
/// What `read` makes of the file, or its fault as an error.
template <class Read>
auto or_refused(const std::string& name, Read read) -> Result<decltype(read())> {
    try {
        return read();
    } catch (const ModelFault& fault) {
        return model_error(name, fault.words);
    }
}

}  // namespace plumbline::assets
