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

TEST(GltfImport, applies_transforms_down_the_tree) {
    TriangleFile file;
    // Turned a quarter about y, moved by 10 along the turned x, and both doubled by the parent.
    const double half = std::sqrt(0.5);
    file.json["nodes"] = {
        {{"scale", {2, 2, 2}}, {"children", {1}}},
        {{"mesh", 0}, {"translation", {10, 0, 0}}, {"rotation", {0, half, 0, half}}}};
    const Import import = import_bytes(file.gltf());
    ASSERT_TRUE(import.ok()) << import.error();
    const Vertex& corner = import.mesh().vertices[1];  // (1, 0, 0) goes to (0, 0, -1)
    EXPECT_NEAR(glm::length(corner.position_body - Vec3f(20, 0, -2)), 0, 1e-5);
    EXPECT_NEAR(glm::length(corner.normal_body - Vec3f(1, 0, 0)), 0, 1e-6);
}

TEST(GltfImport, turns_normals_by_the_inverse_transpose) {
    TriangleFile file;
    file.bytes.replace(36, 36, std::string(36, '\0'));
    std::string normals;
    const float part = std::sqrt(0.5F);
    for (int i = 0; i < 3; ++i) append_bytes<float>(normals, {part, 0, part});
    file.bytes.replace(36, 36, normals);
    file.json["nodes"][0]["scale"] = {2, 1, 1};
    const Import import = import_bytes(file.gltf());
    ASSERT_TRUE(import.ok());
    const Vec3f expected = glm::normalize(Vec3f{0.5F, 0, 1});
    EXPECT_NEAR(glm::length(import.mesh().vertices[0].normal_body - expected), 0, 1e-6);
}

TEST(GltfImport, keeps_triangles_facing_outwards_when_a_node_mirrors) {
    TriangleFile file;
    file.json["nodes"][0]["scale"] = {-1, 1, 1};
    const Import import = import_bytes(file.gltf());
    ASSERT_TRUE(import.ok());
    const auto& v = import.mesh().vertices;
    const auto& i = import.mesh().indices;
    const Vec3f face = glm::cross(v[i[1]].position_body - v[i[0]].position_body,
                                  v[i[2]].position_body - v[i[0]].position_body);
    EXPECT_EQ(face, Vec3f(0, 0, 1));
    EXPECT_EQ(v[0].normal_body, Vec3f(0, 0, 1));
}

