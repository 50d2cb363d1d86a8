#include "engine/assets/gltf/gltf_reader_impl.h"
#include "engine/core/limits.h"
#include "engine/core/log.h"

#include <algorithm>
#include <utility>

namespace plumbline::assets {
namespace {

constexpr std::size_t kMaxTextures = 16'384;

/// What an image of the file is called: in a folder of the file's own, which no real file is in.
std::filesystem::path embedded_name(const GltfReader& reader, std::size_t number) {
    return std::filesystem::path(reader.name) / fmt::format("image {}", number);
}

/// The bytes of an image in a buffer; none where it names none.
std::string view_bytes(const GltfReader& reader, const GltfObject& image) {
    const auto number = image.index("bufferView", reader.views.size());
    if (!number) return {};
    const GltfView& view = reader.views[*number];
    return reader.buffers[view.buffer].substr(view.offset, view.size);
}

/// The file of one image, or the name of an embedded one; empty without either.
std::filesystem::path image_file(GltfReader& reader, const GltfObject& image, std::size_t number) {
    const std::string uri = image.text("uri");
    if (uri.empty() || uri.starts_with("data:")) {
        std::string bytes =
            uri.empty() ? view_bytes(reader, image) : data_uri_bytes(uri, image.where);
        if (bytes.empty()) return {};
        reader.model.images.push_back(
            {.name = embedded_name(reader, number), .bytes = std::move(bytes)});
        return reader.model.images.back().name;
    }
    const std::string decoded = decoded_uri(uri, image.where);
    if (!reader.references.paths_are_of_another_machine()) {
        return resolved(reader, decoded, image.where);
    }
    // Collada's are escaped themselves.
    const std::string place = percent_decoded(decoded).value_or(decoded);
    std::filesystem::path found = reader.references.find_image(place);
    if (found.empty()) {
        log_warning("model {}: its image \"{}\" is not beside it; it is left out",
                    reader.name,
                    std::filesystem::path(place).filename().string());
    }
    return found;
}

/// What each of "images" is called; see image_file.
std::vector<std::filesystem::path> image_files(GltfReader& reader) {
    std::vector<std::filesystem::path> files;
    std::size_t embedded_bytes = 0;
    for (const GltfObject& image : reader.objects("images", limits::kReferencedFiles)) {
        const std::size_t before = reader.model.images.size();
        files.push_back(image_file(reader, image, files.size()));
        if (reader.model.images.size() > before) {
            embedded_bytes += reader.model.images.back().bytes.size();
        }
        if (embedded_bytes > limits::kModelFileBytes) {
            fail("its images have more than {} bytes", limits::kModelFileBytes);
        }
    }
    return files;
}

using TextureFiles = std::vector<std::filesystem::path>;

/// Which image each texture shows.
TextureFiles texture_files(GltfReader& reader) {
    const std::vector<std::filesystem::path> images = image_files(reader);
    TextureFiles files;
    for (const GltfObject& texture : reader.objects("textures", kMaxTextures)) {
        const auto image = texture.index("source", images.size());
        files.push_back(image ? images[*image] : std::filesystem::path{});
    }
    return files;
}

std::filesystem::path map_of(const GltfObject& parent,
                             const char* key,
                             const TextureFiles& textures) {
    const auto slot = parent.object(key);
    if (!slot) return {};
    const GltfObject named{.json = slot->json, .where = parent.where + "." + key};
    const auto texture = named.index("index", textures.size());
    return texture ? textures[*texture] : std::filesystem::path{};
}

/// Where and how the base colour map lies on the meshes; our shaders know one set of coordinates.
GltfTexturePlace place_of(const std::optional<GltfObject>& slot) {
    GltfTexturePlace place;
    if (!slot) return place;
    place.set = slot->whole("texCoord").value_or(0);
    const auto extensions = slot->object("extensions");
    if (!extensions) return place;
    const auto transform = extensions->object("KHR_texture_transform");
    if (!transform) return place;
    const std::vector<float> offset = transform->numbers("offset", 2);
    const std::vector<float> scale = transform->numbers("scale", 2);
    if (!offset.empty()) place.offset = {offset[0], offset[1]};
    if (!scale.empty()) place.scale = {scale[0], scale[1]};
    place.rotation_rad = transform->number("rotation", 0.0F);
    place.set = transform->whole("texCoord").value_or(place.set);
    return place;
}

Vec3f color_of(const std::vector<float>& values, const Vec3f& fallback) {
    if (values.size() < 3) return fallback;
    return glm::max(Vec3f{values[0], values[1], values[2]}, Vec3f{0.0F});
}

/// A number from 0 to 1.
float share_of(const GltfObject& source, const char* key, float fallback) {
    return std::clamp(source.number(key, fallback), 0.0F, 1.0F);
}

void read_alpha(const GltfObject& source, MaterialData& material) {
    const std::string mode = source.text("alphaMode");
    if (mode == "MASK") material.alpha_mode = AlphaMode::Mask;
    if (mode == "BLEND") material.alpha_mode = AlphaMode::Blend;
    if (!mode.empty() && mode != "MASK" && mode != "BLEND" && mode != "OPAQUE") {
        fail("{}.alphaMode is \"{}\"", source.where, mode);
    }
    material.alpha_cutoff = share_of(source, "alphaCutoff", 0.5F);
    material.two_sided = source.json.value("doubleSided", Json(false)) == Json(true);
}

void read_extensions(const GltfObject& source, MaterialData& material) {
    const auto extensions = source.object("extensions");
    if (!extensions) return;
    if (extensions->json.contains("KHR_materials_unlit")) material.shading = Shading::Unlit;
    const auto number_in = [&](const char* extension, const char* key, float fallback) {
        const GltfObject named{.json = extensions->json, .where = source.where + ".extensions"};
        const auto found = named.object(extension);
        if (!found) return fallback;
        return GltfObject{.json = found->json, .where = source.where}.number(key, fallback);
    };
    const float emission = number_in("KHR_materials_emissive_strength", "emissiveStrength", 1.0F);
    material.emissive *= std::max(emission, 0.0F);
    const float factor = number_in("KHR_materials_transmission", "transmissionFactor", 0.0F);
    if (factor <= 0.0F) return;
    // Light through the surface is shown as blending; a fifth of the surface stays to be seen.
    material.alpha_mode = AlphaMode::Blend;
    material.alpha *= 1.0F - 0.8F * std::min(factor, 1.0F);
}

/// The base colour and its map.
void read_color(const GltfObject& source,
                const char* factor,
                const char* map,
                const TextureFiles& textures,
                MaterialData& material) {
    const std::vector<float> color = source.numbers(factor, 4);
    material.base_color = color_of(color, Vec3f{1.0F});
    if (color.size() == 4) material.alpha = std::clamp(color[3], 0.0F, 1.0F);
    material.base_color_map = map_of(source, map, textures);
}

/// The base colour map's slot, for its place on the meshes.
std::optional<GltfObject> read_surface(const GltfObject& source,
                                       const TextureFiles& textures,
                                       MaterialData& material) {
    const auto pbr = source.object("pbrMetallicRoughness");
    if (pbr) {
        read_color(*pbr, "baseColorFactor", "baseColorTexture", textures, material);
        material.orm_map = map_of(*pbr, "metallicRoughnessTexture", textures);
        material.roughness = share_of(*pbr, "roughnessFactor", 1.0F);
        material.metallic = share_of(*pbr, "metallicFactor", 1.0F);
    }
    // The older way of saying it: a diffuse colour and how smooth it is.
    const auto extensions = source.object("extensions");
    const auto glossy = extensions ? extensions->object("KHR_materials_pbrSpecularGlossiness")
                                   : std::optional<GltfObject>{};
    if (!glossy) return pbr ? pbr->object("baseColorTexture") : std::nullopt;
    read_color(*glossy, "diffuseFactor", "diffuseTexture", textures, material);
    material.roughness = 1.0F - share_of(*glossy, "glossinessFactor", 1.0F);
    material.metallic = 0.0F;
    return glossy->object("diffuseTexture");
}

MaterialData material_of(GltfReader& reader,
                         const GltfObject& source,
                         const TextureFiles& textures) {
    MaterialData material{.name = source.text("name"),
                          .roughness = 1.0F,  // glTF's defaults, not ours
                          .metallic = 1.0F};
    material.emissive = color_of(source.numbers("emissiveFactor", 3), Vec3f{0.0F});
    material.emissive_map = map_of(source, "emissiveTexture", textures);
    material.normal_map = map_of(source, "normalTexture", textures);
    const auto slot = read_surface(source, textures, material);
    // Red means occlusion only where the file says so; elsewhere it is whatever the tool left.
    const std::filesystem::path occlusion = map_of(source, "occlusionTexture", textures);
    material.occlusion = !occlusion.empty() && occlusion == material.orm_map ? 1.0F : 0.0F;
    read_alpha(source, material);
    read_extensions(source, material);
    reader.texture_places.push_back(place_of(slot));
    return material;
}

}  // namespace

void read_materials(GltfReader& reader) {
    const TextureFiles textures = texture_files(reader);
    std::set<std::string> names;
    for (const GltfObject& source : reader.objects("materials", limits::kModelMaterials)) {
        MaterialData material = material_of(reader, source, textures);
        if (material.name.empty())
            material.name = fmt::format("material.{}", reader.model.materials.size());
        const std::string plain = material.name;
        for (int suffix = 2; !names.insert(material.name).second; ++suffix) {
            material.name = fmt::format("{}.{}", plain, suffix);
        }
        reader.model.materials.push_back(std::move(material));
    }
}

}  // namespace plumbline::assets
