#include "engine/assets/mesh_files/text_words_impl.h"
#include "engine/assets/model/model_readers_impl.h"
#include "engine/core/io/files.h"
#include "engine/core/limits.h"
#include "engine/core/log.h"
#include "engine/core/text/printable.h"
#include "engine/core/text/text_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace plumbline::assets {
namespace {

namespace fs = std::filesystem;

/// Options that stand before a map's file name, and how many words follow each.
constexpr std::array<std::pair<std::string_view, int>, 13> kMapOptions{{{"-blendu", 1},
                                                                        {"-blendv", 1},
                                                                        {"-boost", 1},
                                                                        {"-mm", 2},
                                                                        {"-o", 3},
                                                                        {"-s", 3},
                                                                        {"-t", 3},
                                                                        {"-texres", 1},
                                                                        {"-clamp", 1},
                                                                        {"-bm", 1},
                                                                        {"-imfchan", 1},
                                                                        {"-type", 1},
                                                                        {"-cc", 1}}};

/// The rest of a map line is the file's name, spaces and all, once the options are off.
std::string map_name(std::string_view line) {
    line = trimmed(line);
    while (line.starts_with('-')) {
        std::string_view rest = line;
        const std::string_view word = next_word(rest);
        const auto option = std::find_if(kMapOptions.begin(),
                                         kMapOptions.end(),
                                         [&](const auto& known) { return known.first == word; });
        if (option == kMapOptions.end()) break;  // a name that begins with a dash
        // -o, -s and -t take one to three numbers.
        for (int i = 0; i < option->second; ++i) {
            std::string_view after = rest;
            const std::string_view argument = next_word(after);
            if (i > 0 && !finite_number(argument)) break;
            rest = after;
        }
        line = rest;
    }
    std::string name(line);
    std::replace(name.begin(), name.end(), '\\', '/');
    return name;
}

/// One .mtl being read.
struct MtlReader {
    const fs::path& file;
    const std::string& name;
    ModelReferences& references;
    std::vector<MaterialData> materials{};

    MaterialData& current() { return materials.back(); }

    /// Relative to the .mtl, or where that has no such file, to the model.
    fs::path map(std::string_view line, std::string_view key) {
        const std::string reference = map_name(line);
        if (reference.empty()) return {};
        const std::string field = fmt::format("{} of material \"{}\"", key, current().name);
        const Result<fs::path> beside = references.resolve(reference, field, file.parent_path());
        if (!beside) fail("{}", beside.error().message);
        std::error_code ignored;
        if (fs::exists(*beside, ignored)) return *beside;
        const Result<fs::path> elsewhere = references.resolve(reference, field);
        return elsewhere && fs::exists(*elsewhere, ignored) ? *elsewhere : *beside;
    }

    static float number(std::string_view line, float fallback) {
        return finite_number(next_word(line)).value_or(fallback);
    }

    static Vec3f color(std::string_view line, const Vec3f& fallback) {
        const auto red = finite_number(next_word(line));
        const auto green = finite_number(next_word(line));
        const auto blue = finite_number(next_word(line));
        if (!red) return fallback;
        return glm::max(Vec3f{*red, green.value_or(*red), blue.value_or(*red)}, Vec3f{0.0F});
    }

    void set_alpha(float alpha) {
        current().alpha = std::clamp(alpha, 0.0F, 1.0F);
        if (current().alpha < 1.0F) current().alpha_mode = AlphaMode::Blend;
    }

    void read_number(std::string_view key, std::string_view line) {
        MaterialData& material = current();
        if (key == "kd") material.base_color = color(line, material.base_color);
        if (key == "ke") material.emissive = color(line, material.emissive);
        if (key == "d") set_alpha(number(line, 1.0F));
        if (key == "tr") set_alpha(1.0F - number(line, 0.0F));
        if (key == "pr") material.roughness = std::clamp(number(line, 0.8F), 0.0F, 1.0F);
        if (key == "pm") material.metallic = std::clamp(number(line, 0.0F), 0.0F, 1.0F);
        if (key == "ns") {
            // The width of a Blinn-Phong highlight as a microfacet roughness.
            const float exponent = std::max(0.0F, number(line, 10.0F));
            material.roughness = std::pow(2.0F / (exponent + 2.0F), 0.25F);
        }
    }

    void read_map(std::string_view key, std::string_view line) {
        MaterialData& material = current();
        if (key == "map_kd") material.base_color_map = map(line, key);
        if (key == "map_bump" || key == "bump" || key == "norm" || key == "map_kn") {
            material.normal_map = map(line, key);
        }
        if (key == "disp" || key == "map_disp") material.height_map = map(line, key);
        if (key == "map_d" || key == "map_opacity") {
            // Cut-outs keep their shape in the base colour's alpha; a mask apart is not read.
            static_cast<void>(map(line, key));
            material.alpha_mode = AlphaMode::Mask;
            material.two_sided = true;
        }
        if (key == "map_ks" || key == "map_ns" || key == "map_ka" || key == "map_pr" ||
            key == "map_pm") {
            static_cast<void>(map(line, key));  // confined like the others, though nobody reads it
            log_debug("model {}: {} of material \"{}\" is not read", name, key, material.name);
        }
    }

    void read_line(std::string_view line) {
        const std::string key = to_lower(next_word(line));
        if (key == "newmtl") {
            materials.push_back({.name = std::string(trimmed(line))});
            if (materials.size() > limits::kModelMaterials) {
                fail("it has more than {} materials", limits::kModelMaterials);
            }
        } else if (!materials.empty()) {
            read_number(key, line);
            read_map(key, line);
        }
    }
};

}  // namespace

Result<std::vector<MaterialData>> read_mtl(const fs::path& file,
                                           const std::string& name,
                                           ModelReferences& references) {
    const Result<std::string> bytes = read_file(file, limits::kModelJsonBytes);
    if (!bytes) {
        log_warning("model {}: {}; its materials are plain", name, bytes.error().message);
        return std::vector<MaterialData>{};
    }
    if (is_utf16(*bytes))
        log_warning("model {}: of {} {}", name, file.filename().string(), kUtf16Fault);
    return or_refused(name, [&] {
        MtlReader reader{.file = file, .name = name, .references = references};
        LineReader lines(*bytes);
        while (const auto line = lines.next()) reader.read_line(*line);
        for (MaterialData& material : reader.materials) {
            // A map would be black as well; exporters that write so mean the map alone.
            if (!material.base_color_map.empty() && material.base_color == Vec3f{0.0F})
                material.base_color = Vec3f{1.0F};
        }
        return std::move(reader.materials);
    });
}

}  // namespace plumbline::assets
