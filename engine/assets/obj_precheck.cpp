#include "engine/assets/checked_model.h"
#include "engine/assets/obj_check_impl.h"
#include "engine/assets/single_mesh_impl.h"
#include "engine/core/limits.h"
#include "engine/core/log.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>

namespace plumbline::assets {
namespace {

namespace fs = std::filesystem;

// Triangulating a polygon takes a time that grows with the square of its corners.
constexpr std::size_t kMaxCorners = 256;

/// Position, texture and normal number of a face's corner; from 1, 0 where there is none.
using Corner = std::array<std::size_t, 3>;

/// The OBJ file being rewritten: only lines whose every word was understood go into `clean`.
struct ObjReader {
    const std::string& name;
    ModelReferences& references;

    std::string clean{"# checked\n"};
    std::array<std::size_t, 3> counts{};  ///< positions, texture coordinates, normals so far
    std::vector<bool> finite{};           ///< by position
    bool has_colors{false};               ///< "v x y z r g b"; the first vertex decides
    std::size_t corners{0};
    std::size_t bad_faces{0};
    std::size_t other_elements{0};
    std::vector<MaterialData> materials{};
    std::map<std::string, std::size_t> numbers{};  ///< of materials, by name
    std::string fault{};

    void read_vector(char kind, std::string_view rest) {
        const std::size_t size = kind == 't' ? 2 : 3;
        clean += kind == 'v' ? "v" : fmt::format("v{}", kind);
        bool all_finite = true;
        for (std::size_t i = 0; i < size; ++i) {
            const std::optional<float> value = finite_number(next_word(rest));
            all_finite = all_finite && value.has_value();
            fmt::format_to(std::back_inserter(clean), " {}", value.value_or(0.0F));
        }
        if (kind == 'v') read_color(rest);
        clean += '\n';
        ++counts[kind == 'v' ? 0 : (kind == 't' ? 1 : 2)];
        if (kind == 'v') finite.push_back(all_finite);
        if (counts[0] > limits::kVertices) {
            fault = fmt::format("it has more than {} vertices", limits::kVertices);
        }
    }

    /// Colours are stored as screens show them.
    void read_color(std::string_view rest) {
        std::array<float, 3> color{1.0F, 1.0F, 1.0F};
        std::size_t found = 0;
        for (; found < 3; ++found) {
            const std::optional<float> value = finite_number(next_word(rest));
            if (!value) break;
            color[found] = linear_from_srgb(std::clamp(*value, 0.0F, 1.0F));
        }
        if (finite.empty()) has_colors = found == 3;
        if (!has_colors) return;
        if (found < 3) color = {1.0F, 1.0F, 1.0F};
        fmt::format_to(std::back_inserter(clean), " {} {} {}", color[0], color[1], color[2]);
    }

    /// "7", "7/2", "7//3", "7/2/3"; negative numbers count back from the latest.
    std::optional<Corner> corner_of(std::string_view word) const {
        Corner corner{};
        for (std::size_t part = 0; part < 3 && !word.empty(); ++part) {
            const std::size_t slash = std::min(word.find('/'), word.size());
            const std::string_view digits = word.substr(0, slash);
            word.remove_prefix(std::min(slash + 1, word.size()));
            if (digits.empty()) {
                if (part == 0) return std::nullopt;
                continue;
            }
            std::int64_t number = 0;
            const auto [end, failed] =
                std::from_chars(digits.data(), digits.data() + digits.size(), number);
            if (failed != std::errc{} || end != digits.data() + digits.size()) return std::nullopt;
            if (number < 0) number += static_cast<std::int64_t>(counts[part]) + 1;
            if (number < 1 || number > static_cast<std::int64_t>(counts[part])) return std::nullopt;
            corner[part] = static_cast<std::size_t>(number);
        }
        if (corner[0] == 0 || !finite[corner[0] - 1]) return std::nullopt;
        return corner;
    }

    void read_face(std::string_view rest) {
        std::vector<Corner> face;
        while (!trimmed(rest).empty()) {
            const std::optional<Corner> corner = corner_of(next_word(rest));
            if (!corner || face.size() == kMaxCorners) {
                ++bad_faces;
                return;
            }
            face.push_back(*corner);
        }
        if (face.size() < 3) {
            ++bad_faces;
            return;
        }
        // assimp wants every corner of a face to have the same parts.
        const auto all_have = [&](std::size_t part) {
            return std::all_of(
                face.begin(), face.end(), [&](const Corner& corner) { return corner[part] != 0; });
        };
        const bool has_uv = all_have(1);
        const bool has_normal = all_have(2);
        clean += 'f';
        for (const Corner& corner : face) {
            fmt::format_to(std::back_inserter(clean), " {}", corner[0]);
            if (has_uv || has_normal) clean += '/';
            if (has_uv) fmt::format_to(std::back_inserter(clean), "{}", corner[1]);
            if (has_normal) fmt::format_to(std::back_inserter(clean), "/{}", corner[2]);
        }
        clean += '\n';
        corners += (face.size() - 2) * 3;
        if (corners > limits::kIndices) {
            fault = fmt::format("it draws more than {} indices", limits::kIndices);
        }
    }

