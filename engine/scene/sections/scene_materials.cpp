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
    const std::string name = table.text(key, {});
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
                    fmt::format("\"{}\" is of a kind that is not read here; expected {}{}",
                                shown(name),
                                fmt::join(extensions, " "),
                                key == "model" ? " (convert others to glTF)" : ""));
        return {};
    }
    if (!reference->exists) {
        table.warning(key, fmt::format("\"{}\" does not exist; {}", shown(name), instead));
    } else if (!std::filesystem::is_regular_file(reference->file)) {
        table.error(key, fmt::format("\"{}\" is not a regular file", shown(name)));
        return {};
    }
    return *reference;
}

assets::MaterialData read_material(TableReader& table, const LoadContext& context) {
    constexpr std::array<std::string_view, 3> kShadings{"pbr", "blinn_phong", "unlit"};
    constexpr std::array<std::string_view, 3> kAlphaModes{"opaque", "mask", "blend"};
    assets::MaterialData material;
    material.name = table.text("name", {});
    material.shading = static_cast<assets::Shading>(table.choice("shading", 0, kShadings));
    material.base_color = table.color("base_color", material.base_color, kFraction);
    material.alpha = table.single("alpha", 1.0F, kFraction);
    material.ripple_slope = table.single("ripple_slope", 0.0F, kFraction);
    constexpr Range kAttenuation_m{0, 1000, "a length from 0 to 1000 m"};
    constexpr Range kCaustics{0, 20, "a number from 0 to 20"};
    material.attenuation_m = table.single("attenuation_m", 0.0F, kAttenuation_m);
    material.caustics = table.single("caustics", 0.0F, kCaustics);
    if (material.attenuation_m > 0.0F && material.ripple_slope <= 0.0F)
        table.warning("attenuation_m", "needs a ripple_slope above 0; ignored");
    if (material.caustics > 0.0F && material.attenuation_m <= 0.0F)
        table.warning("caustics", "needs an attenuation_m above 0; ignored");
    material.variation = table.single("variation", 0.0F, kFraction);
    material.emissive = table.color("emissive", material.emissive);
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
    material.height_depth = table.single("height_depth", material.height_depth, kDepth);
    if (!material.height_map.empty() && material.normal_map.empty())
        table.warning("height_map", "needs a normal_map; the map is left out");
    material.roughness = table.single("roughness", material.roughness, kFraction);
    material.metallic = table.single("metallic", material.metallic, kFraction);
    constexpr Range kShininess{0, 1000, "an exponent from 0 to 1000"};
    material.shininess = table.single("shininess", material.shininess, kShininess);
    material.specular = table.single("specular", material.specular, kFraction);
    material.diffuse = table.single("diffuse", material.diffuse, kFraction);
    material.white_highlight = table.flag("white_highlight", material.white_highlight);
    warn_of_unused(table, material);
    material.flat = table.flag("flat", material.flat);
    material.alpha_mode =
        static_cast<assets::AlphaMode>(table.choice("alpha_mode", 0, kAlphaModes));
    material.alpha_cutoff = table.single("alpha_cutoff", material.alpha_cutoff, kFraction);
    constexpr Range kIor{1, 4, "an index of refraction from 1 to 4"};
    material.ior = table.single("ior", material.ior, kIor);
    if (material.ior > 0.0F && material.alpha_mode != assets::AlphaMode::Blend)
        table.warning("ior", "needs alpha_mode = \"blend\"; ignored");
    material.two_sided = table.flag("two_sided", false);
    material.surface = table.text("surface", {});
    table.finish();
    return material;
}

}  // namespace plumbline::scene
