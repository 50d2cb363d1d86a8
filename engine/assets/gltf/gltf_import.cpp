#include "engine/assets/gltf/gltf_reader_impl.h"
#include "engine/core/log.h"

#include <algorithm>
#include <array>
#include <exception>

namespace plumbline::assets {
namespace {

/// What a file may demand of its reader. All else it may use, but not require.
constexpr std::array<std::string_view, 7> kExtensions{"KHR_materials_unlit",
                                                      "KHR_materials_transmission",
                                                      "KHR_materials_emissive_strength",
                                                      "KHR_materials_pbrSpecularGlossiness",
                                                      "KHR_texture_transform",
                                                      "KHR_mesh_quantization",
                                                      "FB_ngon_encoding"};  // triangles as they are

bool is_known(std::string_view extension) {
    return std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end();
}

void read_head(GltfReader& reader) {
    const auto asset = reader.document.find("asset");
    if (asset == reader.document.end() || !asset->is_object()) {
        reader.fail("it has no \"asset\"; it is not glTF 2");
        return;
    }
    const std::string version = reader.text(*asset, "version", "asset");
    if (!version.starts_with("2.")) {
        reader.fail("it is glTF version \"{}\"; 2 is read", version);
        return;
    }
    for (const Json& required : reader.array(reader.document, "extensionsRequired", "")) {
        const auto* name = required.get_ptr<const std::string*>();
        if (name == nullptr || !is_known(*name)) {
            reader.fail("it requires the extension {}, which is not read", required.dump());
        }
    }
    for (const Json& used : reader.array(reader.document, "extensionsUsed", "")) {
        const auto* name = used.get_ptr<const std::string*>();
        if (name == nullptr || is_known(*name) || reader.failed()) continue;
        // A finer look of materials is no loss worth a line at every start.
        const LogLevel level =
            name->starts_with("KHR_materials_") ? LogLevel::Debug : LogLevel::Warning;
        log_line(level, fmt::format("model {}: the extension {} is ignored", reader.name, *name));
    }
}

Result<ModelData> read_document(const Json& document,
                                std::optional<std::string_view> binary,
                                const std::string& name,
                                ModelReferences& references) {
    GltfReader reader{.document = document, .name = name, .references = references};
    const auto stage = [&](auto read) {
        if (!reader.failed()) read();
    };
    stage([&] { read_head(reader); });
    stage([&] { read_buffers(reader, binary); });
    stage([&] { read_views(reader); });
    stage([&] { read_accessors(reader); });
    stage([&] { read_materials(reader); });
    stage([&] { read_meshes(reader); });
    stage([&] { read_nodes(reader); });
    stage([&] { read_skins(reader); });
    stage([&] { read_animations(reader); });
    if (reader.failed()) return model_error(name, reader.fault);
    return std::move(reader.model);
}

}  // namespace

Result<ModelData> read_gltf(std::string_view bytes,
                            const std::string& name,
                            ModelReferences& references) {
    const Result<GltfParts> parts = split_gltf(bytes, name);
    if (!parts) return parts.error();
    const Result<Json> document = parse_json(parts->json, name);
    if (!document) return document.error();
    try {
        return read_document(*document, parts->binary, name, references);
    } catch (const std::exception& thrown) {
        return model_error(name, thrown.what());
    }
}

}  // namespace plumbline::assets