    /// The first material of a name counts.
    void add_material(MaterialData material) {
        numbers.emplace(material.name, materials.size());
        materials.push_back(std::move(material));
        if (materials.size() > limits::kModelMaterials) {
            fault = fmt::format("it has more than {} materials", limits::kModelMaterials);
        }
    }

    void use_material(std::string wanted) {
        if (wanted.empty()) wanted = "default";
        if (!numbers.contains(wanted)) {
            log_warning("model {}: no file has its material \"{}\"; it is plain", name, wanted);
            add_material({.name = wanted});
        }
        fmt::format_to(std::back_inserter(clean), "usemtl {}\n", numbers[wanted]);
    }

    /// The whole rest of the line is one name, spaces and all.
    void read_library(std::string_view rest) {
        std::string reference(trimmed(rest));
        std::replace(reference.begin(), reference.end(), '\\', '/');
        const Result<fs::path> file = references.resolve(reference, "mtllib");
        if (!file) {
            fault = file.error().message;
            return;
        }
        Result<std::vector<MaterialData>> read = read_mtl(*file, name, references);
        if (!read) {
            fault = read.error().message;
            return;
        }
        for (MaterialData& material : *read) add_material(std::move(material));
    }

    void read_line(std::string_view line) {
        const std::string_view key = next_word(line);
        if (key == "v") {
            read_vector('v', line);
        } else if (key == "vt") {
            read_vector('t', line);
        } else if (key == "vn") {
            read_vector('n', line);
        } else if (key == "f") {
            read_face(line);
        } else if (key == "usemtl") {
            use_material(std::string(trimmed(line)));
        } else if (key == "mtllib") {
            read_library(line);
        } else if (key == "p" || key == "l" || key == "curv" || key == "surf") {
            ++other_elements;
        }
    }
};

bool is_blank(char letter) {
    return letter == ' ' || letter == '\t' || letter == '\r' || letter == '\v' || letter == '\f';
}

}  // namespace

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return text;
}

std::optional<std::string> next_line(std::string_view& text) {
    if (text.empty()) return std::nullopt;
    std::string line;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view piece = trimmed(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        const bool goes_on = piece.ends_with('\\');
        if (goes_on) piece.remove_suffix(1);
        line += piece;
        if (!goes_on) break;
        line += ' ';
    }
    return line;
}

std::string_view next_word(std::string_view& line) {
    line = trimmed(line);
    std::size_t end = 0;
    while (end < line.size() && !is_blank(line[end])) ++end;
    const std::string_view word = line.substr(0, end);
    line = trimmed(line.substr(end));
    return word;
}

std::optional<float> finite_number(std::string_view word) {
    if (word.starts_with('+')) word.remove_prefix(1);
    float value = 0.0F;
    const auto [end, failed] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (failed != std::errc{} || end != word.data() + word.size()) return std::nullopt;
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

Result<CheckedModel> check_obj(std::string_view bytes,
                               const std::string& name,
                               ModelReferences& references) {
    if (bytes.find('\0') != std::string_view::npos) {
        return model_error(name, "its content is not OBJ text");
    }
    ObjReader reader{.name = name, .references = references};
    while (const std::optional<std::string> line = next_line(bytes)) {
        reader.read_line(*line);
        if (!reader.fault.empty()) return model_error(name, reader.fault);
    }
    if (reader.corners == 0) return model_error(name, "it holds no triangles");
    if (reader.bad_faces > 0) {
        log_warning(
            "model {}: {} faces that name vertices it lacks, or no usable ones, are left out",
            name,
            reader.bad_faces);
    }
    if (reader.other_elements > 0) {
        log_warning(
            "model {}: {} points, lines or curves are left out", name, reader.other_elements);
    }
    CheckedModel model{.main_name = "model.obj", .materials = std::move(reader.materials)};
    model.files.emplace(model.main_name, std::move(reader.clean));
    return model;
}

}  // namespace plumbline::assets
