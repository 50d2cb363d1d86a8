#include "engine/assets/foreign/foreign_import.h"

#include "engine/assets/foreign/confined_io_impl.h"
#include "engine/assets/foreign/foreign_import_impl.h"
#include "engine/assets/foreign/model_convert_impl.h"
#include "engine/assets/foreign/model_wire.h"
#include "engine/assets/model/model_readers_impl.h"
#include "engine/core/io/files.h"
#include "engine/core/io/output.h"
#include "engine/core/limits.h"
#include "engine/core/log.h"
#include "engine/core/process/process.h"

#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <exception>
#include <memory>
#include <new>

namespace plumbline::assets {
namespace {

namespace fs = std::filesystem;

// Of the worker. A model at our limits takes 3 GiB and ten seconds here.
constexpr rlim_t kMemoryBytes = 4ULL << 30U;
constexpr rlim_t kCpu_s = 30;
constexpr char kModelAnswer = 'M';
constexpr char kErrorAnswer = 'E';

enum class ForeignKind { None, Collada, Fbx };

/// By content, not by name.
ForeignKind kind_of(std::string_view bytes) {
    if (bytes.starts_with("Kaydara FBX Binary")) return ForeignKind::Fbx;
    std::string head(bytes.substr(0, 4'096));
    std::erase(head, '\0');  // UTF-16
    if (head.find("<COLLADA") != std::string::npos) return ForeignKind::Collada;
    return head.find("FBXHeaderExtension") != std::string::npos ? ForeignKind::Fbx
                                                                : ForeignKind::None;
}

/// Without blanks at the beginning of an element, where assimp 5.2 expects a number at once.
std::string tightened(std::string_view xml) {
    std::string text;
    text.reserve(xml.size());
    bool begins = false;
    for (const char letter : xml) {
        const bool is_blank = letter == ' ' || letter == '\t' || letter == '\r' || letter == '\n';
        if (begins && is_blank) continue;
        begins = letter == '>';
        text += letter;
    }
    return text;
}

void limit_this_process() {
    const auto limit = [](auto resource, rlim_t most, rlim_t grace = 0) {
        const rlimit both{.rlim_cur = most, .rlim_max = most + grace};
        setrlimit(resource, &both);  // where it is refused the parent's clock still counts
    };
    end_with_parent();             // nobody would hear the answer
    limit(RLIMIT_CPU, kCpu_s, 5);  // so that its end tells the reason
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, 0);
#ifndef __SANITIZE_ADDRESS__
    limit(RLIMIT_AS, kMemoryBytes);
#endif
}

/// The program that has the worker in it: this one, as a rule.
fs::path worker_program() {
    std::error_code failed;
    const fs::path self = fs::read_symlink("/proc/self/exe", failed);
    const fs::path beside = self.parent_path() / "plumbline";
    return fs::is_regular_file(beside, failed) ? beside : fs::path{};
}

/// The image that a material means: where the file says, or else beside the model, since exporters
/// write down the folders of the machine that they ran on.
fs::path found_image(const fs::path& raw, const ModelData& model, ModelReferences& references) {
    if (raw.empty()) return {};
    for (const EmbeddedImage& image : model.images) {
        if (image.name == raw) return raw;
    }
    std::string text = raw.string();
    if (text.starts_with("file://")) text.erase(0, 7);
    text = percent_decoded(text).value_or(text);
    std::replace(text.begin(), text.end(), '\\', '/');
    const std::string last = fs::path(text).filename().string();
    for (const std::string& reference : {text, last, "textures/" + last}) {
        const Result<fs::path> file = references.resolve(reference, "image");
        std::error_code failed;
        if (file && fs::is_regular_file(*file, failed)) return *file;
    }
    return {};
}

void resolve_images(ModelData& model, const std::string& name, ModelReferences& references) {
    for (EmbeddedImage& image : model.images) {
        const fs::path full = fs::path(name) / image.name;
        for (MaterialData& material : model.materials) {
            for (fs::path* map :
                 {&material.base_color_map, &material.normal_map, &material.emissive_map}) {
                if (*map == image.name) *map = full;
            }
        }
        image.name = full;
    }
    for (MaterialData& material : model.materials) {
        for (fs::path* map :
             {&material.base_color_map, &material.normal_map, &material.emissive_map}) {
            const fs::path file = found_image(*map, model, references);
            if (file.empty() && !map->empty()) {
                log_warning("model {}: its image \"{}\" is not beside it; it is left out",
                            name,
                            map->filename().string());
            }
            *map = file;
        }
    }
}

}  // namespace

Result<ModelData> read_foreign(std::string_view bytes, const std::string& name) {
    const ForeignKind kind = kind_of(bytes);
    if (kind == ForeignKind::None) {
        return model_error(name, "its content is neither Collada nor FBX");
    }
    const std::string plain_name = kind == ForeignKind::Fbx ? "model.fbx" : "model.dae";
    const std::string content = kind == ForeignKind::Fbx ? std::string(bytes) : tightened(bytes);
    try {
        Assimp::Importer importer;
        keep_importers(importer, {"Collada Importer", "Autodesk FBX Importer"});
        importer.SetIOHandler(
            std::make_unique<ConfinedIo>(plain_name, content).release());  // it takes over
        importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, false);
        importer.SetPropertyBool(AI_CONFIG_FBX_USE_SKELETON_BONE_CONTAINER, false);
        const aiScene* scene = importer.ReadFile(
            plain_name.c_str(),
            aiProcess_Triangulate | aiProcess_JoinIdenticalVertices | aiProcess_LimitBoneWeights);
        if (scene == nullptr) {
            const std::string_view why = importer.GetErrorString();
            if (why == "std::bad_alloc") throw std::bad_alloc();  // it caught that itself
            return model_error(name, why);
        }
        ModelData model = convert_foreign_scene(*scene, name);
        const std::string fault = fault_of(model);
        if (!fault.empty()) return model_error(name, fault);
        return model;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& fault) {
        return model_error(name, fault.what());
    }
}

ExitCode run_model_worker(const fs::path& file) {
    limit_this_process();
    const std::string name = file.string();
    const auto answer = [&]() -> Result<std::string> {
        try {
            const Result<std::string> bytes = read_file(file, limits::kModelFileBytes);
            if (!bytes) return model_error(name, bytes.error().message);
            const Result<ModelData> model = read_foreign(*bytes, name);
            if (!model) return model.error();
            return bytes_of(*model);
        } catch (const std::bad_alloc&) {
            return model_error(name, "it needs more memory than there is");
        }
    }();
    const char kind = answer ? kModelAnswer : kErrorAnswer;
    const bool written = write_output("-", {&kind, 1}) &&
                         write_output("-", answer ? *answer : answer.error().message);
    return written ? ExitCode::Good : ExitCode::RunFailed;
}

Result<ModelData> import_foreign(const fs::path& file,
                                 std::string_view bytes,
                                 const std::string& name,
                                 ModelReferences& references,
                                 const ForeignReader& reader) {
    if (kind_of(bytes) == ForeignKind::None) {
        return model_error(name, "its content is neither Collada nor FBX");
    }
    const fs::path program = reader.program.empty() ? worker_program() : reader.program;
    if (program.empty())
        return model_error(name, "the program plumbline, which reads it, is not here");
    const Result<ChildOutput> output =
        output_of({.program = program, .arguments = {"model-worker", file.string()}},
                  {},
                  reader.most_bytes,
                  reader.most_s);
    if (!output) return model_error(name, output.error().message);
    if (!output->end.good || output->bytes.empty()) {
        return model_error(
            name,
            fmt::format("its reader {}", output->end.good ? "says nothing" : output->end.words));
    }
    const std::string_view answer = std::string_view(output->bytes).substr(1);
    if (output->bytes.front() != kModelAnswer) {
        return Error{.message = std::string(answer), .exit_code = ExitCode::Refused};
    }
    Result<ModelData> model = model_of_bytes(answer);
    if (!model) return model_error(name, model.error().message);
    resolve_images(*model, name, references);
    return model;
}

}  // namespace plumbline::assets
