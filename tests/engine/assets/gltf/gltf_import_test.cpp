// glTF files that load, and what is kept of files with single faults.

#include "engine/core/limits.h"
#include "tests/engine/assets/fixture.h"

#include <limits>

namespace plumbline::assets::test {
namespace {

TEST(GltfImport, reads_positions_normals_texture_coordinates_and_bounds) {
    const Import import = import_bytes(TriangleFile{}.gltf());
    ASSERT_TRUE(import.ok()) << import.error();
    const MeshData& mesh = import.mesh();
    ASSERT_EQ(mesh.vertices.size(), 3U);
    EXPECT_EQ(mesh.indices, (std::vector<std::uint32_t>{0, 1, 2}));
    EXPECT_EQ(mesh.vertices[1].position_body, Vec3f(1, 0, 0));
    EXPECT_EQ(mesh.vertices[1].normal_body, Vec3f(0, 0, 1));
    // v runs down the image in the file and in memory alike.
    EXPECT_EQ(mesh.vertices[0].uv, Vec2f(0, 1));
    EXPECT_EQ(mesh.vertices[2].uv, Vec2f(0, 0.25F));
    EXPECT_EQ(mesh.vertices[0].tangent_body, Vec4f(1, 0, 0, 1));
    EXPECT_EQ(mesh.bounds.min, Vec3f(0, 0, 0));
    EXPECT_EQ(mesh.bounds.max, Vec3f(1, 1, 0));
    EXPECT_EQ(import.log, "");
}

TEST(GltfImport, reads_the_same_from_a_glb_and_under_a_wrong_one_of_the_two_names) {
    const Import plain = import_bytes(TriangleFile{}.glb(), "m.glb");
    const Import renamed = import_bytes(TriangleFile{}.glb(), "m.gltf");
    ASSERT_TRUE(plain.ok()) << plain.error();
    ASSERT_TRUE(renamed.ok()) << renamed.error();
    EXPECT_EQ(plain.mesh().vertices.size(), 3U);
    EXPECT_EQ(renamed.mesh().vertices.size(), 3U);
}

TEST(GltfImport, only_warns_of_extensions_that_a_file_merely_uses) {
    TriangleFile file;
    file.json["extensionsUsed"] = {"EXT_strange"};
    const Import import = import_bytes(file.gltf());
    EXPECT_TRUE(import.ok());
    EXPECT_TRUE(contains(import.log, "the extension EXT_strange is ignored")) << import.log;
}

// Blender demands its lamps; a scene is worth showing without them.
TEST(GltfImport, leaves_out_lights_that_a_file_requires) {
    TriangleFile file;
    file.json["extensionsUsed"] = file.json["extensionsRequired"] = {"KHR_lights_punctual"};
    const Import import = import_bytes(file.gltf());
    EXPECT_TRUE(import.ok()) << import.error();
    EXPECT_TRUE(contains(import.log, "the extension KHR_lights_punctual is ignored")) << import.log;
}

// EXPERIENCE G15: the drafts and the text of KHR are read; its twin of another house is scenery, and a line says so.
TEST(GltfImport, reads_the_physics_of_khr_of_three_years_and_ignores_its_twin) {
    const Json boxes{{"shapes", {{{"type", "box"}, {"box", {{"size", {1, 1, 1}}}}}}}};
    struct Shape {
        const char* bodies;
        const char* shapes;
        const char* node;
    };
    for (const Shape& shape :
         {Shape{"KHR_rigid_bodies",  // 2024
                "KHR_collision_shapes",
                R"({"motion": {"mass": 2}, "collider": {"shape": 0}})"},
          Shape{"KHR_physics_rigid_bodies",  // 2025
                "KHR_implicit_shapes",
                R"({"motion": {"mass": 2}, "collider": {"geometry": {"shape": 0}}})"},
          Shape{"KHR_physics_rigid_bodies",
                "KHR_implicit_shapes",
                R"({"motion": {"isKinematic": true}, "collider": {"geometry": {"node": 0}}})"},
          Shape{"KHR_physics_rigid_bodies",  // 2026
                "KHR_implicit_shapes",
                R"({"motion": {}, "collider": {"geometry": {"mesh": 0}}})"},
          Shape{"OMI_physics_body",
                "OMI_physics_shape",
                R"({"motion": {"type": "dynamic", "mass": 2}, "collider": {"shape": 0}})"}}) {
        TriangleFile file;
        file.json["extensionsUsed"] = {shape.bodies, shape.shapes};
        file.json["extensions"][shape.shapes] = boxes;
        file.json["nodes"][0]["extensions"][shape.bodies] = Json::parse(shape.node);
        const Import import = import_bytes(file.gltf());
        ASSERT_TRUE(import.ok()) << shape.bodies << ": " << import.error();
        EXPECT_EQ(import.mesh().vertices.size(), 3U) << "it is seen in any case";
        const bool is_read = !std::string_view(shape.bodies).starts_with("OMI");
        EXPECT_EQ(import.model->physics.motions.size(), is_read ? 1U : 0U) << shape.node;
        EXPECT_EQ(import.model->physics.colliders.size(), is_read ? 1U : 0U) << shape.node;
        EXPECT_EQ(contains(import.log, "is ignored"), !is_read) << import.log;
        file.json["extensionsRequired"] = {shape.bodies};
        EXPECT_EQ(import_bytes(file.gltf()).ok(), is_read);
    }
}

}  // namespace
}  // namespace plumbline::assets::test
