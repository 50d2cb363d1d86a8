#include "engine/core/hash.h"
#include "engine/scene/json_scene/json_scene_impl.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace plumbline::scene {
namespace {

using Json = nlohmann::json;

/// The flat array under `key`, in threes; absent: empty.
std::optional<std::vector<double>> triples_of(const Json& object,
                                              std::string_view key,
                                              const std::string& path,
                                              const JsonFaults& faults) {
    const Json* value = member_of(object, key);
    if (value == nullptr) return std::vector<double>{};
    const std::string place = fmt::format("{}.{}", path, key);
    auto numbers = json_numbers(*value, 0, place, faults);
    if (!numbers) return std::nullopt;
    if (numbers->size() % 3 == 0) return numbers;
    return faults.error(place, "{} numbers are not whole triples", numbers->size());
}

/// Corners by number; checked against the vertices there are.
std::optional<std::vector<std::uint32_t>> indices_of(const std::vector<double>& numbers,
                                                     std::size_t vertices,
                                                     const std::string& path,
                                                     const JsonFaults& faults) {
    std::vector<std::uint32_t> indices;
    indices.reserve(numbers.size());
    for (const double number : numbers) {
        const std::size_t place = indices.size();
        if (!(number >= 0.0 && number < static_cast<double>(vertices)) ||
            number != std::floor(number)) {
            return faults.error(fmt::format("{}.faces[{}]", path, place),
                                "face {} names vertex {}; there are {}",
                                place / 3,
                                number,
                                vertices);
        }
        indices.push_back(static_cast<std::uint32_t>(number));
    }
    return indices;
}

Vec3f triple(const std::vector<double>& numbers, std::size_t i) {
    return Vec3f{static_cast<float>(numbers[i * 3]),
                 static_cast<float>(numbers[i * 3 + 1]),
                 static_cast<float>(numbers[i * 3 + 2])};
}

/// The inverse transpose but for its length, also where a scale of zero has no inverse.
glm::dmat3 normals_from(const glm::dmat3& linear) {
    const glm::dmat3 cofactors{glm::cross(linear[1], linear[2]),
                               glm::cross(linear[2], linear[0]),
                               glm::cross(linear[0], linear[1])};
    return glm::determinant(linear) < 0.0 ? -cofactors : cofactors;
}

Vec3f turned(const glm::dmat3& matrix, const glm::dvec3& normal) {
    const glm::dvec3 world = matrix * normal;
    const double length = glm::length(world);
    return length > 0.0 && std::isfinite(length) ? Vec3f{world / length} : Vec3f{0.0F, 1.0F, 0.0F};
}

void add_flat(const assets::ExactPly& source, const glm::dmat3& matrix, assets::MeshData& mesh) {
    for (std::size_t i = 0; i + 2 < source.indices.size(); i += 3) {
        std::array<assets::Vertex, 3> corners{source.vertices[source.indices[i]],
                                              source.vertices[source.indices[i + 1]],
                                              source.vertices[source.indices[i + 2]]};
        const glm::dvec3 first{corners[0].position_body};
        const Vec3f normal = turned(matrix,
                                    glm::cross(glm::dvec3{corners[1].position_body} - first,
                                               glm::dvec3{corners[2].position_body} - first));
        for (assets::Vertex& corner : corners) {
            mesh.indices.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
            corner.normal_body = normal;
            mesh.vertices.push_back(corner);
        }
    }
}

}  // namespace

std::optional<JsonMesh> json_inline_mesh(const Json& object,
                                         const std::string& path,
                                         const JsonFaults& faults) {
    const auto places = triples_of(object, "vertices", path, faults);
    const auto faces = triples_of(object, "faces", path, faults);
    const auto colors = triples_of(object, "vertex_colors", path, faults);
    if (!places || !faces || !colors) return std::nullopt;
    if (member_of(object, "vertex_colors") != nullptr && colors->size() != places->size()) {
        return faults.error(path + ".vertex_colors",
                            "{} colours for {} vertices; expected as many",
                            colors->size() / 3,
                            places->size() / 3);
    }
    JsonMesh mesh;
    auto indices = indices_of(*faces, places->size() / 3, path, faults);
    if (!indices) return std::nullopt;
    mesh.triangles.indices = std::move(*indices);
    mesh.triangles.vertices.resize(places->size() / 3);
    for (std::size_t i = 0; i < mesh.triangles.vertices.size(); ++i) {
        assets::Vertex& vertex = mesh.triangles.vertices[i];
        vertex.position_body = triple(*places, i);
        if (!colors->empty()) vertex.color = triple(*colors, i);
        if (plumbline::is_finite(vertex.position_body) && plumbline::is_finite(vertex.color))
            continue;
        return faults.error(path + ".vertices", "vertex {} is too large for a float", i);
    }
    Hasher hasher;
    for (const auto* numbers : {&*places, &*faces, &*colors})
        hasher.add(numbers->data(), numbers->size() * sizeof(double));
    mesh.hash = hasher.digest();
    return mesh;
}

float brightest_of(const assets::ExactPly& mesh) {
    float brightest = 1.0F;
    for (const assets::Vertex& vertex : mesh.vertices)
        brightest = std::max({brightest, vertex.color.x, vertex.color.y, vertex.color.z});
    return brightest;
}

assets::MeshData json_mesh_data(const assets::ExactPly& source,
                                const glm::dmat3& linear,
                                float brightest) {
    assets::MeshData mesh;
    const glm::dmat3 matrix = normals_from(linear);
    if (source.has_normals) {
        mesh.vertices = source.vertices;
        mesh.indices = source.indices;
        for (assets::Vertex& vertex : mesh.vertices)
            vertex.normal_body = turned(matrix, glm::dvec3{vertex.normal_body});
    } else {
        add_flat(source, matrix, mesh);
    }
    for (assets::Vertex& vertex : mesh.vertices) {
        vertex.position_body = Vec3f{linear * glm::dvec3{vertex.position_body}};
        vertex.color /= brightest;
    }
    mesh.sub_meshes = {{.first_index = 0,
                        .index_count = static_cast<std::uint32_t>(mesh.indices.size()),
                        .material = 0}};
    mesh.bounds = bounds_of(mesh);
    return mesh;
}

}  // namespace plumbline::scene