TEST(GltfImport, merges_every_instance_of_a_mesh) {
    TriangleFile file;
    file.json["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}, {"translation", {0, 0, 5}}}};
    file.json["scenes"][0]["nodes"] = {0, 1};
    const Import import = import_bytes(file.gltf());
    ASSERT_TRUE(import.ok());
    EXPECT_EQ(import.mesh().vertices.size(), 6U);
    EXPECT_EQ(import.mesh().sub_meshes.size(), 1U);
    EXPECT_EQ(import.mesh().sub_meshes[0].index_count, 6U);
    EXPECT_EQ(import.mesh().bounds.max.z, 5.0F);
}

TEST(GltfImport, lays_texture_coordinates_as_the_base_map_asks) {
    TriangleFile file;
    std::string second;
    append_bytes<float>(second, {0, 0, 1, 0, 0, 1});
    file.attributes()["TEXCOORD_1"] = file.add_accessor(second, 5126, 3, "VEC2");
    file.json["extensionsRequired"] = {"KHR_texture_transform"};
    file.json["images"] = {{{"uri", "a.png"}}};
    file.json["textures"] = {{{"source", 0}}};
    const Json transform = {{"offset", {0.5, 0.25}}, {"scale", {2, 4}}};
    const Json slot = {
        {"index", 0}, {"texCoord", 1}, {"extensions", {{"KHR_texture_transform", transform}}}};
    file.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", slot}}}}};
    file.primitive()["material"] = 0;
    const Import import = import_bytes(file.gltf());
    ASSERT_TRUE(import.ok()) << import.error();
    EXPECT_EQ(import.mesh().vertices[0].uv, Vec2f(0.5F, 0.25F));
    EXPECT_EQ(import.mesh().vertices[1].uv, Vec2f(2.5F, 0.25F));
    EXPECT_EQ(import.mesh().vertices[2].uv, Vec2f(0.5F, 4.25F));
}

TEST(GltfImport, reads_byte_texture_coordinates) {
    TriangleFile file;
    std::string uv;
    append_bytes<std::uint8_t>(uv, {0, 255, 0, 0, 51, 102, 0, 0, 255, 0, 0, 0});
    const std::size_t accessor = file.add_accessor(uv, 5121, 3, "VEC2");
    file.json["accessors"][accessor]["normalized"] = true;
    file.json["bufferViews"].back()["byteStride"] = 4;
    file.attributes()["TEXCOORD_0"] = accessor;
    const Import import = import_bytes(file.gltf());
    ASSERT_TRUE(import.ok()) << import.error();
    EXPECT_NEAR(glm::length(import.mesh().vertices[1].uv - Vec2f(0.2F, 0.4F)), 0, 1e-6);
    EXPECT_NEAR(glm::length(import.mesh().vertices[2].uv - Vec2f(1, 0)), 0, 1e-6);
}

TEST(GltfImport, reads_interleaved_vertices) {
    TriangleFile file;
    std::string vertices;
    append_bytes<float>(vertices, {0, 0, 0, 0, 0, 1, 3, 0, 0, 0, 0, 1, 0, 4, 0, 0, 0, 1});
    const std::size_t view = file.add_view(vertices);
    file.json["bufferViews"][view]["byteStride"] = 24;
    file.json["accessors"][0]["bufferView"] = view;
    file.json["accessors"][1]["bufferView"] = view;
    file.json["accessors"][1]["byteOffset"] = 12;
    const Import import = import_bytes(file.gltf());
    ASSERT_TRUE(import.ok()) << import.error();
    EXPECT_EQ(import.mesh().vertices[1].position_body, Vec3f(3, 0, 0));
    EXPECT_EQ(import.mesh().vertices[2].position_body, Vec3f(0, 4, 0));
    EXPECT_EQ(import.mesh().vertices[2].normal_body, Vec3f(0, 0, 1));
}

TEST(GltfImport, applies_sparse_values) {
    TriangleFile file;
    std::string indices;
    append_bytes<std::uint16_t>(indices, {2, 0});
    std::string values;
    append_bytes<float>(values, {0, 7, 0});
    const std::size_t index_view = file.add_view(indices);
    const std::size_t value_view = file.add_view(values);
    file.json["accessors"][0]["sparse"] = {
        {"count", 1},
        {"indices", {{"bufferView", index_view}, {"componentType", 5123}}},
        {"values", {{"bufferView", value_view}}}};
    const Import import = import_bytes(file.gltf());
    ASSERT_TRUE(import.ok()) << import.error();
    EXPECT_EQ(import.mesh().vertices[1].position_body, Vec3f(1, 0, 0));
    EXPECT_EQ(import.mesh().vertices[2].position_body, Vec3f(0, 7, 0));
}

TEST(GltfImport, reads_strips_and_fans) {
    for (const int mode : {5, 6}) {
        TriangleFile file;
        std::string corners;
        append_bytes<float>(corners, {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0});
        file.primitive()["mode"] = mode;
        file.primitive().erase("indices");
        file.primitive()["attributes"] = {
            {"POSITION", file.add_accessor(corners, 5126, 4, "VEC3")}};
        const Import import = import_bytes(file.gltf());
        ASSERT_TRUE(import.ok()) << import.error();
        EXPECT_EQ(import.mesh().indices.size(), 6U) << "mode " << mode;
    }
}

TEST(GltfImport, gives_flat_normals_to_a_file_without_any) {
    TriangleFile file;
    // Two triangles at a right angle that share an edge: four corners, six vertices when flat.
    std::string corners;
    append_bytes<float>(corners, {0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0});
    std::string indices;
    append_bytes<std::uint16_t>(indices, {0, 1, 2, 0, 3, 1});
    file.primitive()["attributes"] = {{"POSITION", file.add_accessor(corners, 5126, 4, "VEC3")}};
    file.primitive()["indices"] = file.add_accessor(indices, 5123, 6, "SCALAR");
    const Import import = import_bytes(file.gltf());
    ASSERT_TRUE(import.ok()) << import.error();
    ASSERT_EQ(import.mesh().vertices.size(), 6U);
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(import.mesh().vertices[import.mesh().indices[i]].normal_body,
                  i < 3 ? Vec3f(0, 1, 0) : Vec3f(1, 0, 0));
    }
}

