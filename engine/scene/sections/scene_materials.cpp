#include "engine/core/text/text_case.h"
#include "engine/scene/sections/scene_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace plumbline::scene {
namespace {

constexpr std::array<std::string_view, 4> kImages{".jpg", ".jpeg", ".png", ".exr"};

std::filesystem::path read_map(TableReader& table,
                               std::string_view key,
                               std::string_view instead,
                               const LoadContext& context) {
    const auto image = read_file_reference(table, key, kImages, instead, context);
    return image ? image->file : std::filesystem::path{};
}

void warn_of_unused(TableReader& table, const assets::MaterialData& material) {
    if (material.shading == assets::Shading::BlinnPhong && material.shininess > 0) return;
    for (const std::string_view key : {"diffuse", "white_highlight"}) {
        if (table.has(key))
            table.warning(key, "needs shading = \"blinn_phong\" and a shininess above 0; ignored");
    }
}

}  // namespace

std::optional<Reference> read_file_reference(TableReader& table,
                                             std::string_view key,
                                             std::span<const std::string_view> extensions,
                                             std::string_view instead,
                                             const LoadContext& context) {
    const std::string name = table.text(key);
    const TomlNode* node = table.find(key);
    if (node == nullptr || node->text() == nullptr) return {};
    const Result<Reference>& reference = context.reference(*node);
    if (!reference) {
        table.error(key, reference.error().message);
        return {};
    }
    const std::string extension = std::filesystem::path(name).extension().string();
    if (std::ranges::find(extensions, to_lower(extension)) == extensions.end()) {
        table.error(key,
                    "\"{}\" is of a kind that is not read here; expected {}{}",
                    shown(name),
                    fmt::join(extensions, " "),
                    key == "model" ? " (convert others to glTF)" : "");
        return {};
    }
    if (!reference->exists) {
        table.warning(key, "\"{}\" does not exist; {}", shown(name), instead);
    } else if (!std::filesystem::is_regular_file(reference->file)) {
        table.error(key, "\"{}\" is not a regular file", shown(name));
        return {};
    }
    return *reference;
}

std::filesystem::path read_sound_file(TableReader& table,
                                      const char* key,
                                      const LoadContext& context) {
    table.require(key, "a sound file");
    const auto file = read_file_reference(table, key, kSoundExtensions, "it stays silent", context);
    return file && file->exists ? file->file : std::filesystem::path{};
}

assets::MaterialData read_material(TableReader& table, const LoadContext& context) {
    assets::MaterialData material;
    table.read("name", material.name);
    table.read_choice("shading", material.shading, {"pbr", "blinn_phong", "unlit"});
    table.read_color("base_color", material.base_color, kFraction);
    table.read("alpha", material.alpha, kFraction);
    table.read("ripple_slope", material.ripple_slope, kFraction);
    table.read("attenuation_m", material.attenuation_m, {0, 1000, "a length from 0 to 1000 m"});
    table.read("caustics", material.caustics, {0, 20, "a number from 0 to 20"});
    if (material.attenuation_m > 0.0F && material.ripple_slope <= 0.0F)
        table.warning("attenuation_m", "needs a ripple_slope above 0; ignored");
    if (material.caustics > 0.0F && material.attenuation_m <= 0.0F)
        table.warning("caustics", "needs an attenuation_m above 0; ignored");
    table.read("variation", material.variation, kFraction);
    table.read_color("emissive", material.emissive);
    material.base_color_map =
        read_map(table, "base_color_map", "a chequered image stands in", context);
    // Without these maps a surface is merely smoother.
    constexpr std::string_view kLeftOut = "the map is left out";
    material.normal_map = read_map(table, "normal_map", kLeftOut, context);
    material.orm_map = read_map(table, "orm_map", kLeftOut, context);
    material.height_map = read_map(table, "height_map", kLeftOut, context);
    for (auto* map : {&material.normal_map, &material.orm_map, &material.height_map}) {
        std::error_code failed;
        if (!map->empty() && !std::filesystem::exists(*map, failed)) map->clear();
    }
    constexpr Range kDepth{0, 0.2, "a share of the map's width from 0 to 0.2"};
    table.read("height_depth", material.height_depth, kDepth);
    if (!material.height_map.empty() && material.normal_map.empty())
        table.warning("height_map", "needs a normal_map; the map is left out");
    table.read("roughness", material.roughness, kFraction);
    table.read("metallic", material.metallic, kFraction);
    table.read("shininess", material.shininess, {0, 1000, "an exponent from 0 to 1000"});
    table.read("specular", material.specular, kFraction);
    table.read("diffuse", material.diffuse, kFraction);
    table.read("white_highlight", material.white_highlight);
    warn_of_unused(table, material);
    table.read("flat", material.flat);
    table.read_choice("alpha_mode", material.alpha_mode, {"opaque", "mask", "blend"});
    table.read("alpha_cutoff", material.alpha_cutoff, kFraction);
    table.read("ior", material.ior, {1, 4, "an index of refraction from 1 to 4"});
    if (material.ior > 0.0F && material.alpha_mode != assets::AlphaMode::Blend)
        table.warning("ior", "needs alpha_mode = \"blend\"; ignored");
    table.read("two_sided", material.two_sided);
    table.read("surface", material.surface);
    table.finish();
    return material;
}

}  // namespace plumbline::scene
