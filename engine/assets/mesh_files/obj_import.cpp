#include "engine/assets/mesh_files/polygon_triangles_impl.h"
#include "engine/assets/mesh_files/single_mesh_impl.h"
#include "engine/assets/mesh_files/text_words_impl.h"
#include "engine/assets/model/model_readers_impl.h"
#include "engine/core/color.h"
#include "engine/core/limits.h"
#include "engine/core/log.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <map>

namespace plumbline::assets {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t kNobody = ~0U;
// Corners of one position with other texture coordinates or normals than this many others before
// get vertices of their own even where they need none: no file makes the search slow.
constexpr int kMostLooks = 32;

/// Position, texture and normal number of a face's corner; from 1, 0 where there is none.
using Corner = std::array<std::uint32_t, 3>;

/// A vertex that has been made, among those at its position.
struct MadeVertex {
    std::uint32_t uv{0};
    std::uint32_t normal{0};
    std::uint32_t material{0};
    std::uint32_t vertex{0};  ///< of that material's mesh
    std::uint32_t next{kNobody};
};

/// The OBJ file being read, line by line, into one mesh a material.
struct ObjReader {
    const std::string& name;
    ModelReferences& references;

    std::vector<Vec3f> positions{};  ///< not finite: no face may use it
    std::vector<Vec3f> colors{};     ///< of the positions, or none
    std::vector<Vec2f> uvs{};        ///< v runs down
    std::vector<Vec3f> normals{};
    std::vector<MaterialData> materials{};
    std::map<std::string, std::uint32_t, std::less<>> numbers{};  ///< of materials, by name
    std::vector<ModelMesh> meshes{};                              ///< by material
    std::uint32_t material{kNobody};                              ///< of the faces that follow
    std::vector<MadeVertex> made{};
    std::vector<std::uint32_t> first_made{};  ///< by position
    std::size_t corners{0};
    std::size_t bad_faces{0};
    std::size_t other_elements{0};
    std::vector<Corner> face{};        // kept from line to line for its memory
    std::vector<Vec3f> face_places{};  // as well

    static std::optional<Vec3f> vector_of(std::string_view& rest) {
        Vec3f vector;
        for (int axis = 0; axis < 3; ++axis) {
            const std::optional<float> value = finite_number(next_word(rest));
            if (!value) return std::nullopt;
            vector[axis] = *value;
        }
        return vector;
    }

    void read_position(std::string_view rest) {
        const std::optional<Vec3f> place = vector_of(rest);
        if (positions.size() == limits::kVertices) {
            fail("it has more than {} vertices", limits::kVertices);
        }
        const std::optional<Vec3f> color = rest.empty() ? std::nullopt : vector_of(rest);
        // "v x y z r g b": the first vertex decides. Colours are stored as screens show them.
        const bool has_colors = positions.empty() ? color.has_value() : !colors.empty();
        positions.push_back(place.value_or(Vec3f{std::numeric_limits<float>::quiet_NaN()}));
        if (!has_colors) return;
        Vec3f linear{1.0F};
        for (int i = 0; color && i < 3; ++i) {
            linear[i] = linear_from_srgb(std::clamp((*color)[i], 0.0F, 1.0F));
        }
        colors.push_back(linear);
    }

    void read_uv(std::string_view rest) {
        const float u = finite_number(next_word(rest)).value_or(0.0F);
        const float v = finite_number(next_word(rest)).value_or(0.0F);
        uvs.push_back({u, 1.0F - v});
    }

    /// "7", "7/2", "7//3", "7/2/3"; negative numbers count back from the latest.
    std::optional<Corner> corner_of(std::string_view word) const {
        const std::array<std::size_t, 3> counts{positions.size(), uvs.size(), normals.size()};
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
            corner[part] = static_cast<std::uint32_t>(number);
        }
        if (corner[0] == 0 || !is_finite(positions[corner[0] - 1])) return std::nullopt;
        return corner;
    }

    /// The vertex of a corner, shared by all that are alike.
    std::uint32_t vertex_of(const Corner& corner) {
        const std::uint32_t position = corner[0] - 1;
        if (first_made.size() < positions.size()) first_made.resize(positions.size(), kNobody);
        std::uint32_t at = first_made[position];
        for (int looks = 0; at != kNobody && looks < kMostLooks; ++looks, at = made[at].next) {
            const MadeVertex& known = made[at];
            if (known.uv == corner[1] && known.normal == corner[2] && known.material == material) {
                return known.vertex;
            }
        }
        Vertex vertex{.position_body = positions[position], .normal_body = Vec3f{0.0F}};
        if (corner[1] != 0) vertex.uv = uvs[corner[1] - 1];
        if (corner[2] != 0) vertex.normal_body = normals[corner[2] - 1];
        if (!colors.empty()) vertex.color = colors[position];
        std::vector<Vertex>& vertices = meshes[material].vertices;
        vertices.push_back(vertex);
        made.push_back({.uv = corner[1],
                        .normal = corner[2],
                        .material = material,
                        .vertex = static_cast<std::uint32_t>(vertices.size() - 1),
                        .next = first_made[position]});
        first_made[position] = static_cast<std::uint32_t>(made.size() - 1);
        return made.back().vertex;
    }