TEST(GltfImport, mends_single_normals_that_are_zero_or_not_finite) {
    TriangleFile file;
    std::string normals;
    append_bytes<float>(normals, {0, 0, 0, 0, 1, 0, std::numeric_limits<float>::quiet_NaN(), 0, 0});
    file.bytes.replace(36, 36, normals);
    const Import import = import_bytes(file.gltf());
    ASSERT_TRUE(import.ok());
    EXPECT_EQ(import.mesh().vertices[0].normal_body, Vec3f(0, 0, 1));  // the triangle's
    EXPECT_EQ(import.mesh().vertices[1].normal_body, Vec3f(0, 1, 0));  // the file's
    EXPECT_EQ(import.mesh().vertices[2].normal_body, Vec3f(0, 0, 1));
}

/// The triangle as mesh 0, and as mesh 1 a copy that the caller spoils.
TriangleFile two_meshes() {
    TriangleFile file;
    file.json["meshes"].push_back(file.json["meshes"][0]);
    file.json["meshes"][1]["name"] = "spoilt";
    file.json["nodes"] = {{{"mesh", 0}}, {{"mesh", 1}}};
    file.json["scenes"][0]["nodes"] = {0, 1};
    return file;
}

TEST(GltfImport, leaves_out_a_mesh_whose_indices_pass_its_vertices) {
    TriangleFile file = two_meshes();
    std::string indices;
    append_bytes<std::uint16_t>(indices, {0, 1, 3});
    file.primitive(1)["indices"] = file.add_accessor(indices, 5123, 3, "SCALAR");
    const Import import = import_bytes(file.gltf());
    ASSERT_TRUE(import.ok()) << import.error();
    EXPECT_EQ(import.mesh().indices.size(), 3U);
    EXPECT_TRUE(
        contains(import.log, "meshes[1].primitives[0] is left out: index 2 names vertex 3 of 3"))
        << import.log;
}

TEST(GltfImport, leaves_out_a_mesh_with_vertices_that_are_not_finite) {
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        TriangleFile file = two_meshes();
        std::string corners;
        append_bytes<float>(corners, {0, 0, 0, 1, bad, 0, 0, 1, 0});
        file.primitive(1)["attributes"] = {
            {"POSITION", file.add_accessor(corners, 5126, 3, "VEC3")}};
        const Import import = import_bytes(file.gltf());
        ASSERT_TRUE(import.ok()) << import.error();
        EXPECT_EQ(import.mesh().indices.size(), 3U);
        EXPECT_TRUE(
            contains(import.log, "meshes[1].primitives[0] is left out: its vertex 1 is not finite"))
            << import.log;
    }
}

TEST(GltfImport, leaves_out_a_mesh_beyond_the_largest_position) {
    for (const double x : {99'998.0, 100'001.0}) {
        TriangleFile file = two_meshes();
        file.json["nodes"][1]["translation"] = {x, 0, 0};
        const Import import = import_bytes(file.gltf());
        ASSERT_TRUE(import.ok()) << import.error();
        EXPECT_EQ(import.mesh().indices.size(), x < 1e5 ? 6U : 3U);
    }
}

TEST(GltfImport, drops_faces_without_area_and_counts_them) {
    TriangleFile file;
    std::string indices;
    append_bytes<std::uint16_t>(indices, {0, 1, 2, 0, 0, 1, 1, 2, 2});
    file.primitive()["indices"] = file.add_accessor(indices, 5123, 9, "SCALAR");
    const Import import = import_bytes(file.gltf());
    ASSERT_TRUE(import.ok());
    EXPECT_EQ(import.mesh().indices.size(), 3U);
    EXPECT_TRUE(contains(import.log, "2 faces without area are left out")) << import.log;
}

TEST(GltfImport, only_warns_of_extensions_that_a_file_merely_uses) {
    TriangleFile file;
    file.json["extensionsUsed"] = {"EXT_strange"};
    const Import import = import_bytes(file.gltf());
    EXPECT_TRUE(import.ok());
    EXPECT_TRUE(contains(import.log, "the extension EXT_strange is ignored")) << import.log;
}

