// Colliders of glTF files as shapes: primitives, scales, meshes.
#include "tests/engine/scene/gltf_scene/gltf_fixture.h"

#include <cmath>

namespace plumbline::scene::gltf {
namespace {

/// A standing collider of this shape, on a node of this scale.
ReadGltf standing(const char* type, Json fields, Json scale = {1, 1, 1}) {
    PhysicsFile file;
    file.add_body(
        "it", {0, 0, 0}, {{"collider", PhysicsFile::collider(file.add_shape(type, fields))}});
    file.json["nodes"][0]["scale"] = std::move(scale);
    ReadGltf read = file.read();
    EXPECT_TRUE(read.scene.ok()) << read.said();
    return read;
}

TEST(GltfShapes, AreTheTextsFour) {
    EXPECT_EQ(standing("box", {{"size", {1, 2, 3}}}).shape<physics::BoxShape>("it").size_m,
              Vec3(1, 2, 3));
    EXPECT_EQ(standing("sphere", {{"radius", 2}}).shape<physics::SphereShape>("it").radius_m,
              Real{2});
    const Json even{{"height", 2}, {"radiusBottom", 0.5}, {"radiusTop", 0.5}};
    const auto capsule = standing("capsule", even).shape<physics::CapsuleShape>("it");
    EXPECT_EQ(capsule.height_m, Real{2}) << "between the centres of the caps";
    EXPECT_EQ(standing("cylinder", even).shape<physics::CylinderShape>("it").radius_m, 0.5_r);
    const Json pointed{{"height", 2}, {"radiusBottom", 0.5}, {"radiusTop", 0}};
    EXPECT_EQ(standing("cylinder", pointed).shape<physics::ConeShape>("it").height_m, Real{2});
}

TEST(GltfShapes, WithDifferentEndsAreHulls) {
    const Json uneven{{"height", 2}, {"radiusBottom", 1}, {"radiusTop", 0.25}};
    for (const char* type : {"cylinder", "capsule"}) {
        const auto hull = standing(type, uneven).shape<physics::HullShape>("it");
        double low = 0;
        double high = 0;
        double wide = 0;
        for (const Vec3& point : hull.points_m) {
            low = std::min(low, num(point.y));
            high = std::max(high, num(point.y));
            wide = std::max(wide, std::hypot(num(point.x), num(point.z)));
        }
        const bool is_capsule = std::string_view(type) == "capsule";
        EXPECT_NEAR(low, is_capsule ? -2 : -1, 1e-5);
        EXPECT_NEAR(high, is_capsule ? 1.25 : 1, 1e-5);
        EXPECT_NEAR(wide, 1, 1e-5);
    }
}

TEST(GltfShapes, TakeTheirNodesScaleWithoutItsSign) {
    EXPECT_EQ(
        standing("box", {{"size", {1, 1, 1}}}, {1, -2, 3}).shape<physics::BoxShape>("it").size_m,
        Vec3(1, 2, 3));
    EXPECT_EQ(
        standing("sphere", {{"radius", 1}}, {2, 2, 2}).shape<physics::SphereShape>("it").radius_m,
        Real{2});
    const auto egg = standing("sphere", {{"radius", 1}}, {1, 2, 1}).shape<physics::HullShape>("it");
    double high = 0;
    for (const Vec3& point : egg.points_m) high = std::max(high, num(point.y));
    EXPECT_NEAR(high, 2, 1e-5);
}

TEST(GltfShapes, ShearWithTheScaleOfWhatTheyHangOn) {
    PhysicsFile file;
    const std::size_t parent = file.add_node({{"name", "parent"}, {"scale", {2, 1, 1}}});
    file.add_child(
        parent,
        file.add_body(
            "it", {0, 0, 0}, {{"collider", PhysicsFile::collider(file.add_box(1, 1, 1))}}));
    file.json["nodes"][1]["rotation"] = {0, 0, std::sin(0.3927), std::cos(0.3927)};  // 45 degrees
    const ReadGltf read = file.read();
    ASSERT_TRUE(read.scene.ok()) << read.said();
    const auto hull = read.shape<physics::HullShape>("it");
    ASSERT_EQ(hull.points_m.size(), 8U);
    double wide = 0;
    const EntityDescription& it = read.entity("it");
    for (const Vec3& point : hull.points_m)
        wide = std::max(wide, num(transform_point(it.world_from_body, point).x));
    EXPECT_NEAR(wide, std::sqrt(2.0), 1e-3) << "half a diagonal, twice as wide";
}

TEST(GltfShapes, OfMeshesAreHullsOrTriangles) {
    PhysicsFile file;
    const std::size_t mesh = file.add_cube_mesh();
    const std::size_t apart = file.add_node({{"mesh", mesh}});  // in no scene: there to be named
    const auto named = [&](bool hull) {
        return Json{{"geometry", {{"node", apart}, {"convexHull", hull}}}};
    };
    file.add_body("hull", {0, 0, 0}, {{"collider", named(true)}});
    file.add_body("mesh", {9, 0, 0}, {{"collider", named(false)}});
    file.add_body("moving", {18, 0, 0}, {{"motion", Json::object()}, {"collider", named(false)}});
    file.add_body("direct", {27, 0, 0}, {{"collider", {{"geometry", {{"mesh", mesh}}}}}});
    file.json["scenes"] = {{{"nodes", {1, 2, 3, 4}}}};
    const ReadGltf read = file.read();
    ASSERT_TRUE(read.scene.ok()) << read.said();
    EXPECT_EQ(read.shape<physics::HullShape>("hull").points_m.size(), 8U);
    EXPECT_EQ(read.shape<physics::MeshShape>("mesh").triangles.size(), 12U);
    EXPECT_EQ(read.shape<physics::MeshShape>("direct").triangles.size(), 12U);
    EXPECT_EQ(read.shape<physics::HullShape>("moving").points_m.size(), 8U);
    EXPECT_NE(read.said().find("moving: its mesh has no inside"), std::string::npos) << read.said();
}

}  // namespace
}  // namespace plumbline::scene::gltf
