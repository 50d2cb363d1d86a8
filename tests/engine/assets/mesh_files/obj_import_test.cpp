// OBJ files with their materials and a texture folder of their own.

#include "tests/engine/assets/fixture.h"

#include <fmt/format.h>

namespace plumbline::assets::test {
namespace {

constexpr std::string_view kSquare =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
    "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\n";

TEST(ObjImport, lets_v_run_down_the_image_and_shares_vertices) {
    const Import import =
        import_bytes(fmt::format("{}f 1/1/1 2/2/1 3/3/1 4/4/1\n", kSquare), "a.obj");
    ASSERT_TRUE(import.ok()) << import.error();
    EXPECT_EQ(import.mesh().vertices.size(), 4U);
    EXPECT_EQ(import.mesh().indices.size(), 6U);
    for (const Vertex& vertex : import.mesh().vertices) {
        // OBJ's v runs up, as the square's y does.
        EXPECT_EQ(vertex.uv, Vec2f(vertex.position_body.x, 1.0F - vertex.position_body.y));
        EXPECT_EQ(vertex.normal_body, Vec3f(0, 0, 1));
    }
}

TEST(ObjImport, reads_numbers_that_count_back_and_lines_that_go_on) {
    const Import import = import_bytes("v 0 0 0\nv +1 0 0\nv 0 1e0 0\nf -3 \\\n -2 -1\n", "a.obj");
    ASSERT_TRUE(import.ok()) << import.error();
    EXPECT_EQ(import.mesh().indices.size(), 3U);
    EXPECT_EQ(import.mesh().bounds.max, Vec3f(1, 1, 0));
    EXPECT_EQ(import.mesh().vertices[0].normal_body, Vec3f(0, 0, 1));  // made: the file has none
}

TEST(ObjImport, takes_a_plain_material_where_the_library_is_missing) {
    const Import import =
        import_bytes("mtllib none.mtl\n" + std::string(kSquare) + "usemtl a\nf 1 2 3\n", "a.obj");
    ASSERT_TRUE(import.ok()) << import.error();
    ASSERT_EQ(import.materials().size(), 1U);
    EXPECT_EQ(import.materials()[0].name, "a");
    EXPECT_EQ(import.materials()[0].base_color, Vec3f(1, 1, 1));
    EXPECT_TRUE(contains(import.log, "none.mtl")) << import.log;
    EXPECT_TRUE(contains(import.log, "no file has its material \"a\"; it is plain")) << import.log;
}

TEST(ObjImport, takes_the_plain_material_for_faces_before_any_usemtl) {
    const Import import = import_bytes(fmt::format("{}f 1 2 3\n", kSquare), "a.obj");
    ASSERT_TRUE(import.ok()) << import.error();
    ASSERT_EQ(import.materials().size(), 1U);
    EXPECT_EQ(import.materials()[0].name, "default");
}

TEST(ObjImport, leaves_out_faces_with_vertices_that_are_missing_or_not_finite) {
    const Import import = import_bytes(
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 0\nv 1e999 0 0\n"
        "f 1 2 3\nf 1 2 4\nf 1 2 5\nf 1 2 6\nf 1 2 0\nf 1 2\nf 1 2 x\nf 1 2 -9\n",
        "a.obj");
    ASSERT_TRUE(import.ok()) << import.error();
    EXPECT_EQ(import.mesh().indices.size(), 3U);
    EXPECT_TRUE(contains(import.log, "7 faces that name vertices it lacks")) << import.log;
}

TEST(ObjImport, refuses_what_is_no_obj) {
    using namespace std::string_view_literals;
    EXPECT_TRUE(contains(import_bytes("", "a.obj").error(), "it holds no triangles"));
    EXPECT_TRUE(contains(import_bytes("<html>", "a.obj").error(), "it holds no triangles"));
    EXPECT_TRUE(
        contains(import_bytes("v 0 0\0 0\n"sv, "a.obj").error(), "its content is not OBJ text"));
}

TEST(ObjImport, triangulates_a_polygon_that_is_not_convex) {
    // An arrow head of area 3/4.
    const Import import =
        import_bytes("v 0 0 0\nv 1 1 0\nv 0 2 0\nv 0.25 1 0\nf 1 2 3 4\n", "a.obj");
    ASSERT_TRUE(import.ok()) << import.error();
    float area = 0;
    const MeshData& mesh = import.mesh();
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Vec3f a = mesh.vertices[mesh.indices[i]].position_body;
        area += glm::cross(mesh.vertices[mesh.indices[i + 1]].position_body - a,
                           mesh.vertices[mesh.indices[i + 2]].position_body - a)
                    .z /
                2;
    }
    EXPECT_NEAR(area, 0.75, 1e-6);
}

TEST(ObjImport, shows_colours_behind_the_places) {
    const Import import =
        import_bytes("v 0 0 0 1 0 0\nv 1 0 0 0 0.5 0\nv 0 1 0 0 0 1\nf 1 2 3\n", "m.obj");
    ASSERT_TRUE(import.ok()) << import.error();
    EXPECT_EQ(import.mesh().vertices[0].color, Vec3f(1, 0, 0));
    EXPECT_NEAR(import.mesh().vertices[1].color.y, 0.21404F, 1e-4);
    EXPECT_TRUE(import.materials()[0].vertex_colors);
}

TEST(ObjImport, finds_materials_and_textures_through_folders_backslashes_and_spaces) {
    const TempFolder folder;
    folder.write("objects/nature/nature set.mtl",
                 "newmtl old bark\r\nKd 0.5 0.25 0.125\r\nPr 0.75\r\n"
                 "map_Kd textures\\bark brown 01.png\r\n"
                 "map_Bump -bm 0.5 textures\\bark brown 01 n.png\r\n"
                 "newmtl Leaf\r\nmap_Kd -s 1 1 1 -clamp on textures/Leaf.png\r\n"
                 "map_d textures\\Leaf.png\r\nNs 62\r\nd 1\r\n"
                 "newmtl pond\r\nd 0.5\r\n");
    folder.write("objects/nature/textures/bark brown 01.png", "");
    const Import import(folder.write("objects/nature/nature.obj",
                                     "mtllib nature set.mtl\r\no thing\r\n" + std::string(kSquare) +
                                         "usemtl old bark\r\nf 1/1/1 2/2/1 3/3/1 4/4/1\r\n"
                                         "usemtl Leaf\r\nf 1/1/1 2/2/1 3/3/1\r\n"),
                        folder.path());
    ASSERT_TRUE(import.ok()) << import.error();
    ASSERT_EQ(import.materials().size(), 3U);
    const MaterialData& bark = import.materials()[0];
    const fs::path textures = folder.path() / "objects/nature/textures";
    EXPECT_EQ(bark.name, "old bark");
    EXPECT_EQ(bark.base_color, Vec3f(0.5F, 0.25F, 0.125F));
    EXPECT_EQ(bark.roughness, 0.75F);
    EXPECT_EQ(bark.base_color_map, textures / "bark brown 01.png");
    EXPECT_EQ(bark.normal_map, textures / "bark brown 01 n.png");
    EXPECT_EQ(bark.alpha_mode, AlphaMode::Opaque);
    const MaterialData& leaf = import.materials()[1];
    EXPECT_EQ(leaf.name, "Leaf");
    EXPECT_EQ(leaf.base_color_map, textures / "Leaf.png");
    EXPECT_EQ(leaf.alpha_mode, AlphaMode::Mask);
    EXPECT_TRUE(leaf.two_sided);
    EXPECT_NEAR(leaf.roughness, std::pow(2.0 / 64, 0.25), 1e-6);
    EXPECT_EQ(import.materials()[2].alpha_mode, AlphaMode::Blend);
    EXPECT_EQ(import.materials()[2].alpha, 0.5F);
    ASSERT_EQ(import.mesh().sub_meshes.size(), 2U);
    EXPECT_EQ(import.mesh().sub_meshes[0].index_count, 6U);
    EXPECT_EQ(import.mesh().sub_meshes[0].material, 0U);
    EXPECT_EQ(import.mesh().sub_meshes[1].index_count, 3U);
    EXPECT_EQ(import.mesh().sub_meshes[1].material, 1U);
    EXPECT_EQ(import.log, "");
}

}  // namespace
}  // namespace plumbline::assets::test
