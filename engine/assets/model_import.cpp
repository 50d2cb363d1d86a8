#include "engine/assets/model_import.h"

#include "engine/assets/checked_model.h"
#include "engine/assets/confined_io_impl.h"
#include "engine/assets/model_convert_impl.h"
#include "engine/core/files.h"
#include "engine/core/limits.h"

#include <assimp/BaseImporter.h>
#include <assimp/Importer.hpp>
#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <memory>

namespace plumbline::assets {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kReadable = ".glb .gltf .obj";

/// assimp registers 48 importers, and hands a file to whichever likes its bytes. Two are left.
void keep_two_importers(Assimp::Importer& importer) {
    for (std::size_t i = importer.GetImporterCount(); i-- > 0;) {
        const std::string_view name = importer.GetImporterInfo(i)->mName;
        if (name == "glTF2 Importer" || name == "Wavefront Object Importer") continue;
        Assimp::BaseImporter* unwanted = importer.GetImporter(i);
        importer.UnregisterLoader(unwanted);
        delete unwanted;
    }
}

std::string lower_extension(const fs::path& file) {
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(), [](char letter) {
        return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
    });
    return extension;
}

Result<ModelData> import_checked(CheckedModel& checked, const std::string& name) {
    try {
        Assimp::Importer importer;
        keep_two_importers(importer);
        if (importer.GetImporterCount() != 2) {
            return model_error(name, "this build of assimp lacks the glTF 2 or the OBJ importer");
        }
        importer.SetIOHandler(std::make_unique<ConfinedIo>(checked).release());  // it takes over
        const aiScene* scene = importer.ReadFile(checked.main_name.c_str(), aiProcess_Triangulate);
        if (scene == nullptr) return model_error(name, importer.GetErrorString());
        return convert_scene(*scene, std::move(checked.materials), name);
    } catch (const std::exception& fault) {
        return model_error(name, fault.what());
    }
}

}  // namespace

Error model_error(const std::string& name, std::string_view why) {
    return {.message = fmt::format("model {} is refused: {}", name, why),
            .exit_code = ExitCode::Refused};
}

Result<ModelData> import_model(const fs::path& file, const fs::path& root) {
    const std::string name = file.string();
    const std::string extension = lower_extension(file);
    const bool is_gltf = extension == ".glb" || extension == ".gltf";
    if (!is_gltf && extension != ".obj") {
        return model_error(name,
                           fmt::format("{} files are not read; convert to glTF (readable: {})",
                                       extension.empty() ? "nameless" : extension,
                                       kReadable));
    }
    if (!is_inside(root, file)) {
        return model_error(name, fmt::format("it lies outside {}", root.string()));
    }
    const Result<std::string> bytes = read_file(file, limits::kModelFileBytes);
    if (!bytes) return model_error(name, bytes.error().message);
    ModelReferences references(file, root);
    Result<CheckedModel> checked =
        is_gltf ? check_gltf(*bytes, name, references) : check_obj(*bytes, name, references);
    if (!checked) return checked.error();
    return import_checked(*checked, name);
}

}  // namespace plumbline::assets
