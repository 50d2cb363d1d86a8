#include "engine/assets/model_import.h"

#include "engine/assets/foreign/decoder.h"
#include "engine/assets/model/model_pose.h"
#include "engine/assets/model/model_readers_impl.h"
#include "engine/core/io/files.h"
#include "engine/core/limits.h"
#include "engine/core/text/printable.h"
#include "engine/core/text/text_case.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <new>

namespace plumbline::assets {
namespace {

namespace fs = std::filesystem;

Result<ModelData> read_kind(const std::string& extension,
                            std::string_view bytes,
                            const std::string& name,
                            ModelReferences& references) {
    const bool is_text = extension == ".obj" || extension == ".ply" || extension == ".gltf";
    if (is_text && is_utf16(bytes)) return model_error(name, kUtf16Fault);
    if (extension == ".obj") return read_obj(bytes, name, references);
    if (extension == ".ply") return read_ply(bytes, name);
    if (extension == ".stl") return read_stl(bytes, name);
    if (extension == ".dae" || extension == ".fbx") {
        return read_foreign_model(bytes, name, references);
    }
    return read_gltf(bytes, name, references);
}

/// Merges what was read; refuses what leaves nothing to draw or to collide with, or too much.
Result<ModelData> finished(ModelData model, const std::string& name) {
    model.mesh = merged_mesh(model, rest_pose(model), name);
    if (model.mesh.indices.empty() && model.physics.is_empty())
        return model_error(name, "it holds no triangles");
    if (model.mesh.vertices.size() > limits::kVertices ||
        model.mesh.indices.size() > limits::kIndices) {
        return model_error(name, "it is too large");
    }
    return model;
}

}  // namespace

Error model_error(const std::string& name, std::string_view why) {
    return {.message = fmt::format("model {} is refused: {}", name, why),
            .exit_code = ExitCode::Refused};
}

bool says_sides(const fs::path& file) {
    const std::string extension = to_lower(file.extension().string());
    return extension == ".glb" || extension == ".gltf";
}

bool is_model_file(const fs::path& file) {
    const std::string extension = to_lower(file.extension().string());
    return std::find(kModelExtensions.begin(), kModelExtensions.end(), extension) !=
           kModelExtensions.end();
}

Result<ModelData> import_model(const fs::path& file, const fs::path& root) {
    const std::string name = file.string();
    const std::string extension = to_lower(file.extension().string());
    const bool is_known = is_model_file(file);
    if (!is_known) {
        return model_error(name,
                           fmt::format("{} files are not read; convert to glTF (readable: {})",
                                       extension.empty() ? "nameless" : extension,
                                       fmt::join(kModelExtensions, " ")));
    }
    if (!is_inside(root, file)) {
        return model_error(name, fmt::format("it lies outside {}", root.string()));
    }
    const Result<std::string> bytes = read_file(file, limits::kModelFileBytes);
    if (!bytes) return model_error(name, bytes.error().message);
    ModelReferences references(file, root);
    try {
        Result<ModelData> model = read_kind(extension, *bytes, name, references);
        if (!model) return model;
        model->files.insert(model->files.begin(), file);
        return finished(std::move(*model), name);
    } catch (const std::bad_alloc&) {
        return model_error(name, "it needs more memory than there is");
    }
}

}  // namespace plumbline::assets
