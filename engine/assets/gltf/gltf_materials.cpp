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

/// The bytes of an image in a buffer; a fault leaves them empty.
std::string view_bytes(GltfReader& reader, const Json& image, const std::string& where) {
    const auto number = reader.index(image, "bufferView", where, reader.views.size());
    if (reader.failed() || !number) return {};
    const GltfView& view = reader.views[*number];
    return reader.buffers[view.buffer].substr(view.offset, view.size);
}

/// The file of one image, or the name of an embedded one; empty without either.
std::filesystem::path image_file(GltfReader& reader, const Json& image, std::size_t number) {
    const std::string where = fmt::format("images[{}]", number);
    const std::string uri = reader.text(image, "uri", where);
    if (uri.empty() || uri.starts_with("data:")) {
        std::string bytes =
            uri.empty() ? view_bytes(reader, image, where) : data_uri_bytes(reader, uri, where);
        if (reader.failed() || bytes.empty()) return {};
        reader.model.images.push_back(
            {.name = embedded_name(reader, number), .bytes = std::move(bytes)});
        return reader.model.images.back().name;
    }
    const std::optional<std::string> decoded = percent_decoded(uri);
    if (!decoded) {
        reader.fail("{}.uri: \"{}\" has a bad percent escape", where, uri);
        return {};
    }
    if (reader.references.paths_are_of_another_machine()) {
        // Collada's are escaped themselves.
        const std::string place = percent_decoded(*decoded).value_or(*decoded);
        std::filesystem::path found = reader.references.find_image(place);
        if (found.empty()) {
            log_warning("model {}: its image \"{}\" is not beside it; it is left out",
                        reader.name,
                        std::filesystem::path(place).filename().string());
        }
        return found;
    }
    Result<std::filesystem::path> file = reader.references.resolve(*decoded, where + ".uri");
    if (!file) {
        reader.fail("{}", file.error().message);
        return {};
    }
    return std::move(*file);
}

/// What each of "images" is called; see image_file.
std::vector<std::filesystem::path> image_files(GltfReader& reader) {
    std::vector<std::filesystem::path> files;
    std::size_t embedded_bytes = 0;
    const Json& images = reader.objects("images", limits::kReferencedFiles);
    for (std::size_t i = 0; i < images.size() && !reader.failed(); ++i) {
        const std::size_t before = reader.model.images.size();
        files.push_back(image_file(reader, images[i], i));
        if (reader.model.images.size() > before) {
            embedded_bytes += reader.model.images.back().bytes.size();
        }
        if (embedded_bytes > limits::kModelFileBytes) {
            reader.fail("its images have more than {} bytes", limits::kModelFileBytes);
        }
    }
    return files;
}

/// Which image each texture shows.
std::vector<std::filesystem::path> texture_files(GltfReader& reader) {
    const std::vector<std::filesystem::path> images = image_files(reader);
    const Json& textures = reader.objects("textures", kMaxTextures);
    std::vector<std::filesystem::path> files;
    for (std::size_t i = 0; i < textures.size() && !reader.failed(); ++i) {
        const auto image =
            reader.index(textures[i], "source", fmt::format("textures[{}]", i), images.size());
        files.push_back(image ? images[*image] : std::filesystem::path{});
    }
    return files;
}

/// A member that must be an object; nothing when absent.
const Json* object_in(GltfReader& reader,
                      const Json& parent,
                      const char* key,
                      const std::string& where) {
    const auto found = parent.find(key);
    if (found == parent.end()) return nullptr;
    if (found->is_object()) return &*found;
    reader.fail("{}.{} is not an object", where, key);
    return nullptr;
}

std::filesystem::path map_of(GltfReader& reader,
                             const Json& parent,
                             const char* key,
                             const std::string& where,
                             const std::vector<std::filesystem::path>& textures) {
    const Json* slot = object_in(reader, parent, key, where);
    if (slot == nullptr) return {};
    const auto texture = reader.index(*slot, "index", where + "." + key, textures.size());
    return texture ? textures[*texture] : std::filesystem::path{};
}

