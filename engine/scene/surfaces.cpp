#include "engine/scene/surfaces.h"

#include "engine/core/io/files.h"
#include "engine/core/limits.h"
#include "engine/scene/formats/scene_reader.h"
#include "engine/scene/formats/toml_tree.h"
#include "engine/scene/paths/scene_paths.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline::scene {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kSurfaces = 1'000;
constexpr std::size_t kVariations = 32;

/// Files PREFIX_0.ogg, PREFIX_1.ogg … below the assets folder's sounds, in order.
std::vector<fs::path> variations_of(const fs::path& assets_folder, const std::string& prefix) {
    std::vector<fs::path> files;
    for (std::size_t i = 0; i < kVariations; ++i) {
        const auto reference =
            resolve_inside(assets_folder / "sounds", fmt::format("{}_{}.ogg", prefix, i));
        std::error_code failed;
        if (!reference || !fs::is_regular_file(*reference, failed)) break;
        files.push_back(*reference);
    }
    return files;
}

/// Empty, and the fault is said, where there is no such file.
fs::path sound_file(TableReader& table,
                    std::string_view key,
                    const std::string& name,
                    const fs::path& assets_folder) {
    const auto file = resolve_inside(assets_folder, name);
    std::error_code failed;
    if (!file)
        table.error(key, file.error().message);
    else if (!fs::is_regular_file(*file, failed))
        table.warning(key, "\"{}\" does not exist; left out", shown(name));
    else
        return *file;
    return {};
}

/// A text is a prefix of variations; a list names files below the assets folder one by one.
std::vector<fs::path> read_sounds(TableReader& table,
                                  std::string_view key,
                                  const fs::path& assets_folder) {
    const TomlNode* node = table.find(key);
    if (node == nullptr) return {};
    if (const std::string* prefix = node->text()) {
        if (prefix->empty()) return {};
        auto files = variations_of(assets_folder, *prefix);
        if (files.empty())
            table.warning(key, "no sounds/{}_0.ogg; it stays silent", shown(*prefix));
        return files;
    }
    std::vector<fs::path> files;
    for (const std::string& name : table.texts(key)) {
        const fs::path file = sound_file(table, key, name, assets_folder);
        if (!file.empty()) files.push_back(file);
    }
    return files;
}

/// A loop; empty where there is none.
fs::path read_loop(TableReader& table, std::string_view key, const fs::path& assets_folder) {
    const std::string name = table.text(key);
    return name.empty() ? fs::path{} : sound_file(table, key, name, assets_folder);
}

Surface read_surface(TableReader& table, const std::string& name, const fs::path& assets_folder) {
    constexpr Range kSurfaceFriction{0, 10, "a coefficient from 0 to 10"};
    constexpr Range kDensity{1e-3, 1e5, "kg/m3 from 0.001 to 100000"};
    Surface surface;
    surface.name = name;
    table.read("friction", surface.friction, kSurfaceFriction);
    table.read("restitution", surface.restitution, kFraction);
    table.read("density_kgpm3", surface.density_kgpm3, kDensity);
    surface.impact_sounds = read_sounds(table, "impact_sounds", assets_folder);
    surface.step_sounds = read_sounds(table, "step_sounds", assets_folder);
    surface.roll_sound = read_loop(table, "roll_sound", assets_folder);
    surface.scrape_sound = read_loop(table, "scrape_sound", assets_folder);
    surface.creak_sound = read_loop(table, "creak_sound", assets_folder);
    table.read("loudness", surface.loudness, kGain);
    table.read("absorption", surface.absorption, kFraction);
    table.read("caption", surface.caption);
    table.finish();
    return surface;
}

}  // namespace

std::uint16_t SurfaceTable::find(std::string_view name) const {
    const auto at = std::ranges::find(surfaces, name, &Surface::name);
    return at == surfaces.end() ? std::uint16_t{0}
                                : static_cast<std::uint16_t>(at - surfaces.begin());
}

SurfaceTable load_surfaces(const fs::path& file, const fs::path& assets_folder, Diagnostics& out) {
    SurfaceTable table;
    table.surfaces.push_back(Surface{.name = "default"});
    FaultList faults(out);
    const SourceLocation whole = in_file(file.string());
    const Result<std::string> text = read_file(file, limits::kConfigFileBytes);
    if (!text) {
        faults.error(whole, {}, text.error().message + "; every surface is the default");
        return table;
    }
    const auto parsed = parse_toml(*text, whole.file);
    if (const auto* fault = std::get_if<TextFault>(&parsed)) {
        faults.error({whole.file, fault->line, fault->column},
                     {},
                     fault->message + "; every surface is the default");
        return table;
    }
    const TomlNode& root = *std::get_if<TomlNode>(&parsed);
    for (const TomlEntry& entry : *root.table()) {
        if (entry.node.table() == nullptr) {
            faults.error(entry.key_location,
                         shown(entry.key),
                         found(entry.node) + "; expected a table, [NAME], for each surface");
            continue;
        }
        if (table.surfaces.size() >= kSurfaces) {
            faults.error(
                entry.key_location, shown(entry.key), "more than {} surfaces; left out", kSurfaces);
            break;
        }
        TableReader reader(entry.node, shown(entry.key), faults);
        Surface surface = read_surface(reader, entry.key, assets_folder);
        if (entry.key == "default")
            table.surfaces.front() = std::move(surface);
        else
            table.surfaces.push_back(std::move(surface));
    }
    return table;
}

}  // namespace plumbline::scene