// EXPERIENCE G15: physics is not read from models, whatever its shape: each is the same scenery, and
// a line says what was left out.
TEST(GltfImport, reads_every_shape_of_the_physics_extensions_alike_as_scenery) {
    struct Shape {
        const char* extension;
        const char* shapes;  // the document's
        const char* body;    // the node's
    };
    for (const Shape& shape :
         {Shape{"KHR_rigid_bodies",  // 2024
                R"({"shapes": [{"type": "box", "box": {"size": [1, 1, 1]}}]})",
                R"({"motion": {"mass": 2}, "collider": {"shape": 0}})"},
          Shape{"KHR_physics_rigid_bodies",  // 2025
                R"({"shapes": [{"type": "sphere", "sphere": {"radius": 0.5}}]})",
                R"({"motion": {"mass": 2}, "collider": {"geometry": {"shape": 0}}})"},
          Shape{"KHR_physics_rigid_bodies",  // 2026
                R"({"physicsMaterials": [{"staticFriction": 0.5}]})",
                R"({"motion": {"isKinematic": true}, "collider": {"geometry": {"node": 0}}})"},
          Shape{"OMI_physics_body",
                R"({"shapes": [{"type": "hull", "mesh": 0}]})",
                R"({"motion": {"type": "dynamic", "mass": 2}, "collider": {"shape": 0}})"}}) {
        TriangleFile file;
        file.json["extensionsUsed"] = {shape.extension};
        file.json["extensions"][shape.extension] = Json::parse(shape.shapes);
        file.json["nodes"][0]["extensions"][shape.extension] = Json::parse(shape.body);
        const Import import = import_bytes(file.gltf());
        ASSERT_TRUE(import.ok()) << shape.extension << ": " << import.error();
        EXPECT_EQ(import.mesh().vertices.size(), 3U);
        EXPECT_EQ(import.mesh().indices.size(), 3U);
        EXPECT_TRUE(
            contains(import.log, fmt::format("the extension {} is ignored", shape.extension)))
            << import.log;
        file.json["extensionsRequired"] = {shape.extension};
        EXPECT_FALSE(import_bytes(file.gltf()).ok()) << "it cannot be done without";
    }
}

TEST(GltfImport, opens_buffers_with_escaped_spaces_and_letters_beyond_ascii) {
    for (const auto& [uri, name] : {std::pair{"My%20File.bin", "My File.bin"},
                                    std::pair{"Gr%C3%BCn.bin", "Gr\xC3\xBCn.bin"},
                                    std::pair{"gr\xC3\xBCn.bin", "gr\xC3\xBCn.bin"},
                                    std::pair{"sub/./a.bin", "sub/a.bin"},
                                    std::pair{"a%2Bb.bin", "a+b.bin"}}) {
        TriangleFile file;
        const TempFolder folder;
        folder.write(name, file.bytes);
        file.json["buffers"][0]["uri"] = uri;
        const Import import(folder.write("m.gltf", file.json.dump()));
        EXPECT_TRUE(import.ok()) << uri << ": " << import.error();
    }
}

TEST(GltfImport, follows_links_that_stay_inside_the_root) {
    TriangleFile file;
    const TempFolder folder;
    folder.write("shared/a.bin", file.bytes);
    file.json["buffers"][0]["uri"] = "a.bin";
    const fs::path model = folder.write("models/m.gltf", file.json.dump());
    fs::create_symlink("../shared/a.bin", folder.path() / "models/a.bin");
    EXPECT_TRUE(Import(model, folder.path()).ok());
    const Import confined(model, folder.path() / "models");
    EXPECT_TRUE(contains(confined.error(),
                         "buffers[0].uri: \"a.bin\" leads out of the root folder through a link"))
        << confined.error();
}

TEST(GltfImport, accepts_a_byte_order_mark) {
    EXPECT_TRUE(import_bytes("\xEF\xBB\xBF" + TriangleFile{}.gltf()).ok());
}

TEST(GltfImport, ignores_bytes_after_a_glb_with_a_warning) {
    const Import import = import_bytes(TriangleFile{}.glb() + "tail", "m.glb");
    EXPECT_TRUE(import.ok());
    EXPECT_TRUE(contains(import.log, "4 bytes after the GLB's end are ignored")) << import.log;
}

}  // namespace
}  // namespace plumbline::assets::test
