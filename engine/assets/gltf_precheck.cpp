#include "engine/assets/gltf_check_impl.h"
#include "engine/core/log.h"

#include <algorithm>
#include <array>
#include <exception>

namespace plumbline::assets {
namespace {

/// What a file may demand of its reader. All else it may use, but not require.
constexpr std::array<std::string_view, 2> kExtensions{"KHR_materials_unlit",
                                                      "KHR_materials_transmission"};

bool is_known(std::string_view extension) {
    return std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end();
}

void check_head(GltfCheck& check) {
    const auto asset = check.document.find("asset");
    if (asset == check.document.end() || !asset->is_object()) {
        check.fail("it has no \"asset\"; it is not glTF 2");
        return;
    }
    const std::string version = check.text(*asset, "version", "asset");
    if (!version.starts_with("2.")) {
        check.fail("it is glTF version \"{}\"; 2 is read", version);
        return;
    }
    for (const Json& required : check.array(check.document, "extensionsRequired", "")) {
        const auto* name = required.get_ptr<const std::string*>();
        if (name == nullptr || !is_known(*name)) {
            check.fail("it requires the extension {}, which is not read", required.dump());
        }
    }
    for (const Json& used : check.array(check.document, "extensionsUsed", "")) {
        const auto* name = used.get_ptr<const std::string*>();
        if (name == nullptr || is_known(*name) || check.failed()) continue;
        // A finer look of materials is no loss worth a line at every start.
        const LogLevel level =
            name->starts_with("KHR_materials_") ? LogLevel::Debug : LogLevel::Warning;
        log_line(level, fmt::format("model {}: the extension {} is ignored", check.name, *name));
    }
}

Result<CheckedModel> check_document(const Json& document,
                                    std::optional<std::string_view> binary,
                                    const std::string& name,
                                    ModelReferences& references) {
    GltfCheck check{.document = document, .name = name, .references = references};
    check.clean = Json{{"asset", {{"version", "2.0"}}}};
    check_head(check);
    if (!check.failed()) check_buffers(check, binary);
    if (!check.failed()) check_views(check);
    if (!check.failed()) check_accessors(check);
    if (!check.failed()) check_materials(check);
    if (!check.failed()) check_meshes(check);
    if (!check.failed()) check_nodes(check);
    if (check.failed()) return model_error(name, check.fault);

    CheckedModel model{.main_name = "model.gltf"};
    for (std::size_t i = 0; i < check.buffers.size(); ++i) {
        model.files.emplace(fmt::format("buffer{}.bin", i), std::move(check.buffers[i]));
    }
    model.files.emplace(model.main_name, check.clean.dump());
    model.materials = std::move(check.materials);
    return model;
}

}  // namespace

Result<CheckedModel> check_gltf(std::string_view bytes,
                                const std::string& name,
                                ModelReferences& references) {
    const Result<GltfParts> parts = split_gltf(bytes, name);
    if (!parts) return parts.error();
    const Result<Json> document = parse_json(parts->json, name);
    if (!document) return document.error();
    try {
        return check_document(*document, parts->binary, name, references);
    } catch (const std::exception& thrown) {
        return model_error(name, thrown.what());
    }
}

}  // namespace plumbline::assets
