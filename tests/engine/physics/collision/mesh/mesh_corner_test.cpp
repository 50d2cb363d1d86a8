// Points of things on meshes.
#include "tests/engine/physics/test_world.h"

namespace plumbline::physics {
namespace {

/// Floor and walls of one mesh: each face keeps its own contact points.
TEST(MeshContact, BoxInACornerOfARoomRests) {
    MeshShape room = flat_mesh(4, 1);
    const auto wall = [&room](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
        const auto first = static_cast<std::uint32_t>(room.vertices_m.size());
        for (const Vec3& corner : {a, b, c, d}) room.vertices_m.push_back(corner);
        room.triangles.push_back({first, first + 1, first + 2});
        room.triangles.push_back({first, first + 2, first + 3});
    };
    wall({2, 0, -2}, {2, 0, 2}, {2, 3, 2}, {2, 3, -2});
    wall({-2, 0, 2}, {-2, 3, 2}, {2, 3, 2}, {2, 0, 2});
    TestWorld test(in_small_steps());
    test.add(room, {0, 0, 0}, {.kind = BodyKind::Static});
    const BodyId box = test.add(BoxShape{}, {1.4_r, 0.6_r, 1.4_r});
    for (int i = 0; i < 240; ++i) {
        test.world.apply_force(box, {6, 0, 6});
        test.world.step();
    }
    EXPECT_NEAR(test.at(box).x, 1.5, 0.01);
    EXPECT_NEAR(test.at(box).z, 1.5, 0.01);
    EXPECT_NEAR(test.at(box).y, 0.5, 0.01);
    // Pressed against two walls for good, Gauss-Seidel leaves a tremble that moves nothing.
    EXPECT_LT(glm::length(test.velocity(box)), 0.01);
    EXPECT_LT(glm::length(test.spin(box)), 0.01);
}

/// Points that a body rests on, after a while on a mesh of small triangles.
std::uint32_t points_under(const ShapeDef& shape, Real height_m) {
    TestWorld test(in_small_steps());
    test.add(flat_mesh(9, 0.17_r), {0, 0, 0}, {.kind = BodyKind::Static});
    test.add(shape, {0.03_r, height_m, 0.02_r}, {.kind = BodyKind::Dynamic, .can_sleep = false});
    test.run(0.5);
    EXPECT_EQ(test.world.report().islands.size(), 1U);
    return test.world.report().islands.empty() ? 0 : test.world.report().islands[0].contacts;
}

// A box of 1 m lies on some seventy triangles; the four points that carry best are enough.
TEST(MeshPoints, OneFaceHasFourPointsHoweverManyTriangles) {
    EXPECT_EQ(points_under(BoxShape{}, 0.5_r), 4U);
    EXPECT_EQ(points_under(CylinderShape{}, 0.5_r), 4U);
    EXPECT_EQ(points_under(SphereShape{}, 0.5_r), 1U);
}

}  // namespace
}  // namespace plumbline::physics
