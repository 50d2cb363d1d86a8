// Generated meshes against the closed forms of the polyhedra that they are.

#include "engine/assets/primitives.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

namespace plumbline::assets {
namespace {

constexpr double kPiD = 3.14159265358979323846;
constexpr double kSides = 32;  // segments around the axis
constexpr double kRings = 16;  // from pole to pole
// A regular polygon of that many sides inside a circle of radius 1.
const double kPolygonArea = 0.5 * kSides * std::sin(2 * kPiD / kSides);
const double kChord = 2 * std::sin(kPiD / kSides);
const double kApothem = std::cos(kPiD / kSides);

/// Area and, by the divergence theorem, enclosed volume: positive when triangles face outwards.
struct Measure {
    double area{0};
    double volume{0};
};

Measure measure(const MeshData& mesh) {
    Measure sum;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Vec3d a{mesh.vertices[mesh.indices[i]].position_body};
        const Vec3d b{mesh.vertices[mesh.indices[i + 1]].position_body};
        const Vec3d c{mesh.vertices[mesh.indices[i + 2]].position_body};
        sum.area += glm::length(glm::cross(b - a, c - a)) / 2;
        sum.volume += glm::dot(a, glm::cross(b, c)) / 6;
    }
    return sum;
}

/// The frustum between two rings: r and y of each.
Measure frustum(double r0, double y0, double r1, double y1) {
    const double height = y0 - y1;
    const double slant = std::hypot(height, (r0 - r1) * kApothem);
    return {.area = kSides * kChord * (r0 + r1) / 2 * slant,
            .volume = kPolygonArea * height * (r0 * r0 + r0 * r1 + r1 * r1) / 3};
}

Measure sphere_forms(double radius) {
    Measure sum;
    for (double i = 0; i < kRings; ++i) {
        const double upper = kPiD * i / kRings;
        const double lower = kPiD * (i + 1) / kRings;
        const Measure slice = frustum(radius * std::sin(upper),
                                      radius * std::cos(upper),
                                      radius * std::sin(lower),
                                      radius * std::cos(lower));
        sum.area += slice.area;
        sum.volume += slice.volume;
    }
    return sum;
}

struct Case {
    std::string name;
    std::function<MeshData()> make;
    Measure expected;
    Vec3f size_m;
};

void PrintTo(const Case& shape, std::ostream* out) {
    *out << shape.name;
}

std::vector<Case> cases() {
    const Measure ball = sphere_forms(0.5);
    const Measure tube = frustum(0.5, 2, 0.5, 0);
    const double disc = 0.25 * kPolygonArea;
    const Measure cone = frustum(0, 1.5, 0.5, 0);
    return {{"box",
             [] {
                 return box_mesh({1, 2, 3});
             },
             {22, 6},
             {1, 2, 3}},
            {"sphere", [] { return sphere_mesh(0.5F); }, ball, {1, 1, 1}},
            {"cylinder",
             [] { return cylinder_mesh(0.5F, 2); },
             {tube.area + 2 * disc, tube.volume},
             {1, 2, 1}},
            {"capsule",
             [] { return capsule_mesh(0.5F, 2); },
             {tube.area + ball.area, tube.volume + ball.volume},
             {1, 3, 1}},
            {"cone",
             [] { return cone_mesh(0.5F, 1.5F); },
             {cone.area + disc, cone.volume},
             {1, 1.5F, 1}},
            {"plane",
             [] {
                 return plane_mesh({4, 6});
             },
             {24, 0},
             {4, 0, 6}}};
}

class Primitive : public ::testing::TestWithParam<Case> {};

TEST_P(Primitive, has_area_and_volume_of_its_closed_form) {
    const Measure found = measure(GetParam().make());
    EXPECT_NEAR(found.area, GetParam().expected.area, 2e-6 * GetParam().expected.area);
    EXPECT_NEAR(found.volume, GetParam().expected.volume, 2e-6 * GetParam().expected.area);
}

TEST_P(Primitive, is_centred_and_as_large_as_asked) {
    const MeshData mesh = GetParam().make();
    EXPECT_NEAR(glm::length(mesh.bounds.center()), 0, 1e-6);
    EXPECT_NEAR(glm::length(mesh.bounds.size() - GetParam().size_m), 0, 1e-6);
}

TEST_P(Primitive, has_unit_normals_on_the_outer_side_of_every_triangle) {
    const MeshData mesh = GetParam().make();
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Vertex& a = mesh.vertices[mesh.indices[i]];
        const Vertex& b = mesh.vertices[mesh.indices[i + 1]];
        const Vertex& c = mesh.vertices[mesh.indices[i + 2]];
        const Vec3f face = glm::normalize(
            glm::cross(b.position_body - a.position_body, c.position_body - a.position_body));
        for (const Vertex* vertex : {&a, &b, &c}) {
            EXPECT_NEAR(glm::length(vertex->normal_body), 1, 1e-5);
            EXPECT_GT(glm::dot(face, vertex->normal_body), 0.97F);
        }
    }
}

TEST_P(Primitive, has_orthogonal_tangents_along_u_and_an_image_that_is_not_mirrored) {
    const MeshData mesh = GetParam().make();
    for (const Vertex& vertex : mesh.vertices) {
        const Vec3f tangent{vertex.tangent_body};
        EXPECT_NEAR(glm::length(tangent), 1, 1e-5);
        EXPECT_NEAR(glm::dot(tangent, vertex.normal_body), 0, 1e-5);
        EXPECT_EQ(vertex.tangent_body.w, 1.0F);
    }
}

TEST_P(Primitive, keeps_the_texture_at_one_metre_a_unit) {
    const MeshData mesh = GetParam().make();
    double area_uv = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Vec2f a = mesh.vertices[mesh.indices[i]].uv;
        const Vec2f b = mesh.vertices[mesh.indices[i + 1]].uv - a;
        const Vec2f c = mesh.vertices[mesh.indices[i + 2]].uv - a;
        // v runs down, so outer triangles turn the other way in the image.
        const double twice_area = static_cast<double>(b.x * c.y) - static_cast<double>(c.x * b.y);
        EXPECT_LT(twice_area, 1e-9);
        area_uv -= twice_area / 2;
    }
    // Where a surface closes to a point the map is stretched: there only more can come.
    EXPECT_GE(area_uv, GetParam().expected.area * 0.999);
}

TEST_P(Primitive, has_one_sub_mesh_over_all_indices) {
    const MeshData mesh = GetParam().make();
    ASSERT_EQ(mesh.sub_meshes.size(), 1U);
    EXPECT_EQ(mesh.sub_meshes[0].first_index, 0U);
    EXPECT_EQ(mesh.sub_meshes[0].index_count, mesh.indices.size());
}

std::string name_of(const ::testing::TestParamInfo<Case>& shape) {
    return shape.param.name;
}

INSTANTIATE_TEST_SUITE_P(All, Primitive, ::testing::ValuesIn(cases()), name_of);

TEST(PrimitivePlane, has_its_top_at_zero_and_faces_up) {
    for (const Vertex& vertex : plane_mesh({2, 2}).vertices) {
        EXPECT_EQ(vertex.position_body.y, 0.0F);
        EXPECT_EQ(vertex.normal_body, Vec3f(0, 1, 0));
    }
}

TEST(PrimitiveSphere, has_normals_along_the_radius) {
    for (const Vertex& vertex : sphere_mesh(2).vertices) {
        EXPECT_NEAR(glm::length(vertex.normal_body - vertex.position_body / 2.0F), 0, 0.05);
    }
}

}  // namespace
}  // namespace plumbline::assets
