#include "engine/assets/gltf_check_impl.h"
#include "engine/core/limits.h"
#include "engine/core/log.h"

#include <algorithm>

namespace plumbline::assets {
namespace {

constexpr std::size_t kMaxTextures = 16'384;

/// The files behind "images"; empty for images inside buffers, which are not read.
std::vector<std::filesystem::path> image_files(GltfCheck& check) {
    std::vector<std::filesystem::path> files;
    const Json& images = check.objects("images", limits::kReferencedFiles);
    std::size_t embedded = 0;
    for (std::size_t i = 0; i < images.size() && !check.failed(); ++i) {
        files.emplace_back();
        const std::string where = fmt::format("images[{}]", i);
        const std::string uri = check.text(images[i], "uri", where);
        if (uri.empty() || uri.starts_with("data:")) {
            ++embedded;
            continue;
        }
        const std::optional<std::string> decoded = percent_decoded(uri);
        if (!decoded) {
            check.fail("{}.uri: \"{}\" has a bad percent escape", where, uri);
            return files;
        }
        Result<std::filesystem::path> file = check.references.resolve(*decoded, where + ".uri");
        if (!file) {
            check.fail("{}", file.error().message);
            return files;
        }
        files.back() = std::move(*file);
    }
    if (embedded > 0) {
        log_warning("model {}: {} embedded images are not read; keep images in files of their own",
                    check.name,
                    embedded);
    }
    return files;
}

/// Which image each texture shows.
std::vector<std::filesystem::path> texture_files(GltfCheck& check) {
    const std::vector<std::filesystem::path> images = image_files(check);
    const Json& textures = check.objects("textures", kMaxTextures);
    std::vector<std::filesystem::path> files;
    for (std::size_t i = 0; i < textures.size() && !check.failed(); ++i) {
        const auto image =
            check.index(textures[i], "source", fmt::format("textures[{}]", i), images.size());
        files.push_back(image ? images[*image] : std::filesystem::path{});
    }
    return files;
}

/// A member that must be an object; nothing when absent.
const Json* object_in(GltfCheck& check,
                      const Json& parent,
                      const char* key,
                      const std::string& where) {
    const auto found = parent.find(key);
    if (found == parent.end()) return nullptr;
    if (found->is_object()) return &*found;
    check.fail("{}.{} is not an object", where, key);
    return nullptr;
}

std::filesystem::path map_of(GltfCheck& check,
                             const Json& parent,
                             const char* key,
                             const std::string& where,
                             const std::vector<std::filesystem::path>& textures) {
    const Json* slot = object_in(check, parent, key, where);
    if (slot == nullptr) return {};
    const auto texture = check.index(*slot, "index", where + "." + key, textures.size());
    return texture ? textures[*texture] : std::filesystem::path{};
}

Vec3f color_of(const std::vector<float>& values, const Vec3f& fallback) {
    if (values.size() < 3) return fallback;
    return glm::max(Vec3f{values[0], values[1], values[2]}, Vec3f{0.0F});
}

void read_alpha(GltfCheck& check,
                const Json& source,
                const std::string& where,
                MaterialData& material) {
    const std::string mode = check.text(source, "alphaMode", where);
    if (mode == "MASK") material.alpha_mode = AlphaMode::Mask;
    if (mode == "BLEND") material.alpha_mode = AlphaMode::Blend;
    if (!mode.empty() && mode != "MASK" && mode != "BLEND" && mode != "OPAQUE") {
        check.fail("{}.alphaMode is \"{}\"", where, mode);
    }
    material.alpha_cutoff =
        std::clamp(check.number(source, "alphaCutoff", where, 0.5F), 0.0F, 1.0F);
    material.two_sided = source.value("doubleSided", Json(false)) == Json(true);
}

void read_extensions(GltfCheck& check,
                     const Json& source,
                     const std::string& where,
                     MaterialData& material) {
    const Json* extensions = object_in(check, source, "extensions", where);
    if (extensions == nullptr) return;
    if (extensions->contains("KHR_materials_unlit")) material.shading = Shading::Unlit;
    const Json* transmission =
        object_in(check, *extensions, "KHR_materials_transmission", where + ".extensions");
    if (transmission == nullptr) return;
    const float factor = check.number(*transmission, "transmissionFactor", where, 0.0F);
    if (factor <= 0.0F) return;
    // Light through the surface is shown as blending; a fifth of the surface stays to be seen.
    material.alpha_mode = AlphaMode::Blend;
    material.alpha *= 1.0F - 0.8F * std::min(factor, 1.0F);
}

MaterialData material_of(GltfCheck& check,
                         const Json& source,
                         const std::string& where,
                         const std::vector<std::filesystem::path>& textures) {
    MaterialData material{.name = check.text(source, "name", where),
                          .roughness = 1.0F,  // glTF's defaults, not ours
                          .metallic = 1.0F};
    material.emissive = color_of(check.numbers(source, "emissiveFactor", where, 3), Vec3f{0.0F});
    material.normal_map = map_of(check, source, "normalTexture", where, textures);
    if (const Json* pbr = object_in(check, source, "pbrMetallicRoughness", where)) {
        const std::vector<float> base = check.numbers(*pbr, "baseColorFactor", where, 4);
        material.base_color = color_of(base, Vec3f{1.0F});
        if (base.size() == 4) material.alpha = std::clamp(base[3], 0.0F, 1.0F);
        material.base_color_map = map_of(check, *pbr, "baseColorTexture", where, textures);
        material.orm_map = map_of(check, *pbr, "metallicRoughnessTexture", where, textures);
        material.roughness =
            std::clamp(check.number(*pbr, "roughnessFactor", where, 1.0F), 0.0F, 1.0F);
        material.metallic =
            std::clamp(check.number(*pbr, "metallicFactor", where, 1.0F), 0.0F, 1.0F);
    }
    read_alpha(check, source, where, material);
    read_extensions(check, source, where, material);
    return material;
}

}  // namespace

void check_materials(GltfCheck& check) {
    const std::vector<std::filesystem::path> textures = texture_files(check);
    const Json& list = check.objects("materials", limits::kModelMaterials);
    std::set<std::string> names;
    for (std::size_t i = 0; i < list.size() && !check.failed(); ++i) {
        const std::string where = fmt::format("materials[{}]", i);
        MaterialData material = material_of(check, list[i], where, textures);
        if (material.name.empty()) material.name = fmt::format("material.{}", i);
        const std::string plain = material.name;
        for (int suffix = 2; !names.insert(material.name).second; ++suffix) {
            material.name = fmt::format("{}.{}", plain, suffix);
        }
        // By number, so that names stay ours: see CheckedModel::materials.
        check.clean["materials"].push_back(Json{{"name", fmt::format("{}", i)}});
        check.materials.push_back(std::move(material));
    }
}

}  // namespace plumbline::assets
