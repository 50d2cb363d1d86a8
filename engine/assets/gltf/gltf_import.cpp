#include "engine/assets/gltf/gltf_reader_impl.h"
#include "engine/core/log.h"

#include <algorithm>
#include <array>
#include <exception>

namespace plumbline::assets {
namespace {

/// What a file may demand of its reader. All else it may use, but not require.
constexpr std::array<std::string_view, 11> kExtensions{"KHR_materials_unlit",
                                                       "KHR_materials_transmission",
                                                       "KHR_materials_emissive_strength",
                                                       "KHR_materials_pbrSpecularGlossiness",
                                                       "KHR_texture_transform",
                                                       "KHR_mesh_quantization",
                                                       "FB_ngon_encoding",  // triangles as they are
                                                       "KHR_implicit_shapes",
                                                       "KHR_physics_rigid_bodies",
                                                       "KHR_collision_shapes",
                                                       "KHR_rigid_bodies"};

/// What it may demand as well, though we leave it out: the rest is worth showing without.
constexpr std::string_view kLights = "KHR_lights_punctual";

bool is_known(std::string_view extension) {
    return std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end();
}

void read_head(const GltfReader& reader) {
    const auto asset = reader.root.json.find("asset");
    if (asset == reader.root.json.end() || !asset->is_object()) {
        fail("it has no \"asset\"; it is not glTF 2");
    }
    const std::string version = GltfObject{.json = *asset, .where = "asset"}.text("version");
    if (!version.starts_with("2.")) fail("it is glTF version \"{}\"; 2 is read", version);
    for (const Json& required : reader.root.array("extensionsRequired")) {
        const auto* name = required.get_ptr<const std::string*>();
        if (name == nullptr || (*name != kLights && !is_known(*name))) {
            fail("it requires the extension {}, which is not read", required.dump());
        }
    }
    for (const Json& used : reader.root.array("extensionsUsed")) {
        const auto* name = used.get_ptr<const std::string*>();
        if (name == nullptr || is_known(*name)) continue;
        // A finer look of materials is no loss worth a line at every start.
        const LogLevel level =
            name->starts_with("KHR_materials_") ? LogLevel::Debug : LogLevel::Warning;
        log_line(level, fmt::format("model {}: the extension {} is ignored", reader.name, *name));
    }
}

}  // namespace

Result<ModelData> read_gltf(std::string_view bytes,
                            const std::string& name,
                            ModelReferences& references) {
    try {
        const GltfParts parts = split_gltf(bytes, name);
        const Json document = parse_json(parts.json);
        GltfReader reader{
            .root = {.json = document, .where = {}}, .name = name, .references = references};
        read_head(reader);
        read_buffers(reader, parts.binary);
        read_views(reader);
        read_accessors(reader);
        read_materials(reader);
        read_meshes(reader);
        read_nodes(reader);
        read_skins(reader);
        read_animations(reader);
        read_physics(reader);
        return std::move(reader.model);
    } catch (const ModelFault& fault) {
        return model_error(name, fault.words);
    } catch (const std::exception& thrown) {
        return model_error(name, thrown.what());
    }
}

}  // namespace plumbline::assets