/// Where and how the base colour map lies on the meshes; our shaders know one set of coordinates.
GltfTexturePlace place_of(GltfReader& reader, const Json* slot, const std::string& where) {
    GltfTexturePlace place;
    if (slot == nullptr) return place;
    place.set = reader.whole(*slot, "texCoord", where).value_or(0);
    const Json* extensions = object_in(reader, *slot, "extensions", where);
    const Json* transform = extensions == nullptr
                                ? nullptr
                                : object_in(reader, *extensions, "KHR_texture_transform", where);
    if (transform == nullptr) return place;
    const std::vector<float> offset = reader.numbers(*transform, "offset", where, 2);
    const std::vector<float> scale = reader.numbers(*transform, "scale", where, 2);
    if (!offset.empty()) place.offset = {offset[0], offset[1]};
    if (!scale.empty()) place.scale = {scale[0], scale[1]};
    place.rotation_rad = reader.number(*transform, "rotation", where, 0.0F);
    place.set = reader.whole(*transform, "texCoord", where).value_or(place.set);
    return place;
}

Vec3f color_of(const std::vector<float>& values, const Vec3f& fallback) {
    if (values.size() < 3) return fallback;
    return glm::max(Vec3f{values[0], values[1], values[2]}, Vec3f{0.0F});
}

void read_alpha(GltfReader& reader,
                const Json& source,
                const std::string& where,
                MaterialData& material) {
    const std::string mode = reader.text(source, "alphaMode", where);
    if (mode == "MASK") material.alpha_mode = AlphaMode::Mask;
    if (mode == "BLEND") material.alpha_mode = AlphaMode::Blend;
    if (!mode.empty() && mode != "MASK" && mode != "BLEND" && mode != "OPAQUE") {
        reader.fail("{}.alphaMode is \"{}\"", where, mode);
    }
    material.alpha_cutoff =
        std::clamp(reader.number(source, "alphaCutoff", where, 0.5F), 0.0F, 1.0F);
    material.two_sided = source.value("doubleSided", Json(false)) == Json(true);
}

void read_extensions(GltfReader& reader,
                     const Json& source,
                     const std::string& where,
                     MaterialData& material) {
    const Json* extensions = object_in(reader, source, "extensions", where);
    if (extensions == nullptr) return;
    if (extensions->contains("KHR_materials_unlit")) material.shading = Shading::Unlit;
    if (const Json* strength = object_in(
            reader, *extensions, "KHR_materials_emissive_strength", where + ".extensions")) {
        const float factor = reader.number(*strength, "emissiveStrength", where, 1.0F);
        material.emissive *= std::max(factor, 0.0F);
    }
    const Json* transmission =
        object_in(reader, *extensions, "KHR_materials_transmission", where + ".extensions");
    if (transmission == nullptr) return;
    const float factor = reader.number(*transmission, "transmissionFactor", where, 0.0F);
    if (factor <= 0.0F) return;
    // Light through the surface is shown as blending; a fifth of the surface stays to be seen.
    material.alpha_mode = AlphaMode::Blend;
    material.alpha *= 1.0F - 0.8F * std::min(factor, 1.0F);
}

/// Metallic and rough, as glTF 2 has it.
const Json* read_metallic(GltfReader& reader,
                          const Json& pbr,
                          const std::string& where,
                          const std::vector<std::filesystem::path>& textures,
                          MaterialData& material) {
    const std::vector<float> base = reader.numbers(pbr, "baseColorFactor", where, 4);
    material.base_color = color_of(base, Vec3f{1.0F});
    if (base.size() == 4) material.alpha = std::clamp(base[3], 0.0F, 1.0F);
    material.base_color_map = map_of(reader, pbr, "baseColorTexture", where, textures);
    material.orm_map = map_of(reader, pbr, "metallicRoughnessTexture", where, textures);
    material.roughness = std::clamp(reader.number(pbr, "roughnessFactor", where, 1.0F), 0.0F, 1.0F);
    material.metallic = std::clamp(reader.number(pbr, "metallicFactor", where, 1.0F), 0.0F, 1.0F);
    return object_in(reader, pbr, "baseColorTexture", where);
}

