#include "engine/scene/build/water_mesh.h"

#include <cmath>

namespace plumbline::scene {
namespace {

std::uint32_t add_vertex(assets::MeshData& mesh, double x, double y, double z) {
    assets::Vertex vertex;
    vertex.position_body = Vec3f(Vec3d{x, y, z});
    vertex.normal_body = {0, 1, 0};
    vertex.tangent_body = {1, 0, 0, 1};
    vertex.uv = {static_cast<float>(x / kWaterTile_m), static_cast<float>(z / kWaterTile_m)};
    mesh.vertices.push_back(vertex);
    return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
}

/// Corners at low x and z, then along z, then x too, then x alone: counter-clockwise from above.
void add_cell(
    assets::MeshData& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    for (const std::uint32_t corner : {a, b, c, a, c, d}) mesh.indices.push_back(corner);
}

void finish_surface(assets::MeshData& mesh) {
    mesh.sub_meshes = {{.first_index = 0,
                        .index_count = static_cast<std::uint32_t>(mesh.indices.size()),
                        .material = 0}};
    mesh.bounds = assets::bounds_of(mesh);
}

}  // namespace

assets::MeshData water_mesh(const Vec3d& min_m, const Vec3d& max_m, std::uint32_t cells) {
    assets::MeshData mesh;
    const Vec3d cell_m = (max_m - min_m) / static_cast<double>(cells);
    for (std::uint32_t row = 0; row <= cells; ++row) {
        for (std::uint32_t column = 0; column <= cells; ++column)
            add_vertex(mesh, min_m.x + cell_m.x * column, max_m.y, min_m.z + cell_m.z * row);
    }
    for (std::uint32_t row = 0; row < cells; ++row) {
        for (std::uint32_t column = 0; column < cells; ++column) {
            const std::uint32_t a = row * (cells + 1) + column;
            add_cell(mesh, a, a + cells + 1, a + cells + 2, a + 1);
        }
    }
    finish_surface(mesh);
    return mesh;
}

assets::MeshData water_mesh(const Basin& basin) {
    assets::MeshData mesh;
    const double level_m = basin.max_m().y;
    for (const Basin::Cell& cell : basin.surface()) {
        const std::uint32_t a = add_vertex(mesh, cell.x0, level_m, cell.z0);
        const std::uint32_t b = add_vertex(mesh, cell.x0, level_m, cell.z1);
        const std::uint32_t c = add_vertex(mesh, cell.x1, level_m, cell.z1);
        const std::uint32_t d = add_vertex(mesh, cell.x1, level_m, cell.z0);
        add_cell(mesh, a, b, c, d);
    }
    finish_surface(mesh);
    return mesh;
}

void shape_water_mesh(std::span<const double> heights_m, double level_m, assets::MeshData& mesh) {
    const auto side =
        static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(heights_m.size()))));
    for (std::size_t row = 0; row < side; ++row) {
        for (std::size_t column = 0; column < side; ++column) {
            const std::size_t at = row * side + column;
            assets::Vertex& vertex = mesh.vertices[at];
            vertex.position_body.y = static_cast<float>(level_m + heights_m[at]);
            const std::size_t left = column > 0 ? at - 1 : at;
            const std::size_t right = column + 1 < side ? at + 1 : at;
            const std::size_t back = row > 0 ? at - side : at;
            const std::size_t front = row + 1 < side ? at + side : at;
            const auto rise = [&](std::size_t from, std::size_t to, int axis) {
                const auto& vertices = mesh.vertices;
                const float run_m =
                    vertices[to].position_body[axis] - vertices[from].position_body[axis];
                return static_cast<float>(heights_m[to] - heights_m[from]) / run_m;
            };
            const float along_x = rise(left, right, 0);
            vertex.normal_body = glm::normalize(Vec3f{-along_x, 1, -rise(back, front, 2)});
            vertex.tangent_body = Vec4f(glm::normalize(Vec3f{1, along_x, 0}), 1);
        }
    }
    mesh.bounds = assets::bounds_of(mesh);
    ++mesh.version;
}

}  // namespace plumbline::scene
