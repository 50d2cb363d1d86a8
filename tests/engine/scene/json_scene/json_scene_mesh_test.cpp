// Triangles of JSON scenes.
#include "tests/engine/scene/json_scene/json_scene_fixture.h"

#include <cmath>

namespace plumbline::scene {
namespace {

TEST_F(JsonFault, OfInlineTriangles) {
    const std::string at = "a.json: error: objects[1]";
    EXPECT_EQ(said_of_object(R"("vertices": [0,0,0, 1,0,0, 0,1,0], "faces": [0,1,2, 0,1,3])"),
              at + ".faces[5]: face 1 names vertex 3; there are 3");
    EXPECT_EQ(said_of_object(R"("vertices": [0,0,0, 1,0,0, 0,1,0], "faces": [0,-1,2])"),
              at + ".faces[1]: face 0 names vertex -1; there are 3");
    EXPECT_EQ(said_of_object(R"("vertices": [0,0,0, 1,0,0, 0,1,0], "faces": [0,1.5,2])"),
              at + ".faces[1]: face 0 names vertex 1.5; there are 3");
    EXPECT_EQ(said_of_object(R"("vertices": [0,0,0,0], "faces": [])"),
              at + ".vertices: 4 numbers are not whole triples");
    EXPECT_EQ(said_of_object(R"("vertices": [0,0,0], "faces": [], "vertex_colors": [])"),
              at + ".vertex_colors: 0 colours for 1 vertices; expected as many");
    EXPECT_EQ(said_of_object(R"("vertices": [0,1e300,0], "faces": [])"),
              at + ".vertices: vertex 0 is too large for a float");
}

TEST_F(JsonFault, NormalsStayAcrossUnevenScalesAndMirrors) {
    write("n.ply",
          "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
          "float z\nproperty float nx\nproperty float ny\nproperty float nz\nelement face 1\n"
          "property list uchar uint vertex_indices\nend_header\n"
          "0 0 0 0.6 0.8 0\n1 0 0 0.6 0.8 0\n0 0 1 0.6 0.8 0\n3 0 2 1\n");
    write("a.json", one_object(R"("filename": "n.ply", "transform": [{"scale": [2, -1, 3]}])"));
    const Outcome outcome = load_file("a.json");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    // (0.6 / 2, 0.8 / -1, 0), made unit.
    expect_near_f(mesh_of(*outcome.scene, 0).vertices[0].normal_body,
                  Vec3f(0.3F, -0.8F, 0) / std::sqrt(0.73F));
}

// A scale of zero has no inverse; the cofactors still know which way the flattened side looks.
TEST_F(JsonFault, FlattenedMeshesKeepTheirNormal) {
    write("a.json", one_object(R"("vertices": [0,0,0, 1,0,0, 0,1,0, 0,0,0], "faces": [0,1,2, 0,3,0],
            "transform": [{"scale": [2, 2, 0]}])"));
    const Outcome outcome = load_file("a.json");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    const assets::MeshData& mesh = mesh_of(*outcome.scene, 0);
    expect_near_f(mesh.vertices[0].normal_body, {0, 0, 1});
    expect_near_f(mesh.vertices[3].normal_body, {0, 1, 0});  // a point has none: upwards
    EXPECT_EQ(mesh.sub_meshes.at(0).index_count, 6U);
}

}  // namespace
}  // namespace plumbline::scene
