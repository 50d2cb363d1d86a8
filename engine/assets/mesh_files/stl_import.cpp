#include "engine/assets/byte_reader.h"
#include "engine/assets/mesh_files/single_mesh_impl.h"
#include "engine/assets/mesh_files/text_words_impl.h"
#include "engine/core/limits.h"

#include <array>
#include <optional>

namespace plumbline::assets {
namespace {

constexpr std::size_t kHeaderBytes = 84;
constexpr std::size_t kTriangleBytes = 50;
constexpr std::size_t kMostTriangles = limits::kIndices / 3;

struct Facets {
    ModelMesh mesh{.name = "stl"};
    std::size_t left_out{0};

    /// Facets keep vertices and a normal of their own: they are flat, as they are made.
    void add(const std::array<Vec3f, 3>& corners) {
        const Vec3f area = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
        if (!is_finite(area) || area == Vec3f{0.0F}) {
            ++left_out;
            return;
        }
        // The file's own normals are often zero or wrong; the winding decides.
        const Vec3f normal = normalize_or(area, Vec3f{0.0F});
        for (const Vec3f& corner : corners) {
            mesh.indices.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
            mesh.vertices.push_back({.position_body = corner, .normal_body = normal});
        }
    }
};

/// How many facets a binary file says it has; nothing when its size does not bear that out.
std::optional<std::size_t> binary_count(std::string_view bytes) {
    if (bytes.size() < kHeaderBytes) return std::nullopt;
    ByteReader reader(bytes.substr(kHeaderBytes - 4));
    const std::size_t count = reader.number<std::uint32_t>();
    if (reader.left() / kTriangleBytes < count) return std::nullopt;
    // Text may begin like this too; what follows it is then far too long.
    const bool exact = reader.left() - count * kTriangleBytes < kTriangleBytes;
    return exact || !bytes.starts_with("solid") ? std::optional(count) : std::nullopt;
}

void read_binary(std::string_view bytes, std::size_t count, Facets& facets) {
    ByteReader reader(bytes.substr(kHeaderBytes));
    facets.mesh.vertices.reserve(count * 3);
    facets.mesh.indices.reserve(count * 3);
    for (std::size_t i = 0; i < count; ++i) {
        reader.take(12);
        std::array<Vec3f, 3> corners;
        for (Vec3f& corner : corners) {
            for (int axis = 0; axis < 3; ++axis) corner[axis] = reader.number<float>();
        }
        reader.take(2);
        facets.add(corners);
    }
}

void read_text(std::string_view bytes, Facets& facets) {
    std::array<Vec3f, 3> corners;
    std::size_t filled = 0;
    std::size_t line_number = 0;
    bool ended = false;
    LineReader lines(bytes);
    while (const std::optional<std::string_view> line = lines.next()) {
        ++line_number;
        std::string_view rest = *line;
        const std::string_view word = next_word(rest);
        ended = word == "endsolid" || (ended && word.empty());
        if (word == "facet" || word == "outer") filled = 0;
        if (word != "vertex") continue;
        if (filled == 3) fail("line {}: a facet has three vertices", line_number);
        for (int axis = 0; axis < 3; ++axis) {
            const std::optional<float> value = finite_number(next_word(rest));
            if (!value) fail("line {}: a vertex must be three numbers", line_number);
            corners[filled][axis] = *value;
        }
        if (++filled == 3) facets.add(corners);
        if (facets.mesh.indices.size() > limits::kIndices) fail("it is too large");
    }
    if (!ended) fail("the text breaks off before \"endsolid\"");
}

}  // namespace

Result<ModelData> read_stl(std::string_view bytes, const std::string& name) {
    return or_refused(name, [&] {
        Facets facets;
        if (const std::optional<std::size_t> count = binary_count(bytes)) {
            if (*count > kMostTriangles) {
                fail("it has {} triangles; at most {} are read", *count, kMostTriangles);
            }
            read_binary(bytes, *count, facets);
        } else if (bytes.starts_with("solid")) {
            read_text(bytes, facets);
        } else if (bytes.size() >= kHeaderBytes) {
            ByteReader reader(bytes.substr(kHeaderBytes - 4));
            const std::size_t promised = reader.number<std::uint32_t>();
            fail("it says {} triangles and has room for {}",
                 promised,
                 reader.left() / kTriangleBytes);
        } else {
            fail("its content is not STL");
        }
        return model_with_z_up(std::move(facets.mesh), false);
    });
}

}  // namespace plumbline::assets