    /// False: a corner that cannot be used.
    bool read_corners(std::string_view rest) {
        face.clear();
        while (!rest.empty()) {
            const std::optional<Corner> corner = corner_of(next_word(rest));
            if (!corner || face.size() == kMostCorners) return false;
            face.push_back(*corner);
        }
        return face.size() >= 3;
    }

    void read_face(std::string_view rest) {
        if (!read_corners(rest)) {
            ++bad_faces;
            return;
        }
        if (material == kNobody) use_material("default");
        // What one corner of a face lacks none of it has.
        for (std::size_t part : {1U, 2U}) {
            const bool all = std::all_of(
                face.begin(), face.end(), [&](const Corner& corner) { return corner[part] != 0; });
            if (all) continue;
            for (Corner& corner : face) corner[part] = 0;
        }
        std::vector<std::uint32_t>& indices = meshes[material].indices;
        if (face.size() == 3) {
            for (const Corner& corner : face) indices.push_back(vertex_of(corner));
        } else {
            face_places.clear();
            for (const Corner& corner : face) face_places.push_back(positions[corner[0] - 1]);
            for (const auto& triangle : triangles_of(face_places)) {
                for (const std::uint32_t i : triangle) indices.push_back(vertex_of(face[i]));
            }
        }
        corners += (face.size() - 2) * 3;
        if (corners > limits::kIndices) {
            fail("it draws more than {} indices", limits::kIndices);
        }
    }

    /// The first material of a name counts.
    void add_material(MaterialData added) {
        numbers.emplace(added.name, static_cast<std::uint32_t>(materials.size()));
        materials.push_back(std::move(added));
        meshes.emplace_back();
        if (materials.size() > limits::kModelMaterials) {
            fail("it has more than {} materials", limits::kModelMaterials);
        }
    }

    void use_material(std::string_view wanted) {
        if (wanted.empty()) wanted = "default";
        const auto known = numbers.find(wanted);
        if (known != numbers.end()) {
            material = known->second;
            return;
        }
        if (wanted != "default") {
            log_warning("model {}: no file has its material \"{}\"; it is plain", name, wanted);
        }
        material = static_cast<std::uint32_t>(materials.size());
        add_material({.name = std::string(wanted)});
    }

    /// The whole rest of the line is one name, spaces and all.
    void read_library(std::string_view rest) {
        std::string reference(trimmed(rest));
        std::replace(reference.begin(), reference.end(), '\\', '/');
        const Result<fs::path> file = references.resolve(reference, "mtllib");
        if (!file) fail("{}", file.error().message);
        Result<std::vector<MaterialData>> read = read_mtl(*file, name, references);
        if (!read) fail("{}", read.error().message);
        for (MaterialData& added : *read) add_material(std::move(added));
    }

    void read_line(std::string_view line) {
        const std::string_view key = next_word(line);
        if (key == "v") {
            read_position(line);
        } else if (key == "vt") {
            read_uv(line);
        } else if (key == "vn") {
            normals.push_back(vector_of(line).value_or(Vec3f{0.0F}));
        } else if (key == "f") {
            read_face(line);
        } else if (key == "usemtl") {
            use_material(trimmed(line));
        } else if (key == "mtllib") {
            read_library(line);
        } else if (key == "p" || key == "l" || key == "curv" || key == "surf") {
            ++other_elements;
        }
    }

    ModelData model() {
        ModelData model{.nodes = {{.name = "obj"}}, .materials = std::move(materials)};
        for (std::uint32_t i = 0; i < meshes.size(); ++i) {
            ModelMesh& mesh = meshes[i];
            if (mesh.indices.empty()) continue;
            mesh.name = model.materials[i].name;
            mesh.material = i;
            model.materials[i].vertex_colors = !colors.empty();
            model.nodes[0].meshes.push_back(static_cast<std::uint32_t>(model.meshes.size()));
            model.meshes.push_back(std::move(mesh));
        }
        return model;
    }
};

}  // namespace

Result<ModelData> read_obj(std::string_view bytes,
                           const std::string& name,
                           ModelReferences& references) {
    return or_refused(name, [&] {
        if (bytes.find('\0') != std::string_view::npos) fail("its content is not OBJ text");
        ObjReader reader{.name = name, .references = references};
        LineReader lines(bytes);
        while (const auto line = lines.next()) reader.read_line(*line);
        if (reader.corners == 0) fail("it holds no triangles");
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
        return reader.model();
    });
}

}  // namespace plumbline::assets
