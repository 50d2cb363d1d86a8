#include "engine/scene/build/cloth_mesh.h"

#include <algorithm>
#include <array>

namespace plumbline::scene {
namespace {

void add_triangles(const physics::Sheet& sheet, std::vector<std::uint32_t>& indices) {
    const std::uint32_t columns = sheet.columns();
    const std::uint32_t back = columns * sheet.rows();
    indices.clear();
    for (std::uint32_t row = 0; row + 1 < sheet.rows(); ++row) {
        for (std::uint32_t column = 0; column + 1 < columns; ++column) {
            if (sheet.torn() > 0 && !sheet.is_whole(column, row)) continue;
            const std::uint32_t a = row * columns + column;
            const std::uint32_t b = a + columns;
            // Diagonals alternate, as those that the air feels.
            const bool falls = (row + column) % 2 == 0;
            const std::array<std::uint32_t, 6> corners =
                falls ? std::array{a, b, b + 1, a, b + 1, a + 1}
                      : std::array{a, b, a + 1, b, b + 1, a + 1};
            indices.insert(indices.end(), corners.begin(), corners.end());
            for (std::size_t i = 0; i < 6; i += 3) {
                for (const std::size_t corner : {i, i + 2, i + 1})
                    indices.push_back(back + corners[corner]);
            }
        }
    }
}

}  // namespace

assets::MeshData cloth_mesh(const physics::Sheet& sheet) {
    assets::MeshData mesh;
    for (const float side : {1.0F, -1.0F}) {
        for (std::uint32_t row = 0; row < sheet.rows(); ++row) {
            for (std::uint32_t column = 0; column < sheet.columns(); ++column) {
                assets::Vertex vertex;
                vertex.uv = {static_cast<float>(column) / static_cast<float>(sheet.columns() - 1),
                             static_cast<float>(row) / static_cast<float>(sheet.rows() - 1)};
                vertex.tangent_body.w = side;
                mesh.vertices.push_back(vertex);
            }
        }
    }
    mesh.sub_meshes = {{.first_index = 0, .index_count = 0, .material = 0}};
    return mesh;
}

void shape_cloth_mesh(const physics::Sheet& sheet,
                      std::span<const Vec3d> points_m,
                      float thickness_m,
                      assets::MeshData& mesh) {
    const std::uint32_t columns = sheet.columns();
    const std::uint32_t rows = sheet.rows();
    const std::size_t count = points_m.size();
    for (std::uint32_t row = 0; row < rows; ++row) {
        for (std::uint32_t column = 0; column < columns; ++column) {
            const std::size_t at = std::size_t{row} * columns + column;
            const Vec3d right =
                points_m[column + 1 < columns ? at + 1 : at] - points_m[column > 0 ? at - 1 : at];
            const Vec3d down = points_m[row + 1 < rows ? at + columns : at] -
                               points_m[row > 0 ? at - columns : at];
            const Vec3f normal(normalize_or(glm::cross(down, right), Vec3d{0, 1, 0}));
            const Vec3f tangent(normalize_or(right, Vec3d{1, 0, 0}));
            for (const bool is_back : {false, true}) {
                assets::Vertex& vertex = mesh.vertices[at + (is_back ? count : 0)];
                vertex.normal_body = is_back ? -normal : normal;
                vertex.position_body = Vec3f(points_m[at]) + vertex.normal_body * (thickness_m / 2);
                vertex.tangent_body = Vec4f(tangent, vertex.tangent_body.w);
            }
        }
    }
    add_triangles(sheet, mesh.indices);
    mesh.sub_meshes[0].index_count = static_cast<std::uint32_t>(mesh.indices.size());
    mesh.bounds = assets::bounds_of(mesh);
    ++mesh.version;
}

}  // namespace plumbline::scene