/// The older way of saying it: a diffuse colour and how smooth it is.
const Json* read_glossy(GltfReader& reader,
                        const Json& glossy,
                        const std::string& where,
                        const std::vector<std::filesystem::path>& textures,
                        MaterialData& material) {
    const std::vector<float> diffuse = reader.numbers(glossy, "diffuseFactor", where, 4);
    material.base_color = color_of(diffuse, Vec3f{1.0F});
    if (diffuse.size() == 4) material.alpha = std::clamp(diffuse[3], 0.0F, 1.0F);
    material.base_color_map = map_of(reader, glossy, "diffuseTexture", where, textures);
    const float smooth = reader.number(glossy, "glossinessFactor", where, 1.0F);
    material.roughness = 1.0F - std::clamp(smooth, 0.0F, 1.0F);
    material.metallic = 0.0F;
    return object_in(reader, glossy, "diffuseTexture", where);
}

/// The base colour map's slot, for its place on the meshes.
const Json* read_surface(GltfReader& reader,
                         const Json& source,
                         const std::string& where,
                         const std::vector<std::filesystem::path>& textures,
                         MaterialData& material) {
    const Json* slot = nullptr;
    if (const Json* pbr = object_in(reader, source, "pbrMetallicRoughness", where)) {
        slot = read_metallic(reader, *pbr, where, textures, material);
    }
    const Json* extensions = object_in(reader, source, "extensions", where);
    if (extensions == nullptr) return slot;
    const Json* glossy =
        object_in(reader, *extensions, "KHR_materials_pbrSpecularGlossiness", where);
    return glossy == nullptr ? slot : read_glossy(reader, *glossy, where, textures, material);
}

MaterialData material_of(GltfReader& reader,
                         const Json& source,
                         const std::string& where,
                         const std::vector<std::filesystem::path>& textures) {
    MaterialData material{.name = reader.text(source, "name", where),
                          .roughness = 1.0F,  // glTF's defaults, not ours
                          .metallic = 1.0F};
    material.emissive = color_of(reader.numbers(source, "emissiveFactor", where, 3), Vec3f{0.0F});
    material.emissive_map = map_of(reader, source, "emissiveTexture", where, textures);
    material.normal_map = map_of(reader, source, "normalTexture", where, textures);
    const Json* slot = read_surface(reader, source, where, textures, material);
    // Red means occlusion only where the file says so; elsewhere it is whatever the tool left.
    const std::filesystem::path occlusion =
        map_of(reader, source, "occlusionTexture", where, textures);
    material.occlusion = !occlusion.empty() && occlusion == material.orm_map ? 1.0F : 0.0F;
    read_alpha(reader, source, where, material);
    read_extensions(reader, source, where, material);
    reader.texture_places.push_back(place_of(reader, slot, where));
    return material;
}

}  // namespace

void read_materials(GltfReader& reader) {
    const std::vector<std::filesystem::path> textures = texture_files(reader);
    const Json& list = reader.objects("materials", limits::kModelMaterials);
    std::set<std::string> names;
    for (std::size_t i = 0; i < list.size() && !reader.failed(); ++i) {
        const std::string where = fmt::format("materials[{}]", i);
        MaterialData material = material_of(reader, list[i], where, textures);
        if (material.name.empty()) material.name = fmt::format("material.{}", i);
        const std::string plain = material.name;
        for (int suffix = 2; !names.insert(material.name).second; ++suffix) {
            material.name = fmt::format("{}.{}", plain, suffix);
        }
        reader.model.materials.push_back(std::move(material));
    }
}

}  // namespace plumbline::assets
