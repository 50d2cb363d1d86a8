#include "engine/assets/model/mesh_simplify.h"

#include "engine/assets/primitives.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>

namespace plumbline::assets {
namespace {

/// A board with its long edges cut off at 45 degrees: each face has vertices of its own.
MeshData bevelled_board() {
    MeshData mesh;
    constexpr float kCut_m = 0.005F;
    const std::vector<Vec2f> outline{{-0.1F + kCut_m, -0.02F},
                                     {0.1F - kCut_m, -0.02F},
                                     {0.1F, -0.02F + kCut_m},
                                     {0.1F, 0.02F - kCut_m},
                                     {0.1F - kCut_m, 0.02F},
                                     {-0.1F + kCut_m, 0.02F},
                                     {-0.1F, 0.02F - kCut_m},
                                     {-0.1F, -0.02F + kCut_m}};
    const auto add = [&](const std::vector<Vec3f>& corners) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        const Vec3f normal =
            glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
        for (const Vec3f& corner : corners) {
            Vertex vertex;
            vertex.position_body = corner;
            vertex.normal_body = normal;
            mesh.vertices.push_back(vertex);
        }
        for (std::uint32_t k = 2; k < corners.size(); ++k)
            mesh.indices.insert(mesh.indices.end(), {first, first + k - 1, first + k});
    };
    std::vector<Vec3f> front;
    std::vector<Vec3f> back;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2f a = outline[i];
        const Vec2f b = outline[(i + 1) % outline.size()];
        add({{a.x, a.y, 1.0F}, {a.x, a.y, -1.0F}, {b.x, b.y, -1.0F}, {b.x, b.y, 1.0F}});
        front.emplace_back(a.x, a.y, 1.0F);
        back.insert(back.begin(), Vec3f{a.x, a.y, -1.0F});
    }
    add(front);
    add(back);
    return mesh;
}

TEST(MeshSimplify, ABallStaysWithinTheError) {
    const MeshData ball = sphere_mesh(1.0F);
    const auto fewer = simplified(ball.vertices, ball.indices, 0.05F);
    EXPECT_LT(fewer.size() * 2, ball.indices.size());
    for (std::size_t i = 0; i + 2 < fewer.size(); i += 3) {
        // A flat face is furthest inside at its middle.
        const Vec3f middle =
            (ball.vertices[fewer[i]].position_body + ball.vertices[fewer[i + 1]].position_body +
             ball.vertices[fewer[i + 2]].position_body) /
            3.0F;
        EXPECT_GT(glm::length(middle), 1.0F - 1.5F * 0.05F);
    }
}

TEST(MeshSimplify, ABallStaysClosed) {
    const MeshData ball = sphere_mesh(1.0F);
    auto fewer = ball.indices;
    for (const float error_m : {0.0015F, 0.003F, 0.006F, 0.0125F, 0.025F, 0.05F, 0.1F}) {
        fewer = simplified(ball.vertices, fewer, error_m);
        const auto place_of = [&](std::uint32_t vertex) {
            const glm::ivec3 cell{glm::round(ball.vertices[vertex].position_body * 1e4F)};
            return std::array<int, 3>{cell.x, cell.y, cell.z};
        };
        std::map<std::array<std::array<int, 3>, 2>, int> there_and_back;
        for (std::size_t i = 0; i + 2 < fewer.size(); i += 3) {
            for (std::size_t k = 0; k < 3; ++k) {
                const auto a = place_of(fewer[i + k]);
                const auto b = place_of(fewer[i + (k + 1) % 3]);
                if (a != b) there_and_back[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
            }
        }
        for (const auto& [edge, sum] : there_and_back) EXPECT_EQ(sum, 0) << error_m;
    }
}

TEST(MeshSimplify, AFineErrorChangesNothing) {
    const MeshData ball = sphere_mesh(1.0F);
    EXPECT_EQ(simplified(ball.vertices, ball.indices, 1e-6F).size(), ball.indices.size());
}

TEST(MeshSimplify, BevelsGoAndFacesKeepTheirNormals) {
    const MeshData board = bevelled_board();
    EXPECT_EQ(board.indices.size() / 3, 28U);
    const auto fewer = simplified(board.vertices, board.indices, 0.02F);
    EXPECT_LE(fewer.size() / 3, 14U);
    EXPECT_GE(fewer.size() / 3, 8U);
    for (std::size_t i = 0; i + 2 < fewer.size(); i += 3) {
        const Vec3f& a = board.vertices[fewer[i]].position_body;
        const Vec3f normal =
            glm::normalize(glm::cross(board.vertices[fewer[i + 1]].position_body - a,
                                      board.vertices[fewer[i + 2]].position_body - a));
        for (std::size_t k = i; k < i + 3; ++k)
            EXPECT_GT(glm::dot(board.vertices[fewer[k]].normal_body, normal), 0.6F);
    }
}

TEST(MeshSimplify, OpenSheetsKeepTheirOutline) {
    // 20 x 20 squares of 5 cm: a metre square, flat, so two triangles would do.
    MeshData sheet;
    for (std::uint32_t i = 0; i < 441; ++i) {
        Vertex vertex;
        vertex.position_body = {
            0.05F * static_cast<float>(i % 21), 0.0F, 0.05F * static_cast<float>(i / 21)};
        sheet.vertices.push_back(vertex);
    }
    for (std::uint32_t z = 0; z < 20; ++z) {
        for (std::uint32_t x = 0; x < 20; ++x) {
            const std::uint32_t i = z * 21 + x;
            sheet.indices.insert(sheet.indices.end(), {i, i + 21, i + 1, i + 1, i + 21, i + 22});
        }
    }
    const auto fewer = simplified(sheet.vertices, sheet.indices, 0.001F);
    EXPECT_LT(fewer.size() / 3, 50U);
    float area = 0.0F;
    for (std::size_t i = 0; i + 2 < fewer.size(); i += 3) {
        const Vec3f& a = sheet.vertices[fewer[i]].position_body;
        area += 0.5F * glm::length(glm::cross(sheet.vertices[fewer[i + 1]].position_body - a,
                                              sheet.vertices[fewer[i + 2]].position_body - a));
    }
    EXPECT_NEAR(area, 1.0F, 1e-4F);
}

TEST(MeshSimplify, NothingStaysNothing) {
    EXPECT_TRUE(simplified({}, {}, 1.0F).empty());
    const std::vector<Vertex> point(3);
    EXPECT_LE(simplified(point, {0, 1, 2}, 1.0F).size(), 3U);
}

}  // namespace
}  // namespace plumbline::assets
